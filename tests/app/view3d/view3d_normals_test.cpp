// Which normals a 3D view shows, and how long.
#include <QAccessible>
#include <QLabel>
#include <QLayout>
#include <QSignalSpy>
#include <QSlider>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <utility>

#include "app/drawing3d/normal_arrows.h"
#include "app/drawing3d/space_content.h"
#include "app/look/theme.h"
#include "app/view3d/view_settings.h"
#include "tests/app/view3d/shown_view3d.h"
#include "tests/app/view3d/view3d_fixture.h"

namespace {

using app::NormalArrow;
using app::Vec3d;
using app::ViewContent;
using app::ViewOptions;

// 10 000 at most, whatever was asked for.
TEST(View3dNormals, OfADenseMeshSomeAreLeftOut) {
    app::ViewOptions options;
    EXPECT_EQ(options.everyOf(10000), 1u);
    EXPECT_EQ(options.everyOf(10001), 2u);
    EXPECT_EQ(options.everyOf(1002528), 101u) << "9 926 of them";
    options.everyNormal = 500;
    EXPECT_EQ(options.everyOf(1002528), 500u);
}

// A floor of 2 polygons, a box of 6 and a ball of 800, whose radii are √50, 1 and 0.5: the box around all of them is
// 10 × 10 × 2, its radius √204 / 2 = 7.14.
ViewContent boxAndBallOnFloor() {
    pipeline::Scene scene;
    scene.camera.kind = pipeline::CameraKind::LookAt;
    scene.camera.eye = {0, -20, 10};
    const auto add = [&](std::shared_ptr<const pipeline::Mesh> mesh, Vec3d at) {
        pipeline::Object object;
        object.mesh = std::move(mesh);
        object.transform.translation = at;
        scene.objects.push_back(object);
    };
    add(test::mesh({{-5, -5, 0}, {5, -5, 0}, {5, 5, 0}, {-5, 5, 0}}, {{0, 1, 2}, {0, 2, 3}}), Vec3d(0.0));
    const double half = 1 / std::sqrt(3.0);
    add(test::box(Vec3d(-half), Vec3d(half)), {-2, 0, 1});
    add(test::sphere(0.5, 20, 40), {2, 0, 1.5});
    return view3d::contentOf(scene);
}

std::vector<NormalArrow> of(const std::vector<NormalArrow>& arrows, std::uint32_t object) {
    std::vector<NormalArrow> own;
    std::ranges::copy_if(arrows, std::back_inserter(own), [&](const NormalArrow& a) { return a.object == object; });
    return own;
}

// An object that fills 7 % of the scene has 20 of its 800 normals, not as many as a model that fills the view; and the
// thinning leaves objects of few polygons theirs.
TEST(View3dNormals, ASmallBallIsNotCovered) {
    const ViewContent content = boxAndBallOnFloor();
    ViewOptions options;
    makeNormalsReadable(content, options);
    EXPECT_EQ(options.everyNormal, 40);
    const auto shown = shownNormals(content, options);
    EXPECT_EQ(of(shown, 0).size(), 2u);
    EXPECT_EQ(of(shown, 1).size(), 6u);
    EXPECT_NEAR(double(of(shown, 2).size()), 20, 2);
}

// In proportion to objects smaller than a third of the scene, but not below 30 %: 3 · 1 / 7.14 = 0.42, 3 · 0.5 / 7.14 =
// 0.21. In another space they are as long.
TEST(View3dNormals, OnASmallObjectTheyAreShorter) {
    const ViewContent content = boxAndBallOnFloor();
    const auto map = mapOf(content, {app::ViewSpace::Eye});
    ASSERT_TRUE(map);
    for (const ViewContent& shownIn : {content, inSpace(content, *map)}) {
        const auto shown = shownNormals(shownIn, {});
        for (const NormalArrow& arrow : of(shown, 0)) EXPECT_EQ(arrow.length, 1);
        for (const NormalArrow& arrow : of(shown, 1)) EXPECT_NEAR(arrow.length, 0.42, 0.005);
        for (const NormalArrow& arrow : of(shown, 2)) EXPECT_NEAR(arrow.length, 0.3, 1e-9);
    }
}

// All of the lecture's pyramid, in full length.
TEST(View3dNormals, FewOfThemAreAllShown) {
    const ViewContent content = view3d::contentOf(test::pyramid());
    ViewOptions options;
    options.normalLength = 7;
    makeNormalsReadable(content, options);
    EXPECT_EQ(options.everyNormal, 1);
    EXPECT_EQ(options.normalLength, 40);
    const auto shown = shownNormals(content, options);
    ASSERT_EQ(shown.size(), 5u);
    for (const NormalArrow& arrow : shown) EXPECT_EQ(arrow.length, 1);
    options.normals = app::NormalsShown::Off;
    EXPECT_TRUE(shownNormals(content, options).empty());
}

// Of a ball of thousands of polygons 150 or so are readable. A state that asks for nothing shows those, also in a view that
// was hidden while the scene was opened; a state that asks for all of them gets them.
using View3dHidden = ShownView3d;
TEST_F(View3dHidden, NormalsAreThinnedOnceTheViewIsShown) {
    panel.hide();
    pipeline::Scene scene = test::pyramid();
    scene.objects[0].mesh = pipeline::makeShape({.kind = pipeline::ShapeKind::Sphere, .tessellation = 31});
    scene.objects[0].transform.scale = Vec3d(100.0);
    QSignalSpy ready(&document.frames(), &app::FrameFeed::frameReady);
    document.setScene(scene);
    ASSERT_TRUE(ready.wait());
    EXPECT_TRUE(panel.lookAt({}).empty());
    panel.show();
    ASSERT_TRUE(QTest::qWaitFor([&] { return view.space().content() != nullptr; }, 20000));
    const int every = view.options().everyNormal;
    EXPECT_GT(every, 10);
    EXPECT_TRUE(panel.state().options.empty()) << "nothing was chosen";
    lessons::SpaceShown all;
    all.options["every_normal"] = 1;
    EXPECT_TRUE(panel.lookAt(all).empty());
    EXPECT_EQ(view.options().everyNormal, 1);
    EXPECT_EQ(panel.state().options.at("every_normal"), 1);
    EXPECT_TRUE(panel.lookAt({}).empty());
    EXPECT_EQ(view.options().everyNormal, every);
}

// A screen reader is told what stands beside a slider, and sets it; what is between two steps of the slider stays.
TEST(View3dNormals, SlidersSpeakTheirNumbers) {
    app::ViewSettings settings;
    ViewOptions options;
    options.normalLength = 29;
    options.everyNormal = 33;
    settings.setOptions(options);
    const auto numbers = [&](const char* name) {
        for (QSlider* slider : settings.findChildren<QSlider*>())
            if (slider->accessibleName() == name)
                return QAccessible::queryAccessibleInterface(slider)->valueInterface();
        return static_cast<QAccessibleValueInterface*>(nullptr);
    };
    ASSERT_TRUE(numbers("Length") && numbers("Show every k-th normal"));
    EXPECT_EQ(numbers("Length")->currentValue().toDouble(), 29);
    EXPECT_EQ(numbers("Length")->minimumValue().toDouble(), 4);
    EXPECT_EQ(numbers("Length")->maximumValue().toDouble(), 400);
    EXPECT_EQ(numbers("Show every k-th normal")->currentValue().toDouble(), 33);
    QSignalSpy changed(&settings, &app::ViewSettings::changed);
    numbers("Length")->setCurrentValue(40);
    ASSERT_EQ(changed.count(), 1);
    const auto set = changed[0][0].value<ViewOptions>();
    EXPECT_EQ(set.normalLength, 40);  // half way from 4 to 400 by factors
    EXPECT_EQ(set.everyNormal, 33);
}

// The popup lives as long as its view: made before the letters grew it looks as one that is made afterwards.
TEST(View3dNormals, SettingsFollowTheLettersSize) {
    app::ViewSettings old;
    old.show();
    app::Theme::current().setScale(2);
    app::ViewSettings made;
    made.show();
    const auto look = [](app::ViewSettings& settings) {
        settings.adjustSize();
        std::vector<int> sizes{settings.width(), settings.height(), settings.layout()->contentsMargins().left()};
        for (const QLabel* label : settings.findChildren<QLabel*>())
            sizes.push_back(QFontInfo(label->font()).pixelSize());
        return sizes;
    };
    EXPECT_EQ(look(old), look(made));
    app::Theme::current().setScale(1);
}

using View3dNormalsShown = ShownView3d;

// Arrows are made once for all frames, and keep no colour of the theme that they were made in.
TEST_F(View3dNormalsShown, TheyTakeTheColourOfAnotherTheme) {
    openPyramid();
    const QColor before = app::Theme::current().colors().N;
    // Once the picture rests: two in turn are alike.
    const auto count = [&](QColor color) {
        QImage image;
        EXPECT_TRUE(QTest::qWaitFor(
            [&] { return waitUntilDrawn() && std::exchange(image, panel.grab().toImage()) == image; }, 20000));
        int found = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x) {
                const QRgb at = image.pixel(x, y);
                found += std::abs(qRed(at) - color.red()) <= 3 && std::abs(qGreen(at) - color.green()) <= 3 &&
                         std::abs(qBlue(at) - color.blue()) <= 3;
            }
        return found;
    };
    const int arrows = count(before);
    ASSERT_GT(arrows, 50);
    app::Theme::current().set(app::ThemeId::Dark);
    EXPECT_GT(count(app::Theme::current().colors().N), arrows / 2);
    EXPECT_LT(count(before), arrows / 10);
    app::Theme::current().set(app::ThemeId::Light);
}

}  // namespace
