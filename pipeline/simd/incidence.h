#pragma once
#include <array>
#include <vector>

#include "pipeline/buffers/block_buffer.h"
#include "pipeline/simd/look.h"

namespace pipeline {

// How light falls on what is seen in a tile: all of Phong shading but what it is multiplied with. A frame that differs
// from the one before in that alone, in materials or in the intensities or colours of light, multiplies it anew. In
// pieces, each the pixels of a block that see one object: 8 bytes, and for each light 12, and 4 a pixel of the block for
// each of its numbers that is not the same all over the piece.
// S. Gershbein and P. Hanrahan, "A fast relighting engine for interactive cinematic lighting design", SIGGRAPH 2000.
struct Incidence {
    struct Piece {
        std::uint32_t object;
        std::uint16_t pixels;    // bit i: pixel i of the block
        std::uint8_t block;      // in its row
        SpecularForm highlight;  // whose power the highlight is
    };
    // Of the pixels of a block; at those that are not the piece's any numbers.
    struct Numbers {
        alignas(64) float of[kBlockPixels];
    };
    static constexpr float kNoHighlight = 1;    // a logarithm of a cosine is at most 0
    static constexpr float kUnknownShadow = 2;  // S is at most 1
    static constexpr std::uint32_t kSame = ~0U;
    // Of a light at the pixels of a piece: where in `numbers` they stand; kSame where
    // - N·L is nowhere above 0;
    // - log, of R·V or N·H, is everywhere kNoHighlight, as it is where the power is 0 or not asked for;
    // - S is 1 wherever N·L > 0. Where nobody has looked it up it is kUnknownShadow.
    struct Light {
        std::uint32_t nDotL = kSame, log = kSame, S = kSame;
    };

    std::vector<Piece> pieces;                             // row of blocks after row of blocks
    std::array<std::uint32_t, kBlocksAcross + 1> first{};  // of each row in `pieces`
    std::vector<Light> lights;                             // of a piece side by side
    std::vector<Numbers, LeavesRaw<Numbers>> numbers;
};

// At most, of a picture in which every block sees one object, bytes; where they see more, up to twice as much: a tile of
// more pieces than two a block is not kept.
constexpr double incidenceBytes(glm::ivec2 picture, std::size_t lights) {
    const glm::ivec2 blocks = (picture + kBlock - 1) / kBlock;
    constexpr double kOfLight = sizeof(Incidence::Light) + 3 * sizeof(Incidence::Numbers);
    return double(blocks.x) * blocks.y * (sizeof(Incidence::Piece) + double(lights) * kOfLight);
}
inline constexpr std::size_t kMostPieces = 2 * kBlocks;
// The most that is kept: 1920 × 1080 pixels with four lights, or 3840 × 2160 with one.
inline constexpr double kMostIncidence = 128e6;

}  // namespace pipeline
