#include "files.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>

#include "refusal.hpp"

namespace glslgen {

namespace fs = std::filesystem;

std::optional<std::string> read_text(const std::string& path) {
    std::ifstream stream(path, std::ios::binary);
    if (!stream) {
        return std::nullopt;
    }
    return std::string(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
}

bool write_text(const std::string& path, const std::string& text) {
    if (read_text(path) == text) {
        return false;
    }
    std::error_code error;
    fs::create_directories(fs::path(path).parent_path(), error);
    const std::string temporary = path + ".part";
    {
        std::ofstream stream(temporary, std::ios::binary | std::ios::trunc);
        stream << text;
        stream.close();
        if (!stream) {
            fs::remove(temporary, error);
            throw Failure("cannot write " + path +
                          ": check that the folder exists and is writable, and the disk not full");
        }
    }
    fs::rename(temporary, path, error);
    if (error) {
        const std::string why = error.message();
        fs::remove(temporary, error);
        throw Failure("cannot write " + path + ": " + why);
    }
    return true;
}

}  // namespace glslgen
