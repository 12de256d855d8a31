// Where the words over a 3D view stand.
#include <gtest/gtest.h>

#include <QImage>

#include <algorithm>
#include <cmath>

#include "app/drawing3d/label_words.h"
#include "app/drawing3d/obstacles.h"
#include "app/drawing3d/overlay.h"
#include "app/look/theme.h"

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
// it; what lies on the view hides no letter; what is seen nowhere has none.
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
        ASSERT_EQ(labels.size(), 4u) << "all but H";
        const QRectF whole(0, 0, size.x, size.y);
        for (const app::PlacedLabel& placed : labels) {
            const QRectF box = app::boxOf(placed);
            EXPECT_TRUE(whole.contains(box)) << placed.label.text;
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

namespace {

QImage painted(QSize size, const auto& paint) {
    QImage image(size, QImage::Format_RGB32);
    image.fill(app::Theme::current().colors().surface);
    QPainter painter(&image);
    paint(painter);
    return image;
}

// Everything about letters twice as large; the usual size again afterwards.
struct LettersOfScale {
    explicit LettersOfScale(double scale) { app::Theme::current().setScale(scale); }
    ~LettersOfScale() { app::Theme::current().setScale(1); }
};

}  // namespace

// Four times the pixels at twice the size, the shaft's width and the tip as well as its length.
TEST(Legend, AVectorsSampleGrowsWithItsLetter) {
    using pipeline::VectorCode;
    for (const VectorCode code : {VectorCode::N, VectorCode::L, VectorCode::V, VectorCode::R, VectorCode::H}) {
        const auto ink = [&](double scale) {
            const LettersOfScale letters(scale);
            const QSize size = (scale * QSizeF(31, 32)).toSize();  // beside the letter
            const QImage image = painted(size, [&](QPainter& painter) {
                app::paintVectorSample(painter, QRectF(QPointF(), scale * QSizeF(62, 32)), code, true);
            });
            double sum = 0;
            for (int y = 0; y < size.height(); ++y)
                for (int x = 0; x < size.width(); ++x)
                    sum += std::abs(qGreen(image.pixel(x, y)) - app::Theme::current().colors().surface.green());
            return sum;
        };
        EXPECT_NEAR(ink(2) / ink(1), 4, 0.2) << int(code);
    }
}

// Screen space's y axis points down, so that the letter above is "−y": two signs, which need their room.
TEST(Legend, TheCubesLettersAreWholeAtAnySize) {
    for (const double scale : {1.0, 2.0}) {
        const LettersOfScale letters(scale);
        const int side = app::Theme::current().px(56);
        app::OrbitCamera camera;
        app::lookAlong(camera, {0, 0, -1});
        const QImage image = painted({side, side}, [&](QPainter& painter) {
            app::paintCube(painter, QRectF(0, 0, side, side), camera, app::ViewSpace::Screen);
        });
        QFont font = app::Theme::current().formula(13);
        font.setItalic(true);
        const double width =
            QFontMetricsF(font).tightBoundingRect(app::letterOf(app::CubeFace::Z, app::ViewSpace::Screen)).width();
        // Inside the face's border.
        const int border = int(0.27 * side - 4 * scale), middle = side / 2;
        int left = side, right = 0;
        for (int y = middle - border; y <= middle + border; ++y)
            for (int x = middle - border; x <= middle + border; ++x)
                if (qGray(image.pixel(x, y)) < 128) left = std::min(left, x), right = std::max(right, x);
        EXPECT_NEAR(right - left + 1, width, 2) << scale;
    }
}

namespace {

// Looks along y; a pixel is `unit` world units.
app::ViewFrame frameOf(glm::dvec2 size) {
    app::OrbitCamera camera;
    camera.distance = 10;
    camera.orthographic = true;
    return {camera, size};
}

// A cube around the origin.
app::Obstacle cube(double half) {
    app::Obstacle corners;
    for (unsigned i = 0; i < 8; ++i)
        corners.push_back({i & 1 ? half : -half, i & 2 ? half : -half, i & 4 ? half : -half});
    return corners;
}

app::Label captionAt(app::Vec3d at, const char* text) {
    return {.kind = app::Label::Kind::Caption, .at = at, .foot = {}, .text = text, .distance = {}, .ink = app::Ink::L};
}

}  // namespace

// Seen along an axis a cube 100 pixels wide covers 100 · 100 pixels, the quarter that a box leaves of it 50 · 50; a line
// is taken for 14 pixels wide.
TEST(View3dLabels, AnObstacleCoversWhatItLooksLike) {
    const app::ViewFrame view = frameOf({400, 300});
    const double unit = view.camera.unitsPerPixel(300);
    const auto outline = outlineOf(cube(50 * unit), view);
    ASSERT_TRUE(outline);
    EXPECT_NEAR(covered(*outline, QRectF(0, 0, 400, 300)), 10000, 1e-6);
    EXPECT_NEAR(covered(*outline, QRectF(200, 150, 200, 150)), 2500, 1e-6);
    EXPECT_EQ(covered(*outline, QRectF(0, 0, 100, 300)), 0);
    const auto line = outlineOf({app::Vec3d(-30 * unit, 0, 0), app::Vec3d(30 * unit, 0, 0)}, view);
    ASSERT_TRUE(line);
    EXPECT_NEAR(covered(*line, QRectF(0, 0, 400, 300)), 60 * 14, 1e-6);
    // One point of it before the observer is no line.
    app::ViewFrame near = view;
    near.camera.orthographic = false;
    EXPECT_FALSE(outlineOf({app::Vec3d(0.0), app::Vec3d(0, -20, 0)}, near));
}

// As in the equation: a vector's letter is bold and leans, a word and a number do neither, an exponent is small and high,
// an index small and low. Where the text has no letter of a vector it is what its font draws.
TEST(View3dLabels, FormulasAreSetLikeTheEquation) {
    const auto label = [](app::Label::Kind kind, const char* text) {
        return app::Label{.kind = kind, .at = {}, .foot = {}, .text = text, .distance = {}};
    };
    const QFont upright = app::Theme::current().formula(15);
    QFont leaning = upright;
    leaning.setItalic(true), leaning.setBold(true);
    const auto drawn = [](const QFont& font, const char* text) {
        QPainterPath path;
        path.addText(0, 0, font, text);
        return path;
    };
    using Kind = app::Label::Kind;
    EXPECT_EQ(pathOf(label(Kind::Plane, "near 45.2")), drawn(upright, "near 45.2"));
    EXPECT_EQ(pathOf(label(Kind::Angle, "NL")), drawn(leaning, "NL"));
    EXPECT_NE(drawn(leaning, "NL"), drawn(upright, "NL"));
    const QRectF power = pathOf(label(Kind::Plane, "V^8")).boundingRect(), base = drawn(leaning, "V").boundingRect();
    EXPECT_LT(power.top(), base.top()) << "above the letter";
    EXPECT_GT(power.right(), base.right());
    const QRectF index = pathOf(label(Kind::Letter, "L₁")).boundingRect();
    EXPECT_GT(index.bottom(), pathOf(label(Kind::Letter, "L")).boundingRect().bottom() + 2) << "below the line";
}

// Wherever its mark is on a cube or beside it: there is room within 60 pixels for a caption that is 45 wide and 15 high.
// It may stay nearer and touch it with less than a fifth of itself.
TEST(View3dLabels, WordsKeepOffObjects) {
    const app::ViewFrame view = frameOf({400, 300});
    const double unit = view.camera.unitsPerPixel(300);
    app::Drawing drawing;
    drawing.obstacles.push_back(cube(20 * unit));
    const auto outline = outlineOf(drawing.obstacles.front(), view);
    for (int x = -80; x <= 80; x += 8)
        for (int z = -80; z <= 80; z += 8) {
            drawing.labels = {captionAt(unit * app::Vec3d(x, 0, z), "light 0")};
            const auto labels = placeLabels(drawing, view);
            // What stands away from its mark is led there.
            const QRectF box = boxOf(labels.front());
            EXPECT_LT(covered(*outline, box), 0.2 * box.width() * box.height()) << x << ' ' << z;
            const glm::dvec2 mark = labels.front().mark;
            const double away = std::hypot(std::max({box.left() - mark.x, mark.x - box.right(), 0.0}),
                                           std::max({box.top() - mark.y, mark.y - box.bottom(), 0.0}));
            EXPECT_EQ(labels.front().led, away > 24) << x << ' ' << z;
            EXPECT_LT(away, 60) << x << ' ' << z;
        }
}

// A turn in steps of 1°: words go with their marks as long as their place is the same, and when they have taken another
// one, a step back does not bring them back.
TEST(View3dLabels, PlacesDoNotFlicker) {
    const glm::dvec2 size{400, 300};
    app::ViewFrame view = frameOf(size);
    const double unit = view.camera.unitsPerPixel(size.y);
    app::Drawing drawing;
    drawing.obstacles.push_back(cube(40 * unit));
    drawing.labels = {captionAt(unit * app::Vec3d(70, 0, 30), "light 0, at infinity"),
                      captionAt(unit * app::Vec3d(-30, 60, 50), "light 1"),
                      captionAt(unit * app::Vec3d(0, 90, 0), "eye")};
    std::vector<app::PlacedLabel> before = placeLabels(drawing, view);
    int changes = 0;
    for (int degree = 0; degree < 360; ++degree) {
        const app::ViewFrame last = view;
        orbit(view.camera, 1, 0);
        const auto now = placeLabels(drawing, view, {}, before);
        const auto again = placeLabels(drawing, last, {}, now);
        for (std::size_t i = 0; i < now.size(); ++i) {
            const glm::dvec2 moved = (now[i].at - now[i].mark) - (before[i].at - before[i].mark);
            if (now[i].place == before[i].place)
                EXPECT_LT(glm::length(moved), 1e-6) << degree;
            else
                ++changes;
            EXPECT_EQ(again[i].place, now[i].place) << degree;
        }
        before = now;
    }
    // Each of the three comes before the cube and behind it.
    EXPECT_GE(changes, 3);
    EXPECT_LE(changes, 30);
}
