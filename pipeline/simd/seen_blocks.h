#pragma once
#include "pipeline/buffers/block_buffer.h"
#include "pipeline/simd/set_up.h"

namespace pipeline {

// What is seen in each pixel, as pipeline/simd leaves it. The tiles that no triangle touches are not written.
struct SeenBlocks {
    TrianglePieces pieces;              // once all is drawn, TrianglePiece::others alone
    std::size_t triangles = 0;          // that were set up beside those
    BlockBuffer2D<float> z;             // z_view; +infinity where nothing was drawn
    BlockBuffer2D<std::uint32_t> name;  // of the triangle, as TrianglePieces says; kNoTriangle; empty where nobody asks
};

}  // namespace pipeline
