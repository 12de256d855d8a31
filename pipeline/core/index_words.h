#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace pipeline {

// What a message expects of an index into `count` ≥ 1 elements: "a number from 0 to 4", and "0" if there is one alone.
inline std::string indexWords(std::size_t count, std::string_view before = "a number from ") {
    return count == 1 ? "0" : std::string(before) + "0 to " + std::to_string(count - 1);
}

}  // namespace pipeline
