#pragma once
#include <cstdint>
#include <vector>

#include "pipeline/buffers/buffer2d.h"

namespace pipeline {

// A vertex of a view in float as its polygons are set up from: projected and snapped in double, once for all the polygons
// around it.
struct SnappedVertex {
    std::int32_t x, y;     // steps, y down; any number where kCut is set
    float w;               // 1/z_view in perspective, z_view in orthographic projection
    std::uint32_t planes;  // bits: where the vertex stands

    // Bit k: outside plane k (clip.h) of the picture; bit kNotInside + k: not inside it.
    static constexpr unsigned kNotInside = 8;
    static constexpr std::uint32_t kOutside = 0x3f;  // the bits of all six planes
    // Not inside near, far or guard band: its polygons go through the clipper.
    static constexpr std::uint32_t kCut = 1u << 16;
};
static_assert(sizeof(SnappedVertex) == 16);

struct SnappedVertices {
    int bits = 8;                                             // the grid's steps are 2^-bits pixels
    std::size_t first = 0;                                    // of the vertices that are there
    std::vector<SnappedVertex, LeavesRaw<SnappedVertex>> of;  // one each, from there on

    const SnappedVertex& at(std::size_t vertex) const { return of[vertex - first]; }
};

}  // namespace pipeline
