// Included once for each instruction set, like lanes.h.
#if defined(SHADESCOPE_DRAWN_ROW_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHADESCOPE_DRAWN_ROW_H
#undef SHADESCOPE_DRAWN_ROW_H
#else
#define SHADESCOPE_DRAWN_ROW_H
#endif

#include "pipeline/buffers/block_buffer.h"
#include "pipeline/simd/rows.h"
#include "pipeline/stages/z_buffer.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {

// A row of blocks as the scalar stage has drawn it; that stage keeps the weights.
struct DrawnRow {
    alignas(64) std::uint32_t triangle[kRowPixels];
    Row weights[2];  // of vertices 1 and 2

    // begin: the row's first pixel in the tile.
    void read(const ZBufferOutput<float>& z, Tile tile, std::size_t begin) {
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
