#pragma once
#include <array>
#include <vector>

#include "pipeline/buffers/block_buffer.h"
#include "pipeline/simd/look.h"

namespace pipeline {

// The light arriving at the visible surfaces of a tile: everything in Phong shading except the factors of materials and
// lights. If the next frame differs only in these factors, it multiplies this data again. It consists of pieces, each
// the pixels of a block that show one object. A piece takes 8 bytes, 12 for each light, and 4 for each pixel of the
// block and each number that varies in the piece. S. Gershbein and P. Hanrahan, "A fast relighting engine for
// interactive cinematic lighting design", SIGGRAPH 2000.
struct Incidence {
    struct Piece {
        std::uint32_t object;
        std::uint16_t pixels;    // bit i: pixel i of the block
        std::uint8_t block;      // index in its row
        SpecularForm highlight;  // the base of the highlight's power
    };
    // Of all pixels of a block; those outside the piece have arbitrary numbers.
    struct Numbers {
        alignas(64) float of[kBlockPixels];
    };
    static constexpr float kNoHighlight = 1;    // a logarithm of a cosine is at most 0
    static constexpr float kUnknownShadow = 2;  // S is at most 1
    static constexpr std::uint32_t kSame = ~0U;
    // For one light at the pixels of a piece: indices into `numbers`, or kSame if
    // - N·L is nowhere above 0;
    // - log, of R·V or N·H, is kNoHighlight everywhere: the power is 0 or not needed;
    // - S is 1 wherever N·L > 0. Pixels without a look-up have S = kUnknownShadow.
    struct Light {
        std::uint32_t nDotL = kSame, log = kSame, S = kSame;
    };

    std::vector<Piece> pieces;                             // one row of blocks after another
    std::array<std::uint32_t, kBlocksAcross + 1> first{};  // of each row, as an index into `pieces`
    std::vector<Light> lights;                             // those of a piece side by side
    std::vector<Numbers, LeavesRaw<Numbers>> numbers;
};

// The largest size in bytes for a picture in which every block shows one object. If blocks show more, up to twice as
// much; a tile with more than two pieces for each block is not kept.
constexpr double incidenceBytes(glm::ivec2 picture, std::size_t lights) {
    const glm::ivec2 blocks = (picture + kBlock - 1) / kBlock;
    constexpr double kOfLight = sizeof(Incidence::Light) + 3 * sizeof(Incidence::Numbers);
    return double(blocks.x) * blocks.y * (sizeof(Incidence::Piece) + double(lights) * kOfLight);
}
inline constexpr std::size_t kMostPieces = 2 * kBlocks;
// The most memory to keep: 1920 × 1080 pixels with four lights, or 3840 × 2160 with one.
inline constexpr double kMostIncidence = 128e6;

}  // namespace pipeline
