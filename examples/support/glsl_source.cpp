#include "support/glsl_source.hpp"

#include <algorithm>
#include <sstream>

#include "support/error.hpp"
#include "support/files.hpp"

namespace support {
namespace {

/// The name in `#include "name"`, or "" when the line is no include.
std::string included_name(const std::string& line) {
    const std::size_t hash = line.find_first_not_of(" \t");
    if (hash == std::string::npos || line.compare(hash, 8, "#include") != 0) {
        return "";
    }
    const std::size_t begin = line.find('"', hash);
    const std::size_t end = begin == std::string::npos ? begin : line.find('"', begin + 1);
    if (end == std::string::npos || end == begin + 1) {
        throw Error("not an include that is understood: " + line + "; write #include \"file.glsl\"");
    }
    return line.substr(begin + 1, end - begin - 1);
}

class Expander {
  public:
    explicit Expander(const std::vector<std::filesystem::path>& folders) : folders_(folders) {}

    void add(const std::string& text, const std::string& name) {
        const std::size_t number = result.names.size();
        result.names.push_back(name);
        std::istringstream lines(text);
        std::string line;
        for (int line_number = 1; std::getline(lines, line); ++line_number) {
            const std::string included = included_name(line);
            if (included.empty()) {
                result.text += line + "\n";
                continue;
            }
            const auto& names = result.names;
            if (std::find(names.begin(), names.end(), included) == names.end()) {
                const std::size_t next = names.size();
                result.text += "#line 1 " + std::to_string(next) + "\n";
                add(read_file(find(included, name)), included);
            }
            result.text += "#line " + std::to_string(line_number + 1) + " " + std::to_string(number) + "\n";
        }
    }

    ExpandedGlsl result;

  private:
    std::filesystem::path find(const std::string& included, const std::string& by) const {
        for (const std::filesystem::path& folder : folders_) {
            if (std::filesystem::exists(folder / included)) {
                return folder / included;
            }
        }
        throw Error("'" + by + "' includes \"" + included + "\", which is in none of its folders; " +
                    "generate the GLSL or give the folder that holds it");
    }

    const std::vector<std::filesystem::path>& folders_;
};

}  // namespace

ExpandedGlsl expand_includes(const std::filesystem::path& file,
                             const std::vector<std::filesystem::path>& folders) {
    return expand_includes(read_file(file), file.filename().string(), folders);
}

ExpandedGlsl expand_includes(const std::string& text, const std::string& name,
                             const std::vector<std::filesystem::path>& folders) {
    Expander expander(folders);
    expander.add(text, name);
    return expander.result;
}

}  // namespace support
