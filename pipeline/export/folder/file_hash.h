#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace pipeline {

// SHA-256 of a file's bytes, 64 hexadecimal digits; nothing when it cannot be read.
std::optional<std::string> sha256(const std::filesystem::path& file);
// The same of bytes in memory.
std::string sha256Of(std::string_view bytes);

}  // namespace pipeline
