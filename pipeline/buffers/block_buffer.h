#pragma once
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <new>

#include "pipeline/buffers/buffer2d.h"

namespace pipeline {

inline constexpr int kBlock = 4;  // pixels along the side of a block
inline constexpr int kBlockPixels = kBlock * kBlock, kBlocksAcross = kTileSize / kBlock;
inline constexpr std::size_t kBlocks = std::size_t(kBlocksAcross) * std::size_t(kBlocksAcross);  // of a tile
inline constexpr std::size_t kTilePixels = kBlocks * std::size_t(kBlockPixels);

// Which pixel of a tile stands at a place of its blocks.
constexpr glm::ivec2 pixelOf(std::size_t at) {
    const int block = int(at) / kBlockPixels, place = int(at) % kBlockPixels;
    return {block % kBlocksAcross * kBlock + place % kBlock, block / kBlocksAcross * kBlock + place / kBlock};
}

// The inverse of pixelOf.
constexpr std::size_t placeOf(glm::ivec2 inTile) {
    const glm::ivec2 block = inTile / kBlock, pixel = inTile % kBlock;
    return std::size_t((block.y * kBlocksAcross + block.x) * kBlockPixels + pixel.y * kBlock + pixel.x);
}

template <class T>
struct alignas(kBlockPixels * sizeof(T)) Block {
    T of[kBlockPixels];
};

// The numbers of blocks that stand side by side: place `at` of them is in block at / kBlockPixels. An index into the
// first block's own array must not go past its end.
template <class T>
T* numbersOf(Block<T>* blocks) {
    return blocks->of;
}
template <class T>
const T* numbersOf(const Block<T>* blocks) {
    return blocks->of;
}

// Aligns by itself what it takes from the C library. That takes more room than it needs for an aligned piece and gives
// back the rest at both ends; the piece, free again, is then too small for the next of its size, and buffers that come
// and go with every frame would lie beside the holes they left.
template <class T>
struct AlignsPieces : LeavesRaw<T> {
    template <class U>
    struct rebind {
        using other = AlignsPieces<U>;
    };
    T* allocate(std::size_t count) {
        static_assert(alignof(T) <= 128);
        auto* const piece = static_cast<std::uint8_t*>(::operator new(count * sizeof(T) + alignof(T)));
        preferLargePages(piece, count * sizeof(T));
        const auto ahead = std::uint8_t(alignof(T) - reinterpret_cast<std::uintptr_t>(piece) % alignof(T));
        piece[ahead - 1] = ahead;
        return reinterpret_cast<T*>(piece + ahead);
    }
    void deallocate(T* at, std::size_t) noexcept {
        auto* const first = reinterpret_cast<std::uint8_t*>(at);
        ::operator delete(first - first[-1]);
    }
};

// One T per pixel in squares of 4 × 4 whose pixels stand side by side, tile after tile: the part of a small triangle in
// a block is one vector, or a few, and a tile one piece of memory. Tiles are whole; what of them lies beyond the picture
// counts for nothing. Nothing is written in the beginning.
template <class T>
struct BlockBuffer2D {
    glm::ivec2 size{0}, tiles{0};  // of the picture, pixels; columns and rows of tiles
    std::vector<Block<T>, AlignsPieces<Block<T>>> blocks;

    BlockBuffer2D() = default;
    explicit BlockBuffer2D(glm::ivec2 extent)
        : size(extent), tiles((extent + kTileSize - 1) / kTileSize), blocks(tileCount() * kBlocks) {}

    std::size_t tileCount() const { return std::size_t(tiles.x) * std::size_t(tiles.y); }
    Block<T>* tile(std::size_t i) { return &blocks[i * kBlocks]; }
    const Block<T>* tile(std::size_t i) const { return &blocks[i * kBlocks]; }
    void fill(std::size_t i, T value) { std::fill_n(numbersOf(tile(i)), kTilePixels, value); }
};

// Row after row of the picture's pixels in a tile, from its blocks. Rows of 4 pixels are copied as they stand.
template <class T>
void copyRows(const Block<T>* blocks, Tile tile, Buffer2D<T>& out) {
    const int width = tile.max.x - tile.min.x;
    for (int y = 0; y < tile.max.y - tile.min.y; ++y) {
        T* to = &out.pixels[out.offset({tile.min.x, tile.min.y + y})];
        const Block<T>* from = blocks + std::ptrdiff_t(y / kBlock) * kBlocksAcross;
        const int first = y % kBlock * kBlock;
        int x = 0;
        for (; x + kBlock <= width; x += kBlock, ++from) std::memcpy(to + x, from->of + first, kBlock * sizeof(T));
        if (x < width) std::copy_n(from->of + first, width - x, to + x);
    }
}

template <class T>
void fillTile(T value, Tile tile, Buffer2D<T>& out) {
    for (int y = tile.min.y; y < tile.max.y; ++y)
        std::fill_n(&out.pixels[out.offset({tile.min.x, y})], tile.max.x - tile.min.x, value);
}

// All of it. written: per tile, whether it has been; the others hold `nothing`.
template <class T>
Buffer2D<T> rowsOf(const BlockBuffer2D<T>& blocks, const std::vector<std::uint8_t>& written, T nothing) {
    Buffer2D<T> out(blocks.size);
    for (std::size_t i = 0; i < blocks.tileCount(); ++i) {
        const Tile tile = tileOf(blocks.size, i);
        if (written[i])
            copyRows(blocks.tile(i), tile, out);
        else
            fillTile(nothing, tile, out);
    }
    return out;
}

}  // namespace pipeline
