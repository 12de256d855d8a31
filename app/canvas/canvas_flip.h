#pragma once
#include "app/canvas/buffer_painter.h"

namespace app {

// The same picture with row 0 at the bottom: pixels, outlines and the places of texts are flipped, letters are not.
// Edge functions cannot be flipped, because their top-left rule needs a top.
CanvasContent upsideDown(const CanvasContent& content);
inline QPointF upsideDown(QPointF p, int height) { return {p.x(), height - p.y()}; }
inline QPoint upsideDown(QPoint pixel, int height) { return {pixel.x(), height - 1 - pixel.y()}; }

}  // namespace app
