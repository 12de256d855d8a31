#pragma once
#include <cstdint>
#include <string>

namespace pipeline {

// "512 B", "2.5 kB", "48.9 MB", for people.
std::string sizeText(std::uint64_t bytes);

}  // namespace pipeline
