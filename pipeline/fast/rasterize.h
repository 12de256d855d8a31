#pragma once
#include "pipeline/stages/shadow_buffer.h"
#include "pipeline/stages/z_buffer.h"

namespace pipeline {

// What zBuffer and shadowBuffer do in float, several pixels at a time. IEEE's operations alone, in the same order, and
// coverage in whole numbers that double holds without rounding: the same bits as theirs, on every machine.

// For the depth format Linear and a tile of the whole picture; nothing is recorded.
void zBufferInVectors(const View& view, const TriangleBins<float>& bins, std::size_t tile, ZBufferOutput<float>& out);
void shadowBufferInVectors(const View& face, const TriangleBins<float>& bins, std::size_t tile, Buffer2D<float>& depth);

}  // namespace pipeline
