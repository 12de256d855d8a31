#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "pipeline/run/frame.h"

namespace pipeline {

// Positions along a pixel's side, in which an edge view's corners are counted.
inline constexpr std::int64_t kEdgeUnits = 65536;

// What decides which pixels a triangle covers: its three edge functions, on corners snapped to the
// sub-pixel grid. A polygon's triangle that a plane cut is the piece of it.
struct EdgeView {
    std::uint32_t polygon = 0;              // over all objects
    std::array<glm::i64vec2, 3> corners{};  // 1/kEdgeUnits pixel, y down, clockwise as seen
    std::int64_t area2 = 0;                 // twice the area, 1/kEdgeUnits² px²; positive
    bool operator==(const EdgeView&) const = default;
};

// Whether a sample exactly on an edge belongs to the triangle: by the top-left rule.
enum class EdgeSide : std::uint8_t { Left, Top, Other };  // the first two own their samples

// Edge i lies opposite to corner i.
EdgeSide edgeSide(const EdgeView& view, int edge);
std::array<glm::i64vec2, 2> edgeEnds(const EdgeView& view, int edge);  // clockwise

struct EdgeSample {
    std::array<std::int64_t, 3> values{};  // of the edge functions at the pixel's centre; their sum is area2
    std::array<bool, 3> inside{};          // on the triangle's side of the edge, or on an edge that owns it
    bool covered() const { return inside[0] && inside[1] && inside[2]; }
};
EdgeSample edgesAt(const EdgeView& view, glm::ivec2 pixel);

// Of the triangle that is seen in a pixel; nothing where none is, or before the z-buffer has run.
std::optional<EdgeView> edgeViewAt(const Frame& frame, glm::ivec2 pixel);

}  // namespace pipeline
