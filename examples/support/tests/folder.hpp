#pragma once

// What tests of files need.

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

#include "support/error.hpp"

/// A folder that is there for one test case.
class Folder {
  public:
    Folder() : path(std::filesystem::temp_directory_path() / ("airlight_support_test_" + unique())) {
        std::filesystem::create_directories(path);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder() {
        std::filesystem::remove_all(path);
    }

    std::size_t files() const {
        std::size_t count = 0;
        for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(path)) {
            ++count;
        }
        return count;
    }

    const std::filesystem::path path;

  private:
    static std::string unique() {
        static std::atomic<int> count{0};
        // The address differs between runs, the count within one.
        return std::to_string(
                   reinterpret_cast<std::uintptr_t>(&count) ^
                   std::uintptr_t(std::filesystem::file_time_type::clock::now().time_since_epoch().count())) +
               "_" + std::to_string(count++);
    }
};

/// What `action` says when it throws Error; "" when it does not.
template <typename Action>
std::string complaint(const Action& action) {
    try {
        action();
    } catch (const support::Error& error) {
        return error.what();
    }
    return "";
}
