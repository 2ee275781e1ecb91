// study: what each method costs and how wrong it is. README.md says what it writes.

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>

#include "pages.hpp"
#include "reports.hpp"
#include "support/error.hpp"
#include "support/files.hpp"
#include "support/machine.hpp"
#include "support/progress.hpp"

namespace {

namespace fs = std::filesystem;
using study::Csv;
using study::Judged;

struct Options {
    bool all = false;
    bool quick = false;
    bool errors = false;
    bool cost = false;
    bool pages = false;
    bool check_pages = false;
    int rounds = 15;
    fs::path results = STUDY_RESULTS;
};

void write(const Options& options, const std::string& name, const Csv& csv) {
    study::write_csv(options.results / name, csv);
    std::cout << (options.results / name).string() << ": " << csv.rows.size() << " rows\n";
}

Judged with_truth(const std::string& what, std::vector<study::View> views) {
    support::ProgressBar bar("truth of " + what);
    return study::judged(std::move(views), [&](std::size_t done, std::size_t all) { bar(done, all); });
}

void write_errors(const Options& options) {
    const Judged suite = with_truth("the suite", study::suite());
    const Judged random = with_truth("random rays", study::random_views(1500));
    write(options, "errors.csv", study::error_table(study::settings(), suite, random));
    write(options, "views.csv", study::view_table(suite));

    std::vector<study::View> many = study::random_views(6000);
    many.insert(many.end(), suite.views.begin(), suite.views.end());
    const Judged all = with_truth("more random rays", std::move(many));
    write(options, "classes.csv", study::class_table(study::settings(), all));

    support::ProgressBar bar("quick");
    write(options, "quick.csv",
          study::quick_table(study::settings(), [&](std::size_t done, std::size_t of) { bar(done, of); }));
}

void write_cost(const Options& options) {
    support::ProgressBar bar("cost");
    const std::vector<study::Cost> costs = study::costs(
        study::settings(), options.rounds, [&](std::size_t done, std::size_t all) { bar(done, all); });
    Csv csv = study::cost_table(study::settings(), costs);
    csv.comments = {
        "Means over the suite's rays. Time in float on one thread, median of " +
            std::to_string(options.rounds) +
            " rounds that take every setting in turn; ratio is to leenman 16x6 in the same round.",
        std::string("Machine: ") + support::processor_name() + "; compiler: " STUDY_COMPILER};
    write(options, "cost.csv", csv);
}

int check_quick(const Options& options) {
    support::ProgressBar bar("quick");
    const Csv fresh =
        study::quick_table(study::settings(), [&](std::size_t done, std::size_t all) { bar(done, all); });
    const std::vector<std::string> found =
        study::differences(fresh, study::read_csv(options.results / "quick.csv"));
    for (const std::string& line : found) {
        std::cerr << line << '\n';
    }
    if (!found.empty()) {
        std::cerr << "study: errors are not the recorded ones. If that is meant, run study/run and commit "
                     "what it writes.\n";
        return 1;
    }
    std::cout << fresh.rows.size() << " settings give their recorded errors\n";
    return 0;
}

/// The pages with today's figures, by path.
std::map<fs::path, std::string> pages(const Options& options) {
    const fs::path root = STUDY_ROOT;
    const auto blocks =
        study::blocks(study::read_tables(options.results, root / "bench/shader_cost/results.csv"));
    std::map<fs::path, std::string> out;
    for (const fs::path& path : {root / "docs/trade.md", root / "README.md"}) {
        out[path] = study::filled(support::read_file(path), blocks);
    }
    return out;
}

int write_pages(const Options& options) {
    for (const auto& [path, text] : pages(options)) {
        support::write_file(path, text);
        std::cout << path.string() << '\n';
    }
    return 0;
}

int check_pages(const Options& options) {
    int status = 0;
    for (const auto& [path, text] : pages(options)) {
        if (support::read_file(path) != text) {
            std::cerr << path.string() << " shows other figures than the tables hold; run study --pages\n";
            status = 1;
        }
    }
    return status;
}

int run(const Options& options) {
    if (options.quick) {
        return check_quick(options);
    }
    if (options.pages) {
        return write_pages(options);
    }
    if (options.check_pages) {
        return check_pages(options);
    }
    support::make_writable_directory(options.results);
    if (options.all || options.errors) {
        write_errors(options);
    }
    if (options.all || options.cost) {
        write_cost(options);
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{
        "Measures what each method of single scattering costs and how wrong it is, airlight's and others', "
        "over a suite of views and random rays.",
        "study"};
    Options options;
    CLI::Option_group* task = app.add_option_group("task", "one of");
    task->add_flag("--all", options.all, "measure everything and write all tables");
    task->add_flag("--errors", options.errors, "measure errors only");
    task->add_flag("--cost", options.cost, "measure cost only");
    task->add_flag("--quick", options.quick,
                   "check that every setting gives its recorded error on a tenth of the suite");
    task->add_flag("--pages", options.pages, "fill the tables' figures into docs/trade.md and README.md");
    task->add_flag("--check-pages", options.check_pages,
                   "fail when the pages show other figures than the tables");
    task->require_option(1);
    app.add_option("--rounds", options.rounds, "rounds of the time measurement")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    app.add_option("--results", options.results, "folder of the tables")->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    try {
        return run(options);
    } catch (const std::exception& error) {
        std::cerr << "study: " << error.what() << '\n';
        return 1;
    }
}
