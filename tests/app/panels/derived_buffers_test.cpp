// Buffers that are made of a frame: on show, compared, kept.
#include "app/frames/derived_buffers.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QClipboard>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "app/buffer_view/buffer_copies.h"
#include "app/buffer_view/buffer_view.h"
#include "app/canvas/buffer_canvas.h"
#include "app/canvas/condition_bar.h"
#include "app/canvas/state_picture.h"
#include "app/compare/buffer_compare.h"
#include "app/document/document_state.h"
#include "app/document/own_file.h"
#include "app/frames/copied_value.h"
#include "app/frames/mix_model.h"
#include "pipeline/run/runner.h"
#include "pipeline/scene/settings_table.h"
#include "pipeline/scene/view.h"
#include "tests/support/files.h"
#include "tests/support/scenes.h"

namespace {

using app::BufferView;
using app::Document;
using pipeline::BufferId;
using pipeline::BufferName;

constexpr BufferName kMix{BufferId::Mix}, kCondition{BufferId::Condition}, kExpression{BufferId::Expression};
const BufferName kVerdicts{BufferId::ShadowVerdict, 0};

struct DerivedBuffersTest : testing::Test {
    Document document;
    BufferView view{document};

    DerivedBuffersTest() {
        pipeline::Scene scene = test::boxOverGround();
        scene.lights[0].position = {1, -0.5, 1};
        scene.settings.width = 160, scene.settings.height = 120;
        scene.settings.shadowSize = 64;
        scene.settings.shadowBias = pipeline::ShadowBias::Constant;
        view.resize(600, 500);
        view.show();
        document.setScene(scene);
        EXPECT_TRUE(QTest::qWaitFor([&] { return document.frames().shown() != nullptr; }, 10000));
    }
    bool shows(const BufferName& name) {
        return QTest::qWaitFor([&] { return view.shown() && view.shown()->buffer.name == name; }, 20000);
    }
    pipeline::AnyBuffer of(const BufferName& name) const { return *document.frames().shown()->buffer(name); }
};

TEST_F(DerivedBuffersTest, VerdictsHaveNamesALegendAndAReadout) {
    view.setBuffer(kVerdicts);
    ASSERT_TRUE(shows(kVerdicts));
    ASSERT_FALSE(view.shown()->legend.empty());
    EXPECT_TRUE(view.shown()->legend[0].text.startsWith("lit, "));
    EXPECT_TRUE(std::ranges::any_of(view.shown()->legend, [](const auto& e) { return e.text.startsWith("acne, "); }));
    EXPECT_EQ(app::elementText(view.shown()->buffer, 0, 0, lessons::ShownChannel::All), QStringList{"none"})
        << "the background";
    // Without a light that casts a shadow there is none, and the view says so.
    document.change(*pipeline::findSetting(document.scene(), "light.0.shadow"), 0);
    EXPECT_TRUE(QTest::qWaitFor([&] { return view.message() == "Light 0 casts no shadow."; }, 10000));
}

// The reference is the matrix that GLM makes as OpenGL's documents say: z and w of (0, 0, -z_view, 1).
TEST_F(DerivedBuffersTest, ZInDeviceCoordinatesIsThatOfTheProjectionMatrix) {
    constexpr BufferName kZNdc{BufferId::ZNdc};
    for (const double projection : {0, 1}) {  // perspective, orthographic
        document.change(*pipeline::findSetting(document.scene(), "camera.projection"), projection);
        view.setBuffer(kZNdc);
        ASSERT_TRUE(shows(kZNdc));
        const auto isCurrent = [&] {
            return !document.frames().busy() && view.isCurrent() && view.frame() == document.frames().shown();
        };
        ASSERT_TRUE(QTest::qWaitFor(isCurrent, 10000));
        const pipeline::View eye = makeView(document.scene());
        const glm::dmat4 matrix = eye.perspective ? glm::perspectiveRH_NO(1.0, 1.0, eye.near, eye.far)
                                                  : glm::orthoRH_NO(-1.0, 1.0, -1.0, 1.0, eye.near, eye.far);
        const pipeline::AnyBuffer zView = of({BufferId::ZView}), &found = view.shown()->buffer;
        ASSERT_EQ(found.shape, zView.shape);
        std::size_t drawn = 0;
        for (std::size_t i = 0; i < zView.count(); ++i) {
            if (std::isinf(zView.flat(i))) {
                EXPECT_EQ(found.flat(i), INFINITY);
                continue;
            }
            ++drawn;
            const glm::dvec4 clip = matrix * glm::dvec4(0, 0, -zView.flat(i), 1);
            EXPECT_NEAR(found.flat(i), clip.z / clip.w, 1e-6) << i;  // 2^-24 of float, and of the matrix's differences
            EXPECT_LE(std::abs(found.flat(i)), 1.0000002);
        }
        EXPECT_GT(drawn, 1000u);
    }
    EXPECT_EQ(view.shown()->look.range.first, view.shown()->numbers.min) << "the nearest is lightest";
}

TEST_F(DerivedBuffersTest, RaysCanBeCancelledAndCastAgain) {
    const auto frame =
        runFrame(document.frames().shown()->sharedScene(),
                 {.wanted = pipeline::setOf({BufferId::Shadow, BufferId::ObjectId}), .stop = {}}, nullptr);
    app::DerivedJob job;
    job.ask(frame, kVerdicts, {});
    EXPECT_TRUE(job.busy());
    job.cancel();
    EXPECT_FALSE(job.busy());
    EXPECT_EQ(job.why(), "Cancelled.");
    job.ask(frame, kVerdicts, {});
    EXPECT_FALSE(job.busy()) << "what was cancelled does not begin by itself";
    job.retry();
    EXPECT_TRUE(QTest::qWaitFor([&] { return job.made().has_value(); }, 20000));
}

// 1 exactly where the first object is seen.
TEST_F(DerivedBuffersTest, AConditionIsABuffer) {
    view.setBuffer(kCondition);
    EXPECT_FALSE(view.condition().isHidden()) << "where its text is typed";
    EXPECT_EQ(view.message(), "Type a condition or an expression below.");
    view.condition().setText("object_id == 0");
    ASSERT_TRUE(shows(kCondition));
    const auto ids = of({BufferId::ObjectId});
    for (std::size_t i = 0; i < ids.count(); ++i)
        ASSERT_EQ(view.shown()->buffer.flat(i), ids.flat(i) == 0 ? 1 : 0) << i;
    // The same text as numbers is none.
    view.setBuffer(kExpression);
    EXPECT_TRUE(QTest::qWaitFor([&] { return view.message().contains("expected a number"); }, 10000));
}

TEST_F(DerivedBuffersTest, AnExpressionIsABufferOfNumbers) {
    view.setBuffer(kExpression);
    view.condition().setText("x + 1000 * y");
    ASSERT_TRUE(shows(kExpression));
    const auto ids = of({BufferId::ObjectId});
    const auto width = std::size_t(document.scene().settings.width);
    for (std::size_t i = 0; i < ids.count(); ++i)
        ASSERT_EQ(view.shown()->buffer.flat(i), ids.flat(i) < 0 ? 0 : double(i % width + 1000 * (i / width))) << i;
    EXPECT_FALSE(view.shown()->scale.histogram.empty());
    EXPECT_TRUE(view.condition().said().contains("expression"));
}

// Ambient alone is not the frame buffer; compared with it, B is the frame's own.
TEST_F(DerivedBuffersTest, TheMixStandsAgainstTheFrameBuffer) {
    document.mixer().set(*pipeline::parseMix("ambient=solo", 1));
    view.setBuffer(kMix);
    ASSERT_TRUE(shows(kMix));
    view.compare().compareWith(
        app::OtherSource{.kind = app::OtherSource::Kind::Buffer, .buffer = BufferName{BufferId::Color}});
    ASSERT_TRUE(QTest::qWaitFor([&] { return view.compare().difference().found().has_value(); }, 10000));
    const auto color = of({BufferId::Color});
    std::size_t differ = 0;
    const auto& mixed = view.shown()->buffer;
    ASSERT_EQ(mixed.name, kMix);
    for (std::size_t i = 0; i < color.rows() * color.columns(); ++i) {
        bool same = true;
        for (std::size_t c = 0; c < 3; ++c) same = same && color.flat(3 * i + c) == mixed.flat(3 * i + c);
        differ += !same;
    }
    EXPECT_GT(differ, 0u);
    EXPECT_EQ(view.compare().difference().found()->differing, differ);
}

// Two views, the frame buffer and the mix: the first one shows what the frame buffer holds.
TEST_F(DerivedBuffersTest, TheFrameBufferIsAsItIsBesideAViewOfTheMix) {
    const auto isMixed = [&] { return view.shown() && view.shown()->buffer.name == kMix; };
    view.setBuffer({BufferId::Color});
    ASSERT_TRUE(
        QTest::qWaitFor([&] { return view.shown() && view.shown()->buffer.name.id == BufferId::Color; }, 10000));
    const QImage plain = view.canvas()->content().image;
    document.mixer().set(*pipeline::parseMix("ambient=solo", 1));
    ASSERT_TRUE(QTest::qWaitFor([&] { return view.canvas()->content().image != plain; }, 10000));
    const QImage mixed = view.canvas()->content().image;
    auto beside = std::make_unique<app::BufferView>(document);
    beside->show();
    beside->setBuffer(kMix);
    ASSERT_TRUE(QTest::qWaitFor([&] { return beside->shown() && beside->shown()->buffer.name == kMix; }, 10000));
    EXPECT_FALSE(isMixed());
    EXPECT_TRUE(QTest::qWaitFor([&] { return view.canvas()->content().image == plain; }, 10000));
    beside.reset();
    EXPECT_TRUE(QTest::qWaitFor([&] { return view.canvas()->content().image == mixed; }, 10000)) << "alone again";
}

// The verdicts of the scene before the last change: rays of another frame.
TEST_F(DerivedBuffersTest, IsComparedWithTheSceneBefore) {
    view.setBuffer(kVerdicts);
    ASSERT_TRUE(shows(kVerdicts));
    document.change(*pipeline::findSetting(document.scene(), "shadow.bias_value"), 50);
    view.compare().compareWith(app::OtherSource{.kind = app::OtherSource::Kind::Before});
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return view.compare().difference().found() && view.compare().difference().found()->differing > 100; },
        30000))
        << "a bias larger than the scene turns acne and shadows into light";
}

