// No arrow, arc or ray runs through a label of a 3D view, and none is cut by the view's edge.
#include <gtest/gtest.h>

#include <cmath>

#include "app/drawing3d/label_places.h"
#include "app/drawing3d/obstacles.h"
#include "app/drawing3d/point_drawing.h"
#include "app/drawing3d/world_drawing.h"
#include "tests/app/view3d/view3d_fixture.h"

namespace {

using app::Drawing;
using app::Label;
using app::PlacedLabel;
using app::ViewFrame;
using view3d::contentOf;
using view3d::kRightFace;
using view3d::Vec3d;
using view3d::VectorArrow;
using view3d::ViewContent;

// A few views of the room that one or four of them have in a window.
constexpr glm::dvec2 kSizes[]{{380, 380}, {300, 220}, {640, 480}, {900, 420}, {400, 700}};

Label letter(const char* text, Vec3d foot, Vec3d tip) {
    return {.kind = Label::Kind::Letter, .at = tip, .foot = foot, .text = text, .distance = {}, .ink = app::Ink::N};
}

// How long a line is within a label's box, pixels; a line is 1 pixel wide.
double lengthWithin(const PlacedLabel& label, Vec3d a, Vec3d b, const ViewFrame& view) {
    const auto seen = seenPart(a, b, view);
    return seen && seen->a != seen->b ? covered(app::lineOutline(seen->a, seen->b, 1), boxOf(label)) : 0;
}

// Of all vectors, arcs and rays: what the drawing says is in the way, and its strong lines.
double crossedBy(const PlacedLabel& label, const Drawing& drawing, const ViewFrame& view) {
    double length = 0;
    for (const Label& other : drawing.labels)
        if (other.kind == Label::Kind::Letter) length += lengthWithin(label, other.foot, other.at, view);
    for (const app::Obstacle& obstacle : drawing.obstacles)
        if (obstacle.size() == 2) length += lengthWithin(label, obstacle[0], obstacle[1], view);
    for (const app::InkedLine& line : drawing.lines)
        if (line.ink == app::Ink::Text || line.ink == app::Ink::V) length += lengthWithin(label, line.a, line.b, view);
    return length;
}

}  // namespace

// At every pixel of a row and from all sides.
TEST(View3dPlaces, NoArrowOrArcRunsThroughALabelAtThePoint) {
    for (const glm::ivec2 pixel : {kRightFace, glm::ivec2(230, 300), glm::ivec2(300, 240)}) {
        const ViewContent world = contentOf(test::pyramid(), pixel);
        const auto point = app::pointContent(world);
        if (!point) continue;
        for (const glm::dvec2 size : kSizes)
            for (int degrees = 0; degrees < 360; degrees += 20) {
                app::OrbitCamera camera = app::pointCamera(app::ViewPreset::Iso, *point, {}, size, false);
                app::orbit(camera, degrees, 0);
                const ViewFrame view{camera, size};
                const Drawing drawing = app::drawPoint(*point, {}, view);
                for (const PlacedLabel& placed : placeLabels(drawing, view)) {
                    // A corner of a box may be touched; what runs through it is longer.
                    EXPECT_LT(crossedBy(placed, drawing, view), 6)
                        << placed.label.text << " at " << size.x << " x " << size.y << ", " << degrees << "°";
                    EXPECT_TRUE(QRectF(0, 0, size.x, size.y).contains(boxOf(placed))) << placed.label.text;
                }
            }
    }
}

// V runs through where R's letter would be if it only stood beyond its tip.
TEST(View3dPlaces, ALetterStandsBesideTheArrowBeyondItsTip) {
    const glm::dvec2 size{400, 300};
    app::OrbitCamera camera;
    camera.distance = 10;
    camera.orthographic = true;
    const ViewFrame view{camera, size};
    const double unit = camera.unitsPerPixel(size.y);
    const auto at = [&](double x, double y) { return Vec3d((x - 200) * unit, 0, (150 - y) * unit); };
    Drawing drawing;
    drawing.labels = {letter("R", at(200, 250), at(200, 120)), letter("V", at(120, 100), at(300, 100))};
    for (const PlacedLabel& placed : placeLabels(drawing, view)) {
        EXPECT_EQ(crossedBy(placed, drawing, view), 0) << placed.label.text;
        EXPECT_LT(glm::length(app::nearest(boxOf(placed), placed.mark) - placed.mark), 40) << placed.label.text;
    }
}

// Around the view's border in steps of 3 pixels, within it and beyond it: half a letter is never seen.
TEST(View3dPlaces, ALetterIsWholeWhereverItsTipIs) {
    const glm::dvec2 size{400, 300};
    for (const double scale : {1.0, 2.0}) {
        app::OrbitCamera camera;
        camera.distance = 10;
        camera.orthographic = true;
        const ViewFrame view{camera, size, scale};
        const double unit = camera.unitsPerPixel(size.y);
        const auto at = [&](double x, double y) { return Vec3d((x - 200) * unit, 0, (150 - y) * unit); };
        const QRectF whole(0, 0, size.x, size.y);
        for (double x = -40; x <= 440; x += 3)
            for (const double y : {-30.0, -3.0, 2.0, 9.0, 150.0, 291.0, 299.0, 306.0})
                for (const bool fromOutside : {false, true}) {
                    Drawing drawing;
                    drawing.labels = {letter("R", fromOutside ? at(480, 150) : at(200, 150), at(x, y))};
                    const bool isSeen = seenPart(drawing.labels[0].foot, drawing.labels[0].at, view).has_value();
                    const auto labels = placeLabels(drawing, view);
                    ASSERT_EQ(labels.size(), isSeen ? 1u : 0u) << x << ' ' << y;
                    if (isSeen) {
                        EXPECT_TRUE(whole.contains(boxOf(labels[0]))) << x << ' ' << y;
                    }
                }
    }
}

// In the world, with its axes and its rays: from all sides.
TEST(View3dPlaces, LettersAndCaptionsKeepOffArrowsAndRays) {
    const ViewContent content = contentOf(test::pyramid(), kRightFace);
    int labels = 0, crossed = 0;
    for (const glm::dvec2 size : kSizes)
        for (int degrees = 0; degrees < 360; degrees += 10) {
            app::OrbitCamera camera = app::presetCamera(app::ViewPreset::Iso, content, {}, size, false);
            app::orbit(camera, degrees, 0);
            const ViewFrame view{camera, size};
            const Drawing drawing = app::drawWorld(content, {}, view);
            for (const PlacedLabel& placed : placeLabels(drawing, view)) {
                if (placed.label.kind != Label::Kind::Letter && placed.label.kind != Label::Kind::Caption) continue;
                ++labels;
                if (crossedBy(placed, drawing, view) > 6) ++crossed;
            }
        }
    ASSERT_GT(labels, 1000);
    EXPECT_LT(crossed, labels / 100) << "of " << labels;
}
