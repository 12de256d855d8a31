#pragma once
#include "pipeline/simd/set_up.h"
#include "pipeline/stages/shadow_buffer.h"
#include "pipeline/stages/z_buffer.h"

namespace pipeline {

// What zBuffer and shadowBuffer do in float, several pixels at a time. IEEE's operations alone, in the same order, and
// coverage in whole numbers, in double only where it holds them without rounding: the same bits as theirs, on every
// machine. A tile is drawn in room of its own, in squares of 4 × 4 pixels, and written to the picture when it is done.

// For the depth format Linear. Overdraw, depth writes and barycentric weights only where `out` has room for them.
struct TileCounts {
    long long arrived = 0, won = 0;  // fragments
};
TileCounts zBufferInVectors(const View& view, const TrianglePieces& pieces, std::size_t tile,
                            ZBufferOutput<float>& out);
void shadowBufferInVectors(const View& face, const TrianglePieces& pieces, std::size_t tile, Buffer2D<float>& depth);

}  // namespace pipeline