TEST_F(DerivedBuffersTest, StatesRememberTextMixAndVeil) {
    view.condition().open();
    view.condition().setText("x < 80");
    document.mixer().set(*pipeline::parseMix("ambient=solo,diffuse.0=2", 1));
    view.setBuffer(kVerdicts);
    lessons::WindowState state = *app::stateOf(document, {});
    state.views = {view.state()};
    EXPECT_EQ(state.condition, "x < 80");
    EXPECT_EQ(state.mix, "ambient=solo,diffuse.0=2");
    const auto read = lessons::readState(toToml(state), "state.toml");
    ASSERT_TRUE(read);
    EXPECT_EQ(*read, state);

    document.derived().setText({});
    document.mixer().reset();
    view.condition().close();
    view.setBuffer({BufferId::Color});
    app::showPlace(document, *read);
    EXPECT_TRUE(view.lookAt(read->views[0]).empty());
    EXPECT_EQ(view.buffer(), kVerdicts);
    EXPECT_EQ(view.state(), state.views[0]);
    EXPECT_EQ(document.derived().text(), "x < 80");
    EXPECT_EQ(mixText(document.mixer().mix()), state.mix);
}

// A state's picture is that of the view: the half for which the condition holds is white.
TEST_F(DerivedBuffersTest, APictureOfAStateShowsIt) {
    lessons::WindowState state;
    state.condition = "y < 60";
    state.views = {lessons::BufferShown{.buffer = "condition"}};
    const auto frame = app::frameOf(state, document.frames().shown()->sharedScene());
    const QImage image = app::pictureOf(*frame, state, state.views[0], {.size = {160, 120}, .marks = false});
    ASSERT_FALSE(image.isNull());
    std::size_t white = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) white += image.pixel(x, y) == qRgb(255, 255, 255);
    EXPECT_GT(white, 100u);
}

