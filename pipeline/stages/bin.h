#pragma once
#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "pipeline/scene/mesh/topology.h"
#include "pipeline/stages/cull.h"
#include "pipeline/stages/rasterize.h"

namespace pipeline {

// The triangles that go on, set up in polygon order, and which of them touch which tile of a
// view's picture. Tiles are what threads share out; within a tile the drawing order is kept.
template <class Real>
struct TriangleBins {
    std::vector<RasterTriangle<Real>> triangles;
    glm::ivec2 size{0};                            // of the picture, pixels
    glm::ivec2 tiles{0};                           // columns, rows
    std::vector<std::vector<std::uint32_t>> bins;  // per tile, row by row: indices into `triangles`
    long long clipped = 0, unclipped = 0;          // triangles that went through the clipper; that did not

    Tile tile(std::size_t i) const { return tileOf(size, i); }
};

// Which triangles take part, by the way they face the view.
struct FacingFilter {
    ShadowCull cull = ShadowCull::None;
    std::span<const std::uint8_t> mirrored{};  // per object, whether it is turned inside out; empty: none is

    bool isMirrored(std::size_t object) const { return !mirrored.empty() && mirrored[object] != 0; }
    // signedArea2: of setUpTriangle.
    bool keeps(std::int64_t signedArea2, std::size_t object) const {
        const bool faces = (signedArea2 > 0) != isMirrored(object);
        return cull == ShadowCull::None || faces == (cull == ShadowCull::Back);
    }
};

// Of a topology's triangles, those from `first` on, before `last`.
struct TriangleRange {
    std::size_t first = 0, last = std::numeric_limits<std::size_t>::max();
};

// Calls each(TriangleRange) for all triangles in their order, at least once, so that those of a fine mesh are not all set
// up at the same time: one takes 168 bytes in float, 232 in double.
template <class Each>
void forTrianglesInParts(const Topology& topology, Each each) {
    constexpr std::size_t kMostAtOnce = 1 << 16;
    const std::size_t count = topology.triangles.size();
    for (std::size_t first = 0; first == 0 || first < count; first += kMostAtOnce)
        each(TriangleRange{first, std::min(count, first + kMostAtOnce)});
}

// world: per vertex. verdicts: per polygon, or empty when all go on.
// marks: per polygon, CullOutput's: those inside need no clipping; empty when all are sent through it.
// drawn: per polygon, whether this pass draws it; empty when it draws all.
template <class Real>
TriangleBins<Real> binTriangles(const Topology& topology, const View& view, std::span<const Vec3<Real>> world,
                                std::span<const Verdict> verdicts, std::span<const std::uint8_t> marks = {},
                                std::span<const std::uint8_t> drawn = {}, const FacingFilter& facing = {},
                                TriangleRange range = {});

}  // namespace pipeline
