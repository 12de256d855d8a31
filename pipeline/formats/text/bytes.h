#pragma once
#include <bit>
#include <cstddef>
#include <cstring>
#include <string_view>
#include <type_traits>
#include <utility>

namespace pipeline {

// Whether `count` bytes from `offset` on are there; neither sum can overflow.
inline bool hasBytes(std::string_view bytes, std::size_t offset, std::size_t count) {
    return offset <= bytes.size() && count <= bytes.size() - offset;
}

// A number of a binary file; its bytes are there. Files are little-endian where nothing else is said.
template <class T>
T numberAt(std::string_view bytes, std::size_t offset, std::endian order = std::endian::little) {
    static_assert(std::is_arithmetic_v<T>);
    char raw[sizeof(T)];
    std::memcpy(raw, bytes.data() + offset, sizeof(T));
    if (order != std::endian::native)
        for (std::size_t i = 0; i < sizeof(T) / 2; ++i) std::swap(raw[i], raw[sizeof(T) - 1 - i]);
    return std::bit_cast<T>(raw);
}

}  // namespace pipeline
