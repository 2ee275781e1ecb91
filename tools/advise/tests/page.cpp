// advise_page: the outputs of advise that a page shows. A block begins with its command, as in
//
//     $ advise --preset earth ...
//
// and holds what the command prints, up to the closing fence.

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <sstream>

#include "support/error.hpp"
#include "support/files.hpp"

namespace {

const std::string prompt = "$ advise ";
const std::string fence = "```\n";

std::string output_of(const std::string& command) {
    std::FILE* const pipe = ::popen(command.c_str(), "r");
    if (pipe == nullptr) {
        throw support::Error("cannot run '" + command + "'");
    }
    std::string out;
    char block[4096];
    for (std::size_t count = 0; (count = std::fread(block, 1, sizeof block, pipe)) > 0;) {
        out.append(block, count);
    }
    if (::pclose(pipe) != 0) {
        throw support::Error("'" + command + "' failed; run it by hand");
    }
    return out;
}

/// The page with every command's output of today; throws where there is no command.
std::string refreshed(const std::string& text, const std::string& program) {
    std::string out;
    std::size_t at = 0;
    for (std::size_t found = 0; (found = text.find("\n" + prompt, at)) != std::string::npos;) {
        const std::size_t line_end = text.find('\n', found + 1) + 1;
        const std::size_t end = text.find(fence, line_end);
        if (end == std::string::npos) {
            throw support::Error("a block that begins with '$ advise' has no closing fence");
        }
        const std::size_t arguments = found + 1 + prompt.size();
        out += text.substr(at, line_end - at) +
               output_of("'" + program + "' " + text.substr(arguments, line_end - 1 - arguments));
        at = end;
    }
    if (at == 0) {
        throw support::Error("the page shows no command; write a line '$ advise ...' in a block");
    }
    return out + text.substr(at);
}

/// The same word, or numbers that two digits' rounding may have moved apart: 0.10 and 0.11.
bool alike(const std::string& a, const std::string& b) {
    if (a == b) {
        return true;
    }
    try {
        std::size_t of_a = 0;
        std::size_t of_b = 0;
        const double x = std::stod(a, &of_a);
        const double y = std::stod(b, &of_b);
        return a.substr(of_a) == b.substr(of_b) &&
               std::abs(x - y) <= 0.101 * std::max(std::abs(x), std::abs(y));
    } catch (const std::exception&) {
        return false;
    }
}

int check(const std::string& page, const std::string& fresh) {
    std::istringstream shown(page);
    std::istringstream measured(fresh);
    std::string a;
    std::string b;
    for (;;) {
        const bool more = static_cast<bool>(shown >> a);
        if (more != static_cast<bool>(measured >> b) || (more && !alike(a, b))) {
            std::cerr << "the page shows '" << a << "' where advise prints '" << b
                      << "': run advise_page --write\n";
            return 1;
        }
        if (!more) {
            return 0;
        }
    }
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"Keeps the outputs of advise that a page shows up to date.", "advise_page"};
    std::string program;
    std::string checked;
    std::string written;
    app.add_option("--advise", program, "the program")->required();
    CLI::Option_group* task = app.add_option_group("task", "one of");
    task->add_option("--check", checked, "fail when the page shows another output");
    task->add_option("--write", written, "put today's outputs into the page");
    task->require_option(1);
    CLI11_PARSE(app, argc, argv);
    try {
        const std::string path = written.empty() ? checked : written;
        const std::string page = support::read_file(path);
        const std::string fresh = refreshed(page, program);
        if (written.empty()) {
            return check(page, fresh);
        }
        support::write_file(path, fresh);
        return 0;
    } catch (const std::exception& error) {
        std::cerr << "advise_page: " << error.what() << "\n";
        return 1;
    }
}
