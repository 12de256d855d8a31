// Included once for each instruction set, like lanes.h.
#if defined(SHADESCOPE_DRAWN_ROW_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHADESCOPE_DRAWN_ROW_H
#undef SHADESCOPE_DRAWN_ROW_H
#else
#define SHADESCOPE_DRAWN_ROW_H
#endif

#include <algorithm>

#include "pipeline/buffers/block_buffer.h"
#include "pipeline/simd/rows.h"
#include "pipeline/stages/z_buffer.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {

// At most one triangle in each pixel of a tile, in the order of its blocks; kNoTriangle in the others.
struct DrawnTile {
    std::uint32_t triangle[kTilePixels];
    float weights[2][kTilePixels];  // perspective-correct, of vertices 1 and 2
};

// A row of blocks that no kernel has drawn: its weights are kept.
struct DrawnRow {
    alignas(64) std::uint32_t triangle[kRowPixels];
    Row weights[2];                   // of vertices 1 and 2
    const DrawnTile* from = nullptr;  // null: from what the scalar stage has drawn

    // begin: the row's first pixel in the tile.
    void read(const ZBufferOutput<float>& z, Tile tile, std::size_t begin) {
        if (from) {
            std::copy_n(from->triangle + begin, kRowPixels, triangle);
            for (int k = 0; k < 2; ++k) std::copy_n(from->weights[k] + begin, kRowPixels, weights[k].of);
            return;
        }
        for (std::size_t i = 0; i < kRowPixels; ++i) {
            const glm::ivec2 pixel = tile.min + pixelOf(begin + i);
            const bool inside = pixel.x < tile.max.x && pixel.y < tile.max.y;
            triangle[i] = inside ? z.triangle->at(pixel) : kNoTriangle;
            for (int k = 0; k < 2; ++k) weights[k].of[i] = inside ? z.barycentric.at(pixel)[k + 1] : 0;
        }
    }
    Mask seenAt(std::size_t i) const {
        return hn::RebindMask(F(), hn::Ne(hn::Load(U(), triangle + i), hn::Set(U(), kNoTriangle)));
    }
};

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
