#pragma once
#include <limits>

#include "pipeline/buffers/block_buffer.h"
#include "pipeline/simd/set_up.h"

namespace pipeline {

// What is seen in each pixel, as pipeline/simd leaves it. The tiles that no triangle touches are not written.
struct SeenBlocks {
    static constexpr float kNowhere = std::numeric_limits<float>::infinity();

    TrianglePieces pieces;      // once all is drawn, TrianglePiece::others alone
    std::size_t triangles = 0;  // that were set up beside those
    BlockBuffer2D<float> z;     // z_view; kNowhere where nothing was drawn
    BlockBuffer2D<std::uint32_t>
        name;  // of the triangle, as TrianglePieces says; any where nothing was drawn; empty where nobody asks
};

}  // namespace pipeline
