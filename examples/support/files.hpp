#pragma once

#include <filesystem>
#include <string>

namespace support {

/// The whole file. Throws Error when it cannot be read.
std::string read_file(const std::filesystem::path& path);

/// Writes a temporary beside `path`, then renames it, so that `path` is either whole or untouched.
/// Throws Error when it cannot be written; the temporary is then gone.
void write_file(const std::filesystem::path& path, const std::string& bytes);

/// To standard output where `path` is empty, else by write_file().
void print_or_write(const std::filesystem::path& path, const std::string& text);

/// Makes the folder and its parents where they are missing, and tries that a file can be made in it, so
/// that a long run fails before its work and not after. Throws Error when not.
void make_writable_directory(const std::filesystem::path& path);
/// The same for the folder that a file is to be in.
void make_writable_directory_of(const std::filesystem::path& file);

}  // namespace support
