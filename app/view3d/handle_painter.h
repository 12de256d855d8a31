#pragma once
#include <QPainter>

#include "app/view3d/handle_drag.h"

namespace app {

// A handle as it is drawn over a view: hollow where it rests, with its arms where the cursor is near
// it (`hot`), and the one that is held stronger.
void paintHandle(QPainter& painter, const Handle& handle, const HandleView& view, bool hot,
                 std::optional<std::size_t> arm);
// Its name and its numbers, beside the cursor and within the view.
void paintNumbers(QPainter& painter, const QString& text, QPointF cursor, const ViewFrame& view);

}  // namespace app
