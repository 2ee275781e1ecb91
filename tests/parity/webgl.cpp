// Every function of the manifest as GLSL ES 3.00 in WebGL 2, in a headless Chromium, against C++ float.

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "compare.hpp"
#include "scratch_folder.hpp"
#include "start.hpp"
#include "support/error.hpp"
#include "support/files.hpp"

namespace parity {
namespace {

struct Options {
    GlslFolder glsl{AIRLIGHT_PARITY_GLSL_DIR};
    double share = 1.0 / 16;
};

const char* const letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

std::string base64(const std::vector<float>& floats) {
    std::vector<unsigned char> bytes(floats.size() * sizeof(float));
    if (!bytes.empty()) {
        std::memcpy(bytes.data(), floats.data(), bytes.size());
    }
    std::string out;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t n = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            group = group << 8U | (k < n ? bytes[i + k] : 0U);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            out += k <= n ? letters[group >> (18 - 6 * k) & 63U] : '=';
        }
    }
    return out;
}

std::vector<float> floats_of(const std::string& text) {
    std::string bytes;
    std::uint32_t group = 0;
    int bits = 0;
    for (const char c : text) {
        const char* const at = std::strchr(letters, c);
        if (at == nullptr || c == '\0') {
            break;  // padding
        }
        group = group << 6U | static_cast<std::uint32_t>(at - letters);
        bits += 6;
        if (bits >= 8) {
            bits -= 8;
            bytes += static_cast<char>(group >> static_cast<unsigned>(bits) & 255U);
        }
    }
    std::vector<float> out(bytes.size() / sizeof(float));
    if (!out.empty()) {
        std::memcpy(out.data(), bytes.data(), out.size() * sizeof(float));
    }
    return out;
}

/// The first browser of the machine, or "".
std::string find_browser() {
    const char* const named = std::getenv("AIRLIGHT_CHROMIUM");
    if (named != nullptr && *named != '\0') {
        return named;
    }
    const char* const path = std::getenv("PATH");
    std::istringstream folders(path != nullptr ? path : "");
    std::vector<std::string> all;
    for (std::string folder; std::getline(folders, folder, ':');) {
        all.push_back(folder);
    }
    for (const char* const name : {"chromium", "chromium-browser", "google-chrome"}) {
        for (const std::string& folder : all) {
            const std::filesystem::path file = std::filesystem::path(folder) / name;
            if (::access(file.c_str(), X_OK) == 0) {
                return file.string();
            }
        }
    }
    return "";
}

/// `text` as one word of a shell command.
std::string quoted(const std::string& text) {
    std::string out = "'";
    for (const char c : text) {
        out += c == '\'' ? std::string("'\\''") : std::string(1, c);
    }
    return out + "'";
}

std::string end_of_log(const std::filesystem::path& folder) {
    const std::string log = support::read_file(folder / "log");
    return log.substr(log.size() > 500 ? log.size() - 500 : 0);
}

/// Opens the page and returns the document after its script has run.
std::string dumped_page(const std::string& browser, const std::filesystem::path& folder) {
    const std::string command = "timeout 900 " + quoted(browser) +
                                " --headless --no-sandbox --disable-dev-shm-usage --use-angle=swiftshader"
                                " --enable-unsafe-swiftshader --user-data-dir=" +
                                quoted((folder / "profile").string()) + " --dump-dom " +
                                quoted("file://" + (folder / "page.html").string()) + " 2>" +
                                quoted((folder / "log").string());
    std::FILE* const pipe = ::popen(command.c_str(), "r");
    if (pipe == nullptr) {
        throw support::Error("cannot start '" + browser + "'");
    }
    std::string out;
    std::array<char, 1U << 16U> buffer{};
    for (std::size_t n = 0; (n = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) {
        out.append(buffer.data(), n);
    }
    const int status = ::pclose(pipe);
    if (status != 0) {
        throw support::Error("'" + browser + "' ended with status " +
                             std::to_string(WIFEXITED(status) ? WEXITSTATUS(status) : status) +
                             "; the end of its log: " + end_of_log(folder));
    }
    return out;
}

/// Of jobs in one page. Each job brings its file's whole text, and a string in V8 ends at 512 MiB.
constexpr std::size_t page_bytes = std::size_t{64} << 20U;

struct Job {
    std::string text;
    std::string file;
    std::vector<float> inputs;
    std::size_t rows = 0;
    std::size_t per_result = 0;
};

/// One job in JSON. A page holds them in a script, which a "</" would end.
std::string written(const Job& job) {
    const nlohmann::json fields{{"text", job.text},
                                {"inputs", base64(job.inputs)},
                                {"rows", job.rows},
                                {"per_result", job.per_result}};
    std::string json = fields.dump();
    for (std::size_t at = json.find("</"); at != std::string::npos; at = json.find("</", at)) {
        json.replace(at, 2, "<\\/");
    }
    return json;
}

/// The floats of each job by its number, or what the browser said instead; the driver once.
struct Answers {
    std::map<std::size_t, std::vector<float>> floats;
    std::map<std::size_t, std::string> errors;
    bool named_driver = false;
};

/// Takes one line of a page's document, whose jobs count from `first`. True for the last line.
bool take_line(const std::string& line, const std::string& browser, std::size_t first, Answers& answers) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    std::size_t number = 0;
    if (kind == "DRIVER" && !answers.named_driver) {
        std::cout << "driver: " << line.substr(7) << "\n";
        answers.named_driver = true;
    } else if (kind == "NOGL") {
        throw support::Error("'" + browser + "' has no WebGL 2 with float render targets");
    } else if (kind == "RESULT" && words >> number) {
        std::string text;
        words >> text;
        answers.floats[first + number] = floats_of(text);
    } else if (kind == "ERROR" && words >> number) {
        answers.errors[first + number] = line;
    }
    return kind == "DONE";
}

