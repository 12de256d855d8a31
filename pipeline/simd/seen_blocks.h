#pragma once
#include <limits>

#include "pipeline/buffers/block_buffer.h"
#include "pipeline/simd/set_up.h"

namespace pipeline {

// The visible surface at each pixel, as pipeline/simd stores it. Tiles that no triangle touches are not written.
struct SeenBlocks {
    static constexpr float kNowhere = std::numeric_limits<float>::infinity();

    TrianglePieces pieces;      // after drawing only TrianglePiece::others are left
    std::size_t triangles = 0;  // number of the other triangles
    BlockBuffer2D<float> z;     // z_view; kNowhere where nothing was drawn
    BlockBuffer2D<std::uint32_t>
        name;  // of the triangle, see TrianglePieces; arbitrary where nothing was drawn; empty if not requested
};

}  // namespace pipeline
