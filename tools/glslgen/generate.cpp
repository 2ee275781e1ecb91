#include "generate.hpp"

#include "translate.hpp"
#include "writer.hpp"

namespace glslgen {

Generated generate(const ReadOptions& options) {
    Generated result;
    const ReadResult read = read_headers(options);
    result.refusals = read.complaints;
    if (!result.refusals.empty()) {
        return result;
    }
    Program program;
    std::vector<Translation> translations;
    for (const Header& header : read.headers) {
        translations.push_back(translate(header, program, result.refusals));
    }
    if (!result.refusals.empty()) {
        return result;
    }
    result.files = generated_files(translations, program);
    for (const Translation& translation : translations) {
        result.sources[file_of(translation.stem)] = translation.shown;
    }
    result.root_file = single_file(translations.back(), translations, program);
    return result;
}

}  // namespace glslgen
