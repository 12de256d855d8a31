#pragma once
#include <QPainter>
#include <QString>
#include <optional>

#include "app/canvas/buffer_painter.h"

namespace app {

// How two pictures share a view: A keeps the part at the left, B has the rest.
struct Wipe {
    double share = 1;        // of the width, that A keeps: 1 all of it, 0 nothing
    bool hasHandle = false;  // that moves the border
    QString nameA, nameB;    // written at the top of each part; may be empty
    bool operator==(const Wipe&) const = default;

    int border(int width) const { return int(share * width + 0.5); }
};

// A, and what is seen right of the border where there is one.
struct CanvasPictures {
    CanvasContent a;
    std::optional<CanvasContent> b;
    Wipe wipe;
};

inline constexpr int kWipeHandle = 12;  // pixels wide

bool isOnHandle(const Wipe& wipe, QRect view, QPointF at);
// The names and the handle.
void paintWipe(QPainter& painter, const Wipe& wipe, QRect view);

}  // namespace app
