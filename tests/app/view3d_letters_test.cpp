// Where the words over a 3D view stand.
#include <gtest/gtest.h>

#include <cmath>

#include "app/view3d/overlay.h"

// Three marks at the border beside each other, one behind the legend, and letters: every text inside the view, and
// none on another one, a mark or the legend.
TEST(View3dDrawing, CaptionsCoverNothing) {
    const glm::dvec2 size{400, 300};
    app::OrbitCamera camera;  // along y, from (0, −10, 0)
    camera.distance = 10;
    camera.orthographic = true;
    const app::ViewFrame view{camera, size};
    const double unit = camera.unitsPerPixel(size.y);
    const auto at = [&](double x, double y) { return app::Vec3d((x - 200) * unit, 0, (150 - y) * unit); };
    app::Drawing drawing;
    const auto caption = [&](const char* text, app::Vec3d p) {
        drawing.labels.push_back({.kind = app::Label::Kind::Caption,
                                  .at = p,
                                  .foot = {},
                                  .text = text,
                                  .distance = ", 730 units away",
                                  .ink = app::Ink::L});
    };
    caption("light 0, at infinity", at(330, 30));
    caption("eye", at(900, 20));
    caption("light 1", at(900, 40));
    caption("light 2", at(340, 44));
    caption("light 3", at(-50, 290));
    for (const double x : {300.0, 322.0})
        drawing.labels.push_back({.kind = app::Label::Kind::Letter,
                                  .at = at(x, 20),
                                  .foot = at(200, 150),
                                  .text = "L",
                                  .distance = {},
                                  .ink = app::Ink::L});
    // Where the letters are.
    drawing.labels.push_back({.kind = app::Label::Kind::Plane,
                              .at = at(300, 20),
                              .foot = at(200, 150),
                              .text = "(N·L) N",
                              .distance = {},
                              .ink = app::Ink::N});
    const QRectF legend(8, 250, 300, 42);
    const auto labels = app::placeLabels(drawing, view, {legend});
    ASSERT_EQ(labels.size(), 8u);
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const QRectF box = app::boxOf(labels[i]);
        EXPECT_TRUE(QRectF(0, 0, size.x, size.y).contains(box)) << labels[i].label.text;
        for (std::size_t k = 0; k < i; ++k)
            EXPECT_FALSE(box.intersects(app::boxOf(labels[k])))
                << labels[i].label.text << " on " << labels[k].label.text;
        if (labels[i].label.kind != app::Label::Kind::Caption) continue;
        EXPECT_FALSE(box.intersects(legend)) << labels[i].label.text;
        for (const app::PlacedLabel& other : labels)
            if (other.label.kind == app::Label::Kind::Caption) {
                EXPECT_FALSE(box.contains(QPointF(other.mark.x, other.mark.y))) << labels[i].label.text;
            }
    }
}

// The picture of the test above. A vector that leads out of the view, or behind the observer, is named where it leaves
// it; what lies on the view hides no letter; what is seen nowhere has none to be seen.
TEST(View3dDrawing, EveryVectorThatIsSeenHasItsLetter) {
    const glm::dvec2 size{400, 300};
    for (const bool orthographic : {true, false}) {
        app::OrbitCamera camera;
        camera.distance = 10;
        camera.orthographic = orthographic;
        const app::ViewFrame view{camera, size};
        const double unit = camera.unitsPerPixel(size.y);
        const auto at = [&](double x, double y) { return app::Vec3d((x - 200) * unit, 0, (150 - y) * unit); };
        app::Drawing drawing;
        const auto letter = [&](const char* text, app::Vec3d foot, app::Vec3d tip) {
            drawing.labels.push_back({.kind = app::Label::Kind::Letter,
                                      .at = tip,
                                      .foot = foot,
                                      .text = text,
                                      .distance = {},
                                      .ink = app::Ink::N});
        };
        letter("N", at(200, 150), at(210, -200));
        letter("L", at(200, 150), at(900, 100));
        letter("V", at(200, 150), at(60, 270));                           // under the legend
        letter("R", at(230, 150), at(230, 150) + app::Vec3d(3, -20, 0));  // past the observer of a perspective view
        letter("H", at(-300, -300), at(-400, -300));
        const QRectF legend(8, 250, 300, 42);
        const auto labels = app::placeLabels(drawing, view, {legend});
        ASSERT_EQ(labels.size(), 5u);
        const QRectF whole(0, 0, size.x, size.y);
        for (const app::PlacedLabel& placed : labels) {
            const QRectF box = app::boxOf(placed);
            EXPECT_EQ(whole.contains(box), placed.label.text != "H") << placed.label.text;
            EXPECT_FALSE(box.intersects(legend)) << placed.label.text;
        }
        // N leaves the view at 150/350 of its way, 4 pixels to the right of where it begins.
        EXPECT_NEAR(labels[0].at.x, 204.3, 30);
        EXPECT_LT(labels[0].at.y, 40);
        EXPECT_GT(labels[1].at.x, 360);
    }
}

// One row where there is room, else two; whatever it is, every entry has its place inside.
TEST(Legend, StaysInsideItsRoom) {
    using pipeline::VectorCode;
    const QSizeF row = app::legendSize(10000), rows = app::legendSize(row.width() - 1);
    EXPECT_LT(rows.width(), row.width());
    EXPECT_EQ(rows.height(), 2 * row.height());
    for (const QSizeF size : {row, rows}) {
        const QRectF legend(QPointF(8, 100), QSizeF(size.toSize()));
        QRectF last;
        for (const VectorCode code : {VectorCode::N, VectorCode::L, VectorCode::V, VectorCode::R, VectorCode::H}) {
            const QRectF entry = app::legendEntry(code, legend);
            EXPECT_GE(entry.left(), legend.left());
            EXPECT_LE(entry.left() + 0.8 * entry.width(), legend.right());  // the last part is a gap
            EXPECT_LE(entry.bottom(), legend.bottom() + 1);
            EXPECT_FALSE(entry.intersects(last.adjusted(1, 1, -1, -1)));
            last = entry;
        }
    }
}
