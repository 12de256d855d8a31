#pragma once
#include "app/panels/buffer_painter.h"

namespace app {

// The same picture with row 0 at its foot: rows of pixels, outlines and what is written are turned
// over, letters are not. Edge functions have no such picture: the rule that they show knows a top.
CanvasContent upsideDown(const CanvasContent& content);
inline QPointF upsideDown(QPointF p, int height) { return {p.x(), height - p.y()}; }
inline QPoint upsideDown(QPoint pixel, int height) { return {pixel.x(), height - 1 - pixel.y()}; }

}  // namespace app
