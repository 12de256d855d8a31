#pragma once
#include <string>
#include <string_view>

namespace pipeline {

// The bytes as a gzip file (RFC 1952), without name and time: the same from the same bytes. Empty where memory is out.
std::string gzipped(std::string_view bytes);

}  // namespace pipeline
