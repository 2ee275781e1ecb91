// glslgen: writes the GLSL of airlight from its C++ headers. README.md says what it accepts.

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>

#include "diff.hpp"
#include "files.hpp"
#include "generate.hpp"
#include "writer.hpp"

namespace {

namespace fs = std::filesystem;

struct Options {
    std::vector<std::string> include = {"include"};
    std::string output = "glsl";
    std::string header;
    std::vector<std::string> system_folders;
    bool check = false;
    bool to_stdout = false;
};

void print(const std::vector<glslgen::Refusal>& refusals) {
    for (const glslgen::Refusal& refusal : refusals) {
        std::cerr << refusal.file << ':' << refusal.line << ": " << refusal.reason << '\n';
    }
}

/// Generated GLSL files in the output folder that no header makes any more.
std::vector<std::string> stale_files(const Options& options, const glslgen::Generated& generated) {
    std::vector<std::string> stale;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(options.output + "/airlight", error)) {
        const std::string name = "airlight/" + entry.path().filename().string();
        const std::optional<std::string> text = glslgen::read_text(entry.path().string());
        if (entry.path().extension() == ".glsl" && !generated.files.count(name) && text &&
            text->rfind(glslgen::generated_mark, 0) == 0) {
            stale.push_back(name);
        }
    }
    return stale;
}

int check(const Options& options, const glslgen::Generated& generated) {
    bool differs = false;
    for (const auto& [name, text] : generated.files) {
        const std::string path = options.output + "/" + name;
        const std::string before = glslgen::read_text(path).value_or("");
        if (before == text) {
            continue;
        }
        differs = true;
        const auto source = generated.sources.find(name);
        std::cout << glslgen::unified_diff(before, text, path, path + " (generated)");
        std::cerr << path << " is not what "
                  << (source == generated.sources.end()
                          ? "the headers of " + options.include.front() + "/airlight make"
                          : source->second + " makes")
                  << ": edit the header and run glslgen\n";
    }
    for (const std::string& name : stale_files(options, generated)) {
        differs = true;
        std::cerr << options.output << '/' << name
                  << " comes from a header that is gone: run glslgen to delete it\n";
    }
    return differs ? 1 : 0;
}

int write(const Options& options, const glslgen::Generated& generated) {
    std::size_t written = 0;
    for (const auto& [name, text] : generated.files) {
        written += glslgen::write_text(options.output + "/" + name, text) ? 1 : 0;
    }
    const std::vector<std::string> stale = stale_files(options, generated);
    for (const std::string& name : stale) {
        fs::remove(options.output + "/" + name);
    }
    std::cout << options.output << ": " << generated.files.size() << " files, " << written << " changed, "
              << stale.size() << " deleted\n";
    return 0;
}

int run(const Options& options) {
    glslgen::ReadOptions read;
    read.root = options.header.empty() ? options.include.front() + "/airlight/airlight.hpp" : options.header;
    read.include_folders = options.include;
    read.system_folders = options.system_folders;
    const glslgen::Generated generated = glslgen::generate(read);
    if (!generated.refusals.empty()) {
        print(generated.refusals);
        return 1;
    }
    if (options.to_stdout) {
        std::cout << generated.root_file;
        return std::cout.flush() ? 0 : 1;
    }
    return options.check ? check(options, generated) : write(options, generated);
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{
        "Writes the GLSL of airlight from its C++ headers: one file per header, airlight.glsl with "
        "everything, "
        "and manifest.json. What is outside the translatable subset is refused as file:line: reason.",
        "glslgen"};
    Options options;
    app.add_option(
           "--include", options.include,
           "folder that holds airlight/airlight.hpp; further ones hold headers that stand on airlight")
        ->capture_default_str();
    CLI::Option* output =
        app.add_option("--output", options.output, "folder to write to")->capture_default_str();
    app.add_option("--system-include", options.system_folders, "further folders to find GLM in");
    CLI::Option* header =
        app.add_option("--header", options.header,
                       "translate this header: alone with --stdout, with all it includes with --output");
    CLI::Option* to_stdout =
        app.add_flag("--stdout", options.to_stdout, "print the header's GLSL")->needs(header);
    app.add_flag("--check", options.check, "write nothing; print a diff and exit with 1 if a file differs")
        ->excludes(to_stdout);
    // glsl/ is the library's: a header of its own goes elsewhere.
    app.callback([&] {
        if (header->count() > 0 && to_stdout->count() + output->count() == 0) {
            throw CLI::RequiresError("--header", "--stdout or --output");
        }
    });
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    try {
        return run(options);
    } catch (const std::exception& error) {
        std::cerr << "glslgen: " << error.what() << '\n';
        return 1;
    }
}
