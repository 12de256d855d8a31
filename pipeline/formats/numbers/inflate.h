#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace pipeline {

// The first `size` bytes that a zlib stream holds (RFC 1950 and 1951), or nothing where it is damaged or shorter. Its check
// sum is not read: who packs it into a file has one of his own.
std::optional<std::string> inflated(std::string_view stream, std::size_t size);

}  // namespace pipeline
