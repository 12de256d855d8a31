#pragma once
#include <QPainter>

#include "app/view3d/handles.h"

namespace app {

// A handle as it is drawn over a view: hollow where it rests, with its axes where the cursor is near
// it (`hot`), and the axis that it moves on stronger.
void paintHandle(QPainter& painter, const Handle& handle, const ViewFrame& view, bool hot, DragAxis axis);
// Its name and its numbers, beside the cursor and within the view.
void paintNumbers(QPainter& painter, const QString& text, QPointF cursor, const ViewFrame& view);

}  // namespace app
