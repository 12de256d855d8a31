#pragma once
#include "pipeline/simd/seen_blocks.h"
#include "pipeline/stages/shadow_buffer.h"
#include "pipeline/stages/z_buffer.h"

namespace pipeline {

// Does what zBuffer and shadowBuffer do, in float and for several pixels at a time. It uses only IEEE operations in the
// same order. Coverage is in integers, or in double where double holds them exactly. So the bits are the same on every
// machine.

struct TileCounts {
    long long arrived = 0, won = 0;  // fragments
    long long seen = 0;              // pixels that show a triangle
};
// For the depth format Linear, into the blocks of `seen`. Writes overdraw, depth writes and barycentric weights if
// `out` has room for them. in: the data that the pieces of `seen` were set up from.
TileCounts zBufferInVectors(const SetUpInputs& in, std::size_t tile, SeenBlocks& seen, ZBufferOutput<float>& out);
// Pixels without a triangle get +infinity. in: the data that the pieces were set up from. isFirst: clears the tile;
// otherwise the depths in it stay.
void shadowBufferInVectors(const SetUpInputs& in, const TrianglePieces& pieces, std::size_t tile, bool isFirst,
                           BlockBuffer2D<float>& depth);

}  // namespace pipeline
