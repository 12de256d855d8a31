#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "pipeline/run/frame_data.h"
#include "pipeline/run/parallel.h"
#include "pipeline/stages/outlines.h"
#include "pipeline/stages/painter.h"

namespace pipeline {

// The z-buffer stage taken apart into what it draws one after the other: the polygons of the scene, the pieces of the
// painter's order, or the outlines. What covers no pixel's centre is no element.
template <class Real>
struct Drawing {
    TriangleBins<Real> bins;
    PaintingOrder order;                            // painter alone
    std::vector<std::vector<std::uint32_t>> tiles;  // per tile: what touches it, in order; not of outlines
    OutlineBins<Real> outlines;                     // visibility none alone
    // Per element: its triangles, pieces or edges as a half-open range; and its polygon.
    std::vector<std::array<std::uint32_t, 2>> ranges;
    std::vector<std::uint32_t> polygons;
    // Pixels and rows of the first i + 1 elements; empty where the elements are outlines.
    std::vector<std::int64_t> pixels, rows;
};
template <class Real>
Drawing<Real> takeApart(const FrameData<Real>& data);

// Pixels of one row, first to last, both included.
struct PixelSpan {
    int y = 0, first = 0, last = 0;
    int length() const { return last - first + 1; }
};
// An element's pixels as it is scan-converted: rows from the top, each from the left. A pixel that two triangles of a
// polygon cover, which takes one that is not planar, stands here once.
template <class Real>
std::vector<PixelSpan> spansOf(const Drawing<Real>& drawing, std::size_t element);

// How far into a picture: all rows above `row`, and of that one the pixels before x. Nothing at (0, 0).
struct Reach {
    int row = 0, x = 0;
};

// What the stage has left after the first `elements` elements, and of the next one the pixels within `reach`: by the
// functions that the stage itself consists of.
template <class Real>
ZBufferOutput<Real> drawnSoFar(const FrameData<Real>& data, const Drawing<Real>& drawing, std::size_t elements,
                               Reach reach, Threads& threads);

// What has reached a pixel before an element is drawn, and what the element itself brings there, in the order of drawing:
// by the functions that the stage itself consists of. Not of outlines.
struct PixelFragments {
    std::vector<FragmentRecord> before, own;
};
template <class Real>
PixelFragments fragmentsAt(const FrameData<Real>& data, const Drawing<Real>& drawing, std::size_t element,
                           glm::ivec2 pixel);

}  // namespace pipeline
