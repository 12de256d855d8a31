#pragma once
#include <QPainter>
#include <stop_token>

#include "app/canvas/shape_picture.h"

namespace app {

// Under `zoom` (screen pixels per picture pixel) with the picture's corner at `origin`. What is
// written stays within `window`. strength: of all but what is written, 0 to 1.
void paintShapes(QPainter& painter, const ShapePicture& picture, QPointF origin, double zoom, QRectF window,
                 const std::stop_token& stop = {}, double strength = 1);

}  // namespace app
