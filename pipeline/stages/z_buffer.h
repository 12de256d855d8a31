#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "pipeline/buffers/late_buffer.h"
#include "pipeline/scene/opacity.h"
#include "pipeline/stages/bin.h"
#include "pipeline/stages/parts.h"

namespace pipeline {

// Stage 5: which polygon is seen in which pixel, and how far away it is.
// E. Catmull, "A subdivision algorithm for computer display of curved surfaces", 1974.

struct ZBufferInputs {
    Visibility visibility = Visibility::ZBuffer;
    bool split = true;                            // Painter
    std::vector<TranslucentSides> translucent{};  // per object: what stage 6 draws later; empty when nothing
    // Clipping, else of polygons alone that culling did not find whole in the picture; and, left out by pipeline/simd alone,
    // what stands beside z_view and depth. Which triangle is seen is then found when somebody first reads it.
    Parts parts{};
    Planted planted{};
    bool operator==(const ZBufferInputs&) const = default;
};

struct SeenBlocks;  // pipeline/simd/seen_blocks.h

template <class Real>
struct ZBufferOutput : Visible<Real> {
    glm::ivec2 origin{0};  // the pixel that stands first; (0, 0) but for a replay
    Planted planted{};
    std::shared_ptr<const SeenBlocks> seen{};  // what zView and triangle are made of, where pipeline/simd drew
    std::vector<std::uint8_t> tileIsDrawn;     // per tile of kTileSize, row by row: whether a triangle touches it
    // What the stage did.
    long long arrived = 0, won = 0;         // fragments
    long long seenPixels = 0;               // in which there is a triangle
    long long clipped = 0, unclipped = 0;   // triangles that went through the clipper; that did not
    std::size_t unordered = 0, pieces = 0;  // of the painter's triangles those that are not in order, and all
    std::string note;                       // what the painter's order took; may be empty
};
template <class Real>
ZBufferOutput<Real> prepareZBuffer(Tile extent, DepthFormat format, const Planted& planted = {});

// The weights at a pixel that the triangle covers, as they stand in barycentric where that is kept.
template <class Real>
Vec3<Real> barycentricAt(const TransformOutput<Real>& in, std::uint32_t triangle, glm::ivec2 pixel);
// Those of the triangle that is seen in a pixel.
template <class Real>
Vec3<Real> barycentricAt(const TransformOutput<Real>& in, const ZBufferOutput<Real>& zBuffer, glm::ivec2 pixel) {
    const std::size_t at = zBuffer.triangle->offset(pixel);
    return zBuffer.barycentric.empty() ? barycentricAt(in, zBuffer.triangle->pixels[at], pixel)
                                       : zBuffer.barycentric.pixels[at];
}

// One arrival, for a replay that records.
struct FragmentRecord {
    std::uint32_t triangle;
    glm::ivec2 pixel;
    double depth, stored;  // the new depth, and the one stored before; without a z-buffer z_view
    bool won;
};

// A fragment takes the pixel.
template <class Real>
void writeFragment(ZBufferOutput<Real>& out, std::size_t at, std::uint32_t triangle, const Fragment<Real>& fragment) {
    out.zView->pixels[at] = fragment.z;
    out.triangle->pixels[at] = triangle;
    out.barycentric.pixels[at] = fragment.barycentric;
    ++out.depthWrites.pixels[at];
}

// Draws the triangles of `order`, indices into bins.triangles, into one tile. A fragment wins when it is strictly
// nearer than what is stored: on a tie the one drawn first stays.
template <class Real>
void zBuffer(const View& view, DepthFormat format, const TriangleBins<Real>& bins, std::span<const std::uint32_t> order,
             Tile tile, ZBufferOutput<Real>& out, std::vector<FragmentRecord>* record = nullptr);

}  // namespace pipeline
