#pragma once
#include "pipeline/simd/seen_blocks.h"
#include "pipeline/stages/shadow_buffer.h"
#include "pipeline/stages/z_buffer.h"

namespace pipeline {

// What zBuffer and shadowBuffer do in float, several pixels at a time. IEEE's operations alone, in the same order, and
// coverage in whole numbers, in double only where it holds them without rounding: the same bits as theirs, on every
// machine.

struct TileCounts {
    long long arrived = 0, won = 0;  // fragments
    long long seen = 0;              // pixels in which there is a triangle
};
// For the depth format Linear, into the blocks of `seen`. Overdraw, depth writes and barycentric weights only where `out`
// has room for them.
// in: what the pieces of `seen` were set up from.
TileCounts zBufferInVectors(const SetUpInputs& in, std::size_t tile, SeenBlocks& seen, ZBufferOutput<float>& out);
// +infinity where nothing is. in: what the pieces were set up from. isFirst: else to what is there already.
void shadowBufferInVectors(const SetUpInputs& in, const TrianglePieces& pieces, std::size_t tile, bool isFirst,
                           BlockBuffer2D<float>& depth);

}  // namespace pipeline
