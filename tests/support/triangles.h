#pragma once
#include <array>
#include <glm/glm.hpp>
#include <vector>

// Random triangles in a picture, for tests of coverage.
namespace test {

using ScreenTriangle = std::array<glm::dvec2, 3>;  // pixels, y down

// `count` triangles for a picture of size × size pixels, different for every seed: of any size, below a pixel, splinters,
// larger than the picture, with vertices on pixels' corners and centres, and with an edge of the one before. Their
// coordinates are multiples of 2^-bits pixels in [-reach, size + reach], so that floats hold them where these are 24 bits.
std::vector<ScreenTriangle> randomTriangles(unsigned seed, std::size_t count, int size, double reach, int bits);

// What is wrong with pictures of triangles that lie over one another, a later one nearer to the eye; by the exact verifier.
struct CoverageViolations {
    std::size_t missing = 0;  // samples where a triangle must be seen and one farther away, or none, is
    std::size_t extra = 0;    // where one is seen that must not be
    std::size_t decided = 0;  // where one must be seen

    // ids: per pixel of size × size, row by row, which triangle is seen; -1 none. bits: of the grid.
    void add(const std::vector<ScreenTriangle>& triangles, const std::vector<int>& ids, int size, int bits);
};

}  // namespace test
