#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "pipeline/run/frame_data.h"
#include "pipeline/run/parallel.h"
#include "pipeline/stages/outlines.h"
#include "pipeline/stages/painter.h"

namespace pipeline {

// The z-buffer stage as a sequence of drawn elements: the polygons of the scene, the pieces of the painter's order, or
// the outlines. An element that covers no pixel's centre is left out.
template <class Real>
struct Drawing {
    TriangleBins<Real> bins;
    PaintingOrder order;                            // painter only
    std::vector<std::vector<std::uint32_t>> tiles;  // per tile: what touches it, in order; not for outlines
    OutlineBins<Real> outlines;                     // visibility none only
    // For each element: its triangles, pieces or edges as a half-open range, and its polygon.
    std::vector<std::array<std::uint32_t, 2>> ranges;
    std::vector<std::uint32_t> polygons;
    // Number of pixels and rows of the first i + 1 elements; empty for outlines.
    std::vector<std::int64_t> pixels, rows;
};
template <class Real>
Drawing<Real> takeApart(const FrameData<Real>& data);

// The pixels of one row from first to last, both included.
struct PixelSpan {
    int y = 0, first = 0, last = 0;
    int length() const { return last - first + 1; }
};
// The pixels of an element in scan order: rows from the top, each from the left. In a polygon that is not planar two
// triangles may cover the same pixel; it is listed once.
template <class Real>
std::vector<PixelSpan> spansOf(const Drawing<Real>& drawing, std::size_t element);

// A part of a picture: all rows above `row`, and in that row the pixels before x. Empty at (0, 0).
struct Reach {
    int row = 0, x = 0;
};

// The stage's output after the first `elements` elements, and the pixels within `reach` of the next one. Computed with
// the stage's own functions.
template <class Real>
ZBufferOutput<Real> drawnSoFar(const FrameData<Real>& data, const Drawing<Real>& drawing, std::size_t elements,
                               Reach reach, Threads& threads);

// The fragments that reached a pixel before an element is drawn, and those of the element itself, in the order of
// drawing. Computed with the stage's own functions. Not for outlines.
struct PixelFragments {
    std::vector<FragmentRecord> before, own;
};
template <class Real>
PixelFragments fragmentsAt(const FrameData<Real>& data, const Drawing<Real>& drawing, std::size_t element,
                           glm::ivec2 pixel);

}  // namespace pipeline
