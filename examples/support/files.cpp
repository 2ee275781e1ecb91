#include "support/files.hpp"

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <memory>
#include <system_error>

#include "support/error.hpp"

namespace support {
namespace {

struct CloseFile {
    void operator()(std::FILE* file) const {
        std::fclose(file);
    }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

[[noreturn]] void fail(const std::string& what, const std::filesystem::path& path, int error,
                       const char* advice) {
    throw Error(what + " '" + path.string() + "': " + std::strerror(error) + "; " + advice);
}

/// A name that no other process uses, nor another thread of this one.
std::filesystem::path temporary_beside(const std::filesystem::path& path) {
    static std::atomic<int> count{0};
    return path.string() + ".tmp-" + std::to_string(::getpid()) + "-" + std::to_string(count++);
}

}  // namespace

std::string read_file(const std::filesystem::path& path) {
    const File file(std::fopen(path.c_str(), "rb"));
    if (file == nullptr) {
        fail("cannot read", path, errno, "check the path and its permissions");
    }
    std::string bytes;
    char block[65536];
    for (;;) {
        const std::size_t count = std::fread(block, 1, sizeof block, file.get());
        bytes.append(block, count);
        if (count < sizeof block) {
            break;
        }
    }
    if (std::ferror(file.get()) != 0) {
        fail("cannot read", path, errno, "check that it is a file and its disk is sound");
    }
    return bytes;
}

void write_file(const std::filesystem::path& path, const std::string& bytes) {
    const std::filesystem::path temporary = temporary_beside(path);
    const char* const advice = "choose a folder that exists, can be written and has space";
    File file(std::fopen(temporary.c_str(), "wb"));
    if (file == nullptr) {
        fail("cannot write", path, errno, advice);
    }
    bool written = std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size();
    int error = errno;
    // Closing flushes, so a full disk may only show here.
    if (std::fclose(file.release()) != 0 && written) {
        written = false;
        error = errno;
    }
    if (written && std::rename(temporary.c_str(), path.c_str()) != 0) {
        written = false;
        error = errno;
    }
    if (!written) {
        std::remove(temporary.c_str());
        fail("cannot write", path, error, advice);
    }
}

void print_or_write(const std::filesystem::path& path, const std::string& text) {
    if (path.empty()) {
        std::cout << text;
    } else {
        write_file(path, text);
    }
}

void make_writable_directory(const std::filesystem::path& path) {
    std::error_code error;
    std::filesystem::create_directories(path, error);
    if (error) {
        throw Error("cannot make the folder '" + path.string() + "': " + error.message() +
                    "; choose another output folder");
    }
    const std::filesystem::path probe = temporary_beside(path / "probe");
    const File file(std::fopen(probe.c_str(), "wb"));
    if (file == nullptr) {
        fail("cannot write into", path, errno, "choose another output folder");
    }
    std::remove(probe.c_str());
}

void make_writable_directory_of(const std::filesystem::path& file) {
    make_writable_directory(file.has_parent_path() ? file.parent_path() : ".");
}

}  // namespace support
