#include "app/canvas/canvas_placing.h"

#include <gtest/gtest.h>

#include <QWidget>
#include <cmath>

namespace app {
namespace {

TEST(CanvasPlacing, ZoomStepsAreWholeFromTwoUpAndReversible) {
    double zoom = 0.1;
    for (double next; (next = CanvasPlacing::nextZoom(zoom, 1)) != zoom; zoom = next) {
        EXPECT_GT(next, zoom);
        EXPECT_DOUBLE_EQ(CanvasPlacing::nextZoom(next, -1), zoom);
        if (next >= 2) {
            EXPECT_EQ(next, std::floor(next));
        }
    }
    EXPECT_GE(zoom, 72);
}

// What is worth looking at is near an edge of the picture. More of the picture fills the view, not what is beside it.
TEST(CanvasPlacing, FittingLeavesNoEmptyStripWhereThePictureGoesOn) {
    QWidget view;
    view.resize(600, 400);
    const QRectF picture(0, 0, 640, 480);
    for (const QRectF focus : {QRectF(300, 380, 100, 95), QRectF(5, 200, 60, 80), QRectF(560, 10, 75, 60)}) {
        CanvasPlacing placing(view);
        placing.setPicture(picture.size().toSize(), focus);
        const Placement at = placing.placement();
        const QRectF seen(at.toPicture({0, 0}), at.toPicture(QPointF(view.width(), view.height())));
        EXPECT_GE(at.zoom, 2);
        EXPECT_TRUE(seen.contains(focus)) << focus.x();
        EXPECT_TRUE(picture.contains(seen)) << focus.x();
    }
}

}  // namespace
}  // namespace app