/// Runs the jobs `first` to `end`, written in `list`, in a browser of their own.
void run_page(const std::string& browser, const std::string& list, std::size_t first, std::size_t end,
              Answers& answers) {
    std::string page = support::read_file(AIRLIGHT_PARITY_WEBGL_PAGE);
    const std::string mark = "/*JOBS*/[]";
    page.replace(page.find(mark), mark.size(), "[" + list + "]");

    const ScratchFolder scratch("webgl");
    support::write_file(scratch.path / "page.html", page);
    std::istringstream document(dumped_page(browser, scratch.path));

    bool done = false;
    for (std::string line; std::getline(document, line);) {
        const std::size_t keyword = line.find_last_of('>');  // the first line stands behind <pre ...>
        if (keyword != std::string::npos && line.compare(0, 5, "ERROR") != 0) {
            line = line.substr(keyword + 1);
        }
        done = take_line(line, browser, first, answers) || done;
    }
    if (!done) {
        throw support::Error("the page of shaders " + std::to_string(first) + " to " +
                             std::to_string(end - 1) + " did not finish in '" + browser +
                             "'; the end of its log: " + end_of_log(scratch.path));
    }
    std::cout << end << " shaders done\n" << std::flush;
}

int run(const Options& options) {
    const Manifest manifest = read_manifest(options.glsl.folder / "manifest.json");
    const std::string browser = find_browser();
    if (browser.empty()) {
        const std::string message = "no Chromium on this machine (Debian: apt-get install chromium)";
        const char* const required = std::getenv("AIRLIGHT_REQUIRE_WEBGL");
        if (required != nullptr && *required != '\0' && std::strcmp(required, "0") != 0) {
            throw support::Error(message);
        }
        std::cout << "skipped: " << message << "\n";
        return skipped;
    }

    Settings settings;
    settings.webgl = true;
    settings.software_gl = false;  // no `precise` in ES 3.00: the specification's bounds
    settings.share = options.share;
    const auto each_row = [&](const Runner& runner, std::vector<RowResult>* results) {
        for (const Function& function : manifest.functions) {
            // Once the browser reads airlight.glsl whole; for all functions that is half of its time.
            GlslFolder glsl = options.glsl;
            glsl.one_file = &function == &manifest.functions.front();
            for (const Row& row : all_rows()) {
                if (row.function == function.name) {
                    const RowResult result = run_row(row, function, manifest, glsl, settings, runner);
                    if (results != nullptr) {
                        results->push_back(result);
                    }
                    break;
                }
            }
        }
    };

    // Once to collect the shaders, which run in a few pages, and once more to compare.
    std::vector<Job> jobs;
    each_row(
        [&](const std::string& text, const std::string& file, const std::vector<float>& inputs,
            std::size_t rows, std::size_t per_result) {
            jobs.push_back({text, file, inputs, rows, per_result});
            return std::vector<float>(rows * per_result);
        },
        nullptr);
    std::cout << jobs.size() << " shaders in " << browser << "\n";
    Answers answers;
    std::string list;
    std::size_t first = 0;
    for (std::size_t i = 0; i < jobs.size(); ++i) {
        list += (list.empty() ? "" : ",") + written(jobs[i]);
        if (list.size() > page_bytes || i + 1 == jobs.size()) {
            run_page(browser, list, first, i + 1, answers);
            list.clear();
            first = i + 1;
        }
    }

    std::size_t next = 0;
    std::vector<RowResult> results;
    each_row(
        [&](const std::string&, const std::string& file, const std::vector<float>&, std::size_t rows,
            std::size_t per_result) {
            const std::size_t number = next++;
            if (answers.errors.count(number) != 0) {
                throw support::Error(file + ": " + answers.errors[number]);
            }
            const std::vector<float>& padded = answers.floats[number];
            const std::size_t stride = (per_result + 3) / 4 * 4;
            if (padded.size() != rows * stride) {
                throw support::Error(file + ": the page gave " + std::to_string(padded.size()) +
                                     " numbers, not " + std::to_string(rows * stride));
            }
            std::vector<float> out;
            for (std::size_t i = 0; i < rows; ++i) {
                const auto begin = padded.begin() + static_cast<std::ptrdiff_t>(i * stride);
                out.insert(out.end(), begin, begin + static_cast<std::ptrdiff_t>(per_result));
            }
            return out;
        },
        &results);

    std::size_t inputs = 0;
    std::size_t failures = 0;
    for (const RowResult& result : results) {
        std::cout << describe(result, manifest);
        inputs += result.inputs;
        failures += result.failures.size();
    }
    std::cout << "\n"
              << results.size() << " functions, " << inputs << " inputs, " << failures << " failures\n";
    return failures == 0 && results.size() == manifest.functions.size() ? 0 : 1;
}

}  // namespace
}  // namespace parity

int main(int argc, char** argv) {
    parity::Options options;
    CLI::App app(
        "Compares every function of the generated GLSL, as GLSL ES 3.00 in WebGL 2, with the C++ headers.",
        "parity_webgl");
    parity::add_glsl(app, options.glsl);
    parity::add_share(app, options.share, "0.0625");
    app.footer(
        "Environment: AIRLIGHT_CHROMIUM         the browser (default: chromium, chromium-browser, "
        "google-chrome)\n"
        "             AIRLIGHT_REQUIRE_WEBGL=1  a machine without one is a failure, not a skip\n"
        "Exit status: 0 all pass, 1 something differs, 2 wrong use, 77 no browser on this machine.");
    return parity::guarded_main(app, argc, argv, [&] { return parity::run(options); });
}
