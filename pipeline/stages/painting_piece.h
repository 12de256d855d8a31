#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "pipeline/stages/painter.h"

// What painting_order.cpp compares: the planes and outlines of pieces in the picture. It alone reads it.
namespace pipeline::painting {

inline DepthPlane planeOf(const PaintTriangle& t) {
    const auto& c = t.snapped.corners;
    const glm::dvec2 a(c[1] - c[0]), b(c[2] - c[0]);
    const double area2 = double(t.snapped.area2()), da = t.depth[1] - t.depth[0], db = t.depth[2] - t.depth[0];
    DepthPlane plane;
    plane.origin = glm::dvec2(c[0]);
    plane.depth = t.depth[0];
    plane.depthBound = std::max({std::abs(t.depth[0]), std::abs(t.depth[1]), std::abs(t.depth[2])});
    plane.slope = {(da * b.y - db * a.y) / area2, (db * a.x - da * b.x) / area2};
    plane.slopeBound = {(std::abs(da * b.y) + std::abs(db * a.y)) / area2,
                        (std::abs(db * a.x) + std::abs(da * b.x)) / area2};
    return plane;
}

struct Piece {
    PaintPiece piece;
    std::vector<glm::dvec2> outline;  // clockwise as seen, sub-pixels
    glm::dvec2 low, high;
    double nearest, farthest;
    bool waits = false;  // stands in the stack
};

// P is behind Q where both are seen, before it, or both; or they are not seen in the same place, or lie in one plane.
enum class Relation { Free, Behind, InFront, Mixed };

// How far apart, against how far from the picture's corner, points are one but for rounding.
constexpr double kOnePoint = 0x1p-40;

inline bool areOne(glm::dvec2 a, glm::dvec2 b) {
    return std::max(std::abs(a.x - b.x), std::abs(a.y - b.y)) <=
           kOnePoint * std::max({std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y)});
}

// The part of a convex outline where value(p) >= 0. Of corners that are one only one is kept: an edge between them would
// have any direction.
template <class Value>
std::vector<glm::dvec2> cutOutline(const std::vector<glm::dvec2>& in, Value value) {
    std::vector<glm::dvec2> out;
    const auto add = [&](glm::dvec2 p) {
        if (out.empty() || !areOne(out.back(), p)) out.push_back(p);
    };
    for (std::size_t i = 0; i < in.size(); ++i) {
        const glm::dvec2 a = in[i], b = in[(i + 1) % in.size()];
        const double fa = value(a), fb = value(b);
        if (fa >= 0) add(a);
        if ((fa >= 0) != (fb >= 0)) add(a + fa / (fa - fb) * (b - a));
    }
    if (out.size() > 1 && areOne(out.back(), out.front())) out.pop_back();
    return out;
}

// The part that two convex outlines have in common.
inline std::vector<glm::dvec2> commonOutline(const std::vector<glm::dvec2>& p, const std::vector<glm::dvec2>& q) {
    std::vector<glm::dvec2> common = p;
    for (std::size_t i = 0; i < q.size() && !common.empty(); ++i) {
        const glm::dvec2 from = q[i], along = q[(i + 1) % q.size()] - from;
        common = cutOutline(common, [&](glm::dvec2 x) { return along.x * (x.y - from.y) - along.y * (x.x - from.x); });
    }
    return common;
}

// Whether pieces overlap by more than rounding makes of outlines that touch.
inline bool hasArea(const std::vector<glm::dvec2>& outline) {
    double twice = 0, length = 0, largest = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const glm::dvec2 a = outline[i] - outline[0], along = outline[(i + 1) % outline.size()] - outline[i];
        twice += a.x * along.y - a.y * along.x;
        length += glm::length(along);
        largest = std::max({largest, std::abs(outline[i].x), std::abs(outline[i].y)});
    }
    return std::abs(twice) > kOnePoint * largest * length;
}

inline bool separated(const SnappedTriangle& a, const SnappedTriangle& b) {
    for (std::size_t i = 0; i < 3; ++i) {
        const EdgeFunction edge(a.corners[i], a.corners[(i + 1) % 3]);
        if (std::ranges::all_of(b.corners, [&](const glm::i64vec2& p) { return edge.at(p) <= 0; })) return true;
    }
    return false;
}

}  // namespace pipeline::painting
