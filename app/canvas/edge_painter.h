#pragma once
#include "app/canvas/buffer_painter.h"
#include "pipeline/inspect/edge_view.h"

namespace app {

inline constexpr double kWeightsZoom = 72;  // from here on a pixel has room for three weights

// Draws the edges of a triangle as the rasterizer has them, on the sub-pixel grid, and marks each visible pixel centre
// as covered or not. Solid: the edge owns the samples on it (left or top); dashed: it does not.
void paintEdgeView(QPainter& painter, const pipeline::EdgeView& view, const Placement& placement, QRect pixels);

// A pixel's weights in the screen plane, e_i / (2 area): their signs are those of the edge functions.
QStringList edgeText(const pipeline::EdgeView& view, int x, int y);

}  // namespace app
