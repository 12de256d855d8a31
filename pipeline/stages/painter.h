#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/core/stop.h"
#include "pipeline/stages/z_buffer.h"

namespace pipeline {

// The painter's algorithm in place of the z-buffer: polygons are painted from the farthest to the nearest, each over
// what is there (lecture 2). Everything is decided where the rasterizer works: on snapped corners in the picture's
// plane, with a depth that is affine in it, which keeps order and planes as they are in view space.

// Depth over the picture's plane, larger is farther: -1 / z_view in perspective, z_view in orthographic projection.
struct DepthPlane {
    glm::dvec2 origin{0}, slope{0}, slopeBound{0};  // sub-pixels; depth per sub-pixel
    double depth = 0, depthBound = 0;
    double at(glm::dvec2 p) const { return depth + slope.x * (p.x - origin.x) + slope.y * (p.y - origin.y); }
    // Bound on the rounding error of at(p): eight roundings.
    double error(glm::dvec2 p) const {
        constexpr double kRoundoff = 0x1p-53;
        return 8 * kRoundoff *
               (depthBound + slopeBound.x * std::abs(p.x - origin.x) + slopeBound.y * std::abs(p.y - origin.y));
    }
    // Likewise where p is a corner that cutting has made: of a few roundings of its own, and of the depths that it was
    // found by.
    double errorNear(glm::dvec2 p) const {
        constexpr double kRoundoff = 0x1p-53;
        return 4 * (error(p) + kRoundoff * (std::abs(slope.x * p.x) + std::abs(slope.y * p.y)));
    }
};

struct PaintTriangle {
    SnappedTriangle snapped;      // clockwise as seen
    std::array<double, 3> depth;  // at the corners
    double mean = 0;              // mean z_view of the polygon's vertices, world units
    std::uint32_t polygon = 0;
};

// The pixels of a triangle, or those of them where it lies behind (or not behind) other triangles' planes.
struct PaintPiece {
    struct Cut {
        std::uint32_t by;  // the triangle whose plane cuts
        bool behind;
    };
    std::uint32_t triangle;
    std::vector<Cut> cuts;
};

struct PaintingOrder {
    std::vector<DepthPlane> planes;  // per triangle
    std::vector<PaintPiece> pieces;  // in the order they are painted
    std::size_t compared = 0;        // pairs of pieces
    std::size_t splits = 0;
    std::size_t unordered = 0;  // pieces painted although something behind them was still to come

    // Whether a piece has the sample at the pixel's centre, given that its triangle covers it. Of the pieces of a
    // triangle exactly one does.
    bool has(const PaintPiece& piece, glm::ivec2 pixel) const;
};

// More pieces than this many times the triangles, and this many beside, are not made; nor are more pairs compared.
inline constexpr std::size_t kMaxPiecesPerTriangle = 4, kMaxExtraPieces = 10'000, kMaxComparisons = 200'000'000;

// Without split: by mean z_view of the polygon, the farthest first, ties by number. With split: M. Newell, R. Newell,
// T. Sancha, "A solution to the hidden surface problem", ACM 1972: sorted by the farthest point; where a triangle
// hides one that comes later, that one comes first; where they hide each other, or a cycle closes, one is split by
// the other's plane. Triangles that lie in one plane keep their order. Once maxComparisons are made, or it is stopped,
// what is left is painted without being compared.
PaintingOrder paintingOrder(std::span<const PaintTriangle> triangles, bool split, const Stop& stop = {},
                            std::size_t maxComparisons = kMaxComparisons);

// The order of bins.triangles. world: per vertex.
template <class Real>
PaintingOrder paintingOrder(const Topology& topology, const View& view, std::span<const Vec3<Real>> world,
                            const TriangleBins<Real>& bins, bool split, const Stop& stop = {});

// Per tile the indices of the pieces that touch it, in the order of painting.
template <class Real>
std::vector<std::vector<std::uint32_t>> binPieces(const TriangleBins<Real>& bins, const PaintingOrder& order);

// Paints pieces, indices into order.pieces, into one tile. Every fragment that arrives is written.
template <class Real>
void paint(const View& view, const TriangleBins<Real>& bins, const PaintingOrder& order,
           std::span<const std::uint32_t> pieces, Tile tile, ZBufferOutput<Real>& out,
           std::vector<FragmentRecord>* record = nullptr);

}  // namespace pipeline