TEST_F(DerivedBuffersTest, CopiesAValueWithAllItsDigits) {
    EXPECT_EQ(view.features().copies->whyNoValue(), "Pick a pixel first.");
    document.pointing().pick(glm::ivec2(80, 60));
    view.setBuffer({BufferId::ZView});
    ASSERT_TRUE(shows({BufferId::ZView}));
    ASSERT_EQ(view.features().copies->whyNoValue(), "");
    view.features().copies->copyValue();
    const QString copied = QApplication::clipboard()->text();
    ASSERT_TRUE(copied.startsWith("z_view at 80, 60: ")) << copied.toStdString();
    const auto z = of({BufferId::ZView});
    const double value = z.value(80, 60);
    EXPECT_EQ(copied.section(": ", 1).toFloat(), float(value)) << "gives back the very number";
    view.setBuffer({BufferId::PolygonsVerdict});
    EXPECT_TRUE(QTest::qWaitFor([&] { return view.features().copies->whyNoValue().contains("has no pixels"); }, 10000));
}

// The scene is ahead of its frame, by as long as that takes to compute.
TEST_F(DerivedBuffersTest, CopiesNoValueOfAPixelThatThePictureDoesNotHave) {
    view.setBuffer({BufferId::ZView});
    ASSERT_TRUE(shows({BufferId::ZView}));
    document.change(*findSetting(document.scene(), "width"), 200);
    document.pointing().pick(glm::ivec2(180, 60));
    QApplication::clipboard()->setText("mine");
    EXPECT_EQ(view.features().copies->whyNoValue(), "The picture on show does not have this pixel yet.");
    view.features().copies->copyValue();
    EXPECT_EQ(QApplication::clipboard()->text(), "mine");
    EXPECT_TRUE(QTest::qWaitFor([&] { return view.features().copies->whyNoValue().isEmpty(); }, 10000)) << "now it has";
}

