#pragma once
#include <cassert>
#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "pipeline/core/memory.h"

namespace pipeline {

// Leaves what a vector grows by as it finds it: what is written in full need not be written twice.
template <class T>
struct LeavesRaw : std::allocator<T> {
    template <class U>
    struct rebind {
        using other = LeavesRaw<U>;
    };
    T* allocate(std::size_t count) {
        T* const piece = std::allocator<T>::allocate(count);
        preferLargePages(piece, count * sizeof(T));
        return piece;
    }
    template <class U>
    void construct(U* at) noexcept(std::is_nothrow_default_constructible_v<U>) {
        ::new (static_cast<void*>(at)) U;
    }
    template <class U, class... Arguments>
    void construct(U* at, Arguments&&... arguments) {
        std::construct_at(at, std::forward<Arguments>(arguments)...);
    }
};

template <class T>
using RawVector = std::vector<T, LeavesRaw<T>>;

// One T per pixel, row by row from the top left.
template <class T>
struct Buffer2D {
    using Pixels = RawVector<T>;
    glm::ivec2 size{0};
    Pixels pixels;

    Buffer2D() = default;
    // Every pixel has to be written before any is read.
    explicit Buffer2D(glm::ivec2 extent) : size(extent), pixels(std::size_t(extent.x) * std::size_t(extent.y)) {}
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
inline constexpr int kTileSize = 64;  // pixels

// Tile i of a picture, row by row.
inline Tile tileOf(glm::ivec2 picture, std::size_t i) {
    const int columns = (picture.x + kTileSize - 1) / kTileSize;
    const glm::ivec2 at{int(i) % columns, int(i) / columns};
    return {at * kTileSize, glm::min((at + 1) * kTileSize, picture)};
}

// And back: of the tile.
inline std::size_t tileAt(glm::ivec2 picture, const Tile& tile) {
    const int columns = (picture.x + kTileSize - 1) / kTileSize;
    const glm::ivec2 at = tile.min / kTileSize;
    return std::size_t(at.y) * std::size_t(columns) + std::size_t(at.x);
}

}  // namespace pipeline
