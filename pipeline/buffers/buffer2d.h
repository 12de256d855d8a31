#pragma once
#include <cassert>
#include <cstddef>
#include <vector>

#include <glm/glm.hpp>

namespace pipeline {

// One T per pixel, row by row from the top left.
template <class T>
struct Buffer2D {
    glm::ivec2 size{0};
    std::vector<T> pixels;

    Buffer2D() = default;
    Buffer2D(glm::ivec2 extent, T fill) : size(extent), pixels(std::size_t(extent.x) * std::size_t(extent.y), fill) {}

    bool empty() const { return pixels.empty(); }
    T& at(glm::ivec2 p) { return pixels[offset(p)]; }
    const T& at(glm::ivec2 p) const { return pixels[offset(p)]; }

    std::size_t offset(glm::ivec2 p) const {
        assert(p.x >= 0 && p.y >= 0 && p.x < size.x && p.y < size.y);
        return std::size_t(p.y) * std::size_t(size.x) + std::size_t(p.x);
    }
};

// The pixels [min, max) that one task owns. No two tasks share a pixel.
struct Tile {
    glm::ivec2 min{0}, max{0};
};

}  // namespace pipeline