TEST(CopiedValue, HasEveryChannelInTheFewestDigits) {
    const std::vector<float> numbers{0.1f, 0.25f, 1.0f / 3};
    const pipeline::AnyBuffer buffer{
        {BufferId::Normal}, &bufferInfo(BufferId::Normal), {1, 1, 3}, std::span(numbers), nullptr};
    EXPECT_EQ(app::copiedValue(buffer, {0, 0}, true), "normal at 0, 0: 0.1 0.25 0.33333334");
    EXPECT_EQ(app::copiedValue(buffer, {0, 0}, false),
              "normal at 0, 0: nothing drawn (cleared to 0.1 0.25 0.33333334)");
}

// Saved by the program it is its own; with a word more it is somebody's.
TEST(OwnFile, IsWhatTheProgramWroteThere) {
    const test::TemporaryFolder folder;
    const QString file = QString::fromStdString((folder / "mine.toml").string());
    Document document;
    document.setScene(test::pyramid());
    EXPECT_EQ(app::ownFile(document), "");
    ASSERT_TRUE(document.save(file));
    EXPECT_EQ(app::ownFile(document), file);
    document.change(*pipeline::findSetting(document.scene(), "camera.theta"), 50);
    EXPECT_EQ(app::ownFile(document), file) << "changes are what is to be saved";
    document.open(*app::readSceneFile(file));
    EXPECT_EQ(app::ownFile(document), file);
    test::writeText(folder / "mine.toml", test::readText(folder / "mine.toml") + "# a note\n");
    document.open(*app::readSceneFile(file));
    EXPECT_EQ(app::ownFile(document), "") << "the note would be lost";
}

}  // namespace
