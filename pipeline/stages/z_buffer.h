#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/buffers/buffer2d.h"
#include "pipeline/stages/bin.h"

namespace pipeline {

// Stage 5: which polygon is seen in which pixel, and how far away it is.
// E. Catmull, "A subdivision algorithm for computer display of curved surfaces", 1974.

inline constexpr std::uint32_t kNoTriangle = ~0u;  // nothing was drawn
inline constexpr std::int32_t kNothing = -1;       // the same, in object_id and polygon_id

template <class Real>
struct ZBufferOutput {
    glm::ivec2 origin{0};                // the pixel that stands first; (0, 0) but for a replay
    Buffer2D<Real> depth;                // as stored; empty in format Linear, where it is zView
    Buffer2D<Real> zView;                // world units; +infinity where nothing was drawn
    Buffer2D<std::uint32_t> triangle;    // index into Topology::triangles; kNoTriangle
    Buffer2D<Vec3<Real>> barycentric;    // perspective-correct weights over that triangle's corners
    Buffer2D<std::int32_t> overdraw;     // fragments that arrived
    Buffer2D<std::int32_t> depthWrites;  // fragments that won
};
template <class Real>
ZBufferOutput<Real> prepareZBuffer(Tile extent, DepthFormat format);

// One arrival, for a replay that records.
template <class Real>
struct FragmentRecord {
    std::uint32_t triangle;
    glm::ivec2 pixel;
    Real depth, stored;  // the two depths compared: the new one, and the one stored before
    bool won;
};

// Draws the triangles of `order`, indices into bins.triangles, into one tile. A fragment wins when it is strictly
// nearer than what is stored: on a tie the one drawn first stays.
template <class Real>
void zBuffer(const View& view, DepthFormat format, const TriangleBins<Real>& bins, std::span<const std::uint32_t> order,
             Tile tile, ZBufferOutput<Real>& out, std::vector<FragmentRecord<Real>>* record = nullptr);

}  // namespace pipeline
