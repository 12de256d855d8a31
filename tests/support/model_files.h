#pragma once
#include <string>
#include <string_view>

// Models in each format: triangles beside each other along x, every one with three vertices of its own at x, y = i, 0;
// i + 1, 0; i, 1.
namespace test {

// end: of lines.
std::string objText(int triangles, std::string_view end = "\n");
std::string plyText(int triangles, std::string_view end = "\n");
std::string plyBytes(int triangles);
std::string stlText(int triangles, std::string_view end = "\n");
std::string stlBytes(int triangles);
std::string cornerText(int triangle, int corner);  // "4 0 0"

}  // namespace test
