#include "tests/support/model_files.h"

#include <cstdint>
#include <cstring>

#include <fmt/format.h>

namespace test {
namespace {

template <class T>
std::string bytesOf(T value) {
    std::string bytes(sizeof(T), '\0');
    std::memcpy(bytes.data(), &value, sizeof(T));
    return bytes;
}

std::string cornerBytes(int i, int k) { return bytesOf(float(i + (k == 1))) + bytesOf(float(k == 2)) + bytesOf(0.0f); }

std::string plyHeader(std::string_view form, int triangles, std::string_view end) {
    return fmt::format(
        "ply{3}format {0} 1.0{3}element vertex {1}{3}property float x{3}property float y{3}property float z{3}"
        "element face {2}{3}property list uchar int vertex_indices{3}end_header{3}",
        form, 3 * triangles, triangles, end);
}

}  // namespace

std::string cornerText(int triangle, int corner) {
    return fmt::format("{} {} 0", triangle + (corner == 1), corner == 2 ? 1 : 0);
}

std::string objText(int triangles, std::string_view end) {
    std::string text;
    for (int i = 0; i < triangles; ++i) {
        for (int k = 0; k < 3; ++k) text += fmt::format("v {}{}", cornerText(i, k), end);
        text += fmt::format("f -3 -2 -1{}", end);
    }
    return text;
}

std::string plyText(int triangles, std::string_view end) {
    std::string text = plyHeader("ascii", triangles, end);
    for (int i = 0; i < 3 * triangles; ++i) text += fmt::format("{}{}", cornerText(i / 3, i % 3), end);
    for (int i = 0; i < triangles; ++i) text += fmt::format("3 {} {} {}{}", 3 * i, 3 * i + 1, 3 * i + 2, end);
    return text;
}

std::string plyBytes(int triangles) {
    std::string text = plyHeader("binary_little_endian", triangles, "\n");
    for (int i = 0; i < 3 * triangles; ++i) text += cornerBytes(i / 3, i % 3);
    for (int i = 0; i < triangles; ++i) {
        text += '\3';
        for (int k = 0; k < 3; ++k) text += bytesOf(std::int32_t(3 * i + k));
    }
    return text;
}

std::string stlText(int triangles, std::string_view end) {
    std::string text = fmt::format("solid s{}", end);
    for (int i = 0; i < triangles; ++i) {
        text += fmt::format("facet normal 0 0 1{0}outer loop{0}", end);
        for (int k = 0; k < 3; ++k) text += fmt::format("vertex {}{}", cornerText(i, k), end);
        text += fmt::format("endloop{0}endfacet{0}", end);
    }
    return text + fmt::format("endsolid s{}", end);
}

std::string stlBytes(int triangles) {
    std::string text = std::string(80, ' ') + bytesOf(std::uint32_t(triangles));
    for (int i = 0; i < triangles; ++i) {
        text += std::string(12, '\0');
        for (int k = 0; k < 3; ++k) text += cornerBytes(i, k);
        text += std::string(2, '\0');
    }
    return text;
}

}  // namespace test
