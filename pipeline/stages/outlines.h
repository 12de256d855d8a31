#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/stages/z_buffer.h"

namespace pipeline {

// No hidden surface removal: every polygon's outline in place of the z-buffer (lecture 1's first two comparison pictures).
// Outlines are drawn in the order of the scene, each over what is there; no depths are compared.
//
// A line is one pixel wide. Along its longer extent it takes in each column (row, for a steep line) that it reaches the
// pixel where it is at the column's centre, or at its end where it ends before the centre; on corners snapped to the
// sub-pixel grid, in integers, and from the same end whichever polygon draws it.
// After J. Bresenham, "Algorithm for computer control of a digital plotter", IBM Systems Journal 1965.

// One edge of a polygon inside near, far and guard band.
template <class Real>
struct OutlineEdge {
    std::array<glm::i64vec2, 2> ends;   // 1/65536 pixel, y down
    std::array<Real, 2> w;              // 1/z_view in perspective, z_view in orthographic projection
    std::array<Vec3<Real>, 2> weights;  // over the corners of triangle `id`
    std::uint32_t id;                   // the triangle of the polygon that has the edge
};

template <class Real>
struct OutlineBins {
    std::vector<OutlineEdge<Real>> edges;          // in polygon order
    std::size_t polygons = 0;                      // drawn
    std::vector<Tile> tiles;                       // row by row
    std::vector<std::vector<std::uint32_t>> bins;  // per tile: indices into `edges`
};

// The outlines of the polygons for which draws(polygon) holds, in tiles of `extent`.
template <class Real, class Draws>
OutlineBins<Real> binOutlines(const TransformOutput<Real>& in, Tile extent, Draws draws);

// Draws the edges of a tile. Every fragment that arrives is written, a polygon's corner by both of its edges.
template <class Real>
void drawOutlines(const View& view, const OutlineBins<Real>& bins, std::size_t tile, ZBufferOutput<Real>& out,
                  std::vector<FragmentRecord>* record = nullptr);

// Clips, projects and snaps the edges of one polygon, and adds them to `edges`.
template <class Real>
void addOutline(const TransformOutput<Real>& in, std::uint32_t polygon, std::vector<OutlineEdge<Real>>& edges);
template <class Real>
void binEdges(Tile extent, OutlineBins<Real>& bins);

template <class Real, class Draws>
OutlineBins<Real> binOutlines(const TransformOutput<Real>& in, Tile extent, Draws draws) {
    OutlineBins<Real> out;
    for (std::uint32_t polygon = 0; polygon < in.topology->polygonCount(); ++polygon) {
        if (!draws(polygon)) continue;
        addOutline(in, polygon, out.edges);
        ++out.polygons;
    }
    binEdges(extent, out);
    return out;
}

}  // namespace pipeline
