#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/scene/topology.h"
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

// positions: per vertex, in the view's space. verdicts: per polygon, or empty when all go on.
// inside: per polygon, whether it is known to need no clipping; empty when all are sent through it.
// drawn: per polygon, whether this pass draws it; empty when it draws all.
template <class Real>
TriangleBins<Real> binTriangles(const Topology& topology, const View& view, std::span<const Vec3<Real>> positions,
                                std::span<const Verdict> verdicts, std::span<const std::uint8_t> inside = {},
                                std::span<const std::uint8_t> drawn = {});

}  // namespace pipeline
