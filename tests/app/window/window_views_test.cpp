// Views: split, turned, closed, gone to by keys, kept in states; a view that is not on show computes nothing.
#include <QComboBox>
#include <QLabel>
#include <QMenu>
#include <QSettings>
#include <QSplitter>
#include <QTest>

#include "app/buffer_view/buffer_header.h"
#include "app/buffer_view/buffer_view.h"
#include "app/canvas/buffer_canvas.h"
#include "app/commands/actions.h"
#include "app/compare/buffer_compare.h"
#include "app/docks/layout_store.h"
#include "app/frames/stage_buffer.h"
#include "app/look/theme.h"
#include "app/view3d/view3d_panel.h"
#include "app/views/even_splitter.h"
#include "app/views/view_area.h"
#include "pipeline/formats/scene_reader.h"
#include "pipeline/plan/needs.h"
#include "tests/app/quiet.h"
#include "tests/app/window/window_fixture.h"
#include "tests/support/scenes.h"

namespace app {
namespace {

using pipeline::BufferId;

class WindowViews : public WindowTest {
protected:
    WindowViews() {
        window.resize(2000, 1000);  // room for three views beside each other
        openPyramid();
        press("Ctrl+Shift+1");
    }
    ViewArea& views() { return window.views(); }
    QWidget* frameOf(lessons::ViewLeaf leaf) { return views().grid().views().frameOf(leaf); }
    QRect placeOf(lessons::ViewLeaf leaf) {
        QWidget* frame = frameOf(leaf);
        return QRect(frame->mapTo(&views(), QPoint(0, 0)), frame->size());
    }
    static constexpr lessons::ViewLeaf buffer(int number) { return {lessons::ViewLeaf::Kind::Buffer, number}; }
    static constexpr lessons::ViewLeaf space(int number) { return {lessons::ViewLeaf::Kind::Space, number}; }
};

TEST_F(WindowViews, FourShowWhatExplainsTheStage) {
    press("Ctrl+Shift+6");
    EXPECT_EQ(views().arrangement(), "four");
    EXPECT_EQ(placeOf(buffer(0)).top(), placeOf(buffer(1)).top());
    EXPECT_EQ(placeOf(buffer(2)).top(), placeOf(space(0)).top());
    EXPECT_NEAR(placeOf(buffer(0)).width(), placeOf(space(0)).width(), 2);
    EXPECT_NEAR(placeOf(buffer(0)).height(), placeOf(space(0)).height(), 2);
    document().setStage(pipeline::StageId::ZBuffer);
    lessons::WindowState state;
    views().fill(state);
    ASSERT_EQ(state.views.size(), 3u);
    EXPECT_EQ(state.views[0].buffer, "z_view");
    EXPECT_EQ(state.views[1].buffer, "overdraw");
    EXPECT_EQ(state.views[2].buffer, "polygon_id");
}

TEST_F(WindowViews, AViewIsSplitTurnedAndClosedByKeys) {
    canvas()->setFocus();
    press("Ctrl+Alt+B");
    EXPECT_EQ(views().arrangement(), "two");
    EXPECT_EQ(views().active().leaf(), buffer(1)) << "the keys go to the new one";
    EXPECT_TRUE(views().second().isAncestorOf(QApplication::focusWidget()));
    EXPECT_FALSE(views().second().buffer() == views().first().buffer());
    press("Ctrl+Alt+D");
    EXPECT_EQ(views().arrangement(), "(buffer / 3d) | 3d");
    ASSERT_TRUE(frameOf(space(1)));
    EXPECT_TRUE(frameOf(space(1))->isVisible());
    EXPECT_EQ(views().active().leaf(), space(1));
    press("Ctrl+Alt+W");
    EXPECT_EQ(views().arrangement(), "one");
    press("Ctrl+Alt+W");
    press("Ctrl+Alt+W");
    EXPECT_EQ(leavesOf(views().grid().tree()).size(), 1u) << "one stays";
    EXPECT_FALSE(window.actions()[ActionId::CloseView]->isEnabled());
    EXPECT_EQ(window.actions().whyNot(ActionId::CloseView), "It is the only view.");
}

TEST_F(WindowViews, KeysGoFromViewToView) {
    press("Ctrl+Shift+6");
    canvas()->setFocus();
    for (const lessons::ViewLeaf next : {buffer(1), buffer(2), space(0), buffer(0)}) {
        press("Ctrl+Tab");
        EXPECT_EQ(views().active().leaf(), next);
        EXPECT_TRUE(frameOf(next)->isAncestorOf(QApplication::focusWidget()));
        EXPECT_TRUE(frameOf(next)->property("active").toBool()) << "its frame shows it";
    }
    press("Ctrl+Shift+Tab");
    EXPECT_EQ(views().active().leaf(), space(0));
}

TEST_F(WindowViews, InAnArrangementOfOnesOwnViewsKeepTheirBuffers) {
    canvas()->setFocus();
    press("Ctrl+Alt+R");
    EXPECT_EQ(arrangementName(views().grid().tree()), "");
    views().second().setBuffer({BufferId::PolygonId});
    document().setStage(pipeline::StageId::ZBuffer);
    EXPECT_EQ(views().first().buffer().id, BufferId::ZView) << "the first one follows the stage";
    EXPECT_EQ(views().second().buffer().id, BufferId::PolygonId);
}

TEST_F(WindowViews, AMenuOfEachViewSaysWhatCanBeDone) {
    QMenu* menu = views().first().findChild<BufferHeader*>()->menu();
    const auto action = [&](const QString& text) -> QAction* {
        emit menu->aboutToShow();
        for (QAction* one : menu->actions())
            if (one->text() == text) return one;
        ADD_FAILURE() << text.toStdString();
        return nullptr;
    };
    ASSERT_TRUE(action("Close this view")->isEnabled());
    action("Close this view")->trigger();
    EXPECT_EQ(views().arrangement(), "space");
    press("Ctrl+Shift+5");
    EXPECT_FALSE(action("Close this view")->isEnabled());
    EXPECT_EQ(action("Close this view")->toolTip(), "It is the only view.");
    window.resize(1024, 640);
    EXPECT_TRUE(test::waitUntilQuiet());
    for (int i = 0; i < 2; ++i) action("Split below")->trigger();
    EXPECT_FALSE(action("Split below")->isEnabled()) << "640 pixels have no room for three";
    EXPECT_TRUE(action("Split below")->toolTip().contains("no room"));
}

TEST_F(WindowViews, WithoutRoomTheLastViewsComeBackWithIt) {
    // Four times at least 222 pixels, and three gaps.
    EXPECT_TRUE(views().setArrangement("buffer / buffer / buffer / 3d"));
    EXPECT_EQ(views().arrangement(), "buffer / buffer / buffer / 3d") << "it is what was asked for";
    EXPECT_TRUE(frameOf(buffer(0))->isVisible());
    EXPECT_GE(placeOf(buffer(0)).height(), 222);
    EXPECT_FALSE(frameOf(space(0))->isVisible());
    const auto* missing = views().findChild<QLabel*>("missingViews");
    EXPECT_TRUE(missing->isVisible());
    EXPECT_EQ(missing->text(), "1 view has no room here.");
    window.resize(2000, 1500);
    EXPECT_TRUE(QTest::qWaitFor([&] { return frameOf(space(0))->isVisible(); }));
    EXPECT_FALSE(missing->isVisible());
    EXPECT_GE(placeOf(space(0)).height(), 222);
}

TEST_F(WindowViews, SizesComeBackToThePixel) {
    canvas()->setFocus();
    press("Ctrl+Alt+R");
    press("Ctrl+Alt+B");
    EXPECT_TRUE(test::waitUntilQuiet());
    auto* row = views().findChild<EvenSplitter*>();
    ASSERT_EQ(row->count(), 3);
    // 37 pixels to the left, where neither a half nor a third is.
    QSplitterHandle* handle = row->handle(1);
    const QPoint from = handle->rect().center();
    QTest::mousePress(handle, Qt::LeftButton, {}, from);
    QTest::mouseMove(handle, from - QPoint(37, 0));
    QTest::mouseRelease(handle, Qt::LeftButton, {}, from - QPoint(37, 0));
    const auto state = window.shown().now();
    ASSERT_TRUE(state);
    const auto places = [&] {
        std::vector<QRect> all;
        for (const lessons::ViewLeaf leaf : leavesOf(views().grid().tree())) all.push_back(placeOf(leaf));
        return all;
    };
    const std::vector<QRect> before = places();
    EXPECT_LT(before[0].width(), before[1].width());
    press("Ctrl+Shift+5");
    window.files().showState(*state, {}, SceneChanges::Given);
    EXPECT_TRUE(test::waitUntilQuiet());
    EXPECT_EQ(places(), before);
    EXPECT_EQ(toToml(*window.shown().now()), toToml(*state));
    press("Ctrl+Alt+E");
    EXPECT_EQ(views().arrangement(), "buffer | (buffer / buffer) | 3d");
    EXPECT_FALSE(window.actions()[ActionId::EvenViews]->isEnabled());
}

TEST_F(WindowViews, EachViewIsItsOwnInAState) {
    canvas()->setFocus();
    press("Ctrl+Alt+D");
    EXPECT_EQ(views().arrangement(), "3d | 3d");
    lessons::WindowState state;
    views().fill(state);
    ASSERT_EQ(state.spaces.size(), 2u);
    state.spaces[0].space = "eye", state.spaces[1].space = "clip";
    state.arrangement = "buffer | 3d | 3d";
    state.views = {{"normal", lessons::ShownChannel::Third}};
    EXPECT_TRUE(views().lookAt(state).empty());
    EXPECT_TRUE(waitForFrame());
    lessons::WindowState again;
    views().fill(again);
    EXPECT_EQ(again.spaces[0].space, "eye");
    EXPECT_EQ(again.spaces[1].space, "clip");
    EXPECT_EQ(again.views[0].buffer, "normal");
    state.arrangement = "buffer |";
    EXPECT_EQ(views().lookAt(state).size(), 1u);
    EXPECT_EQ(views().arrangement(), "one");
}

// A highlight of k_s = 0, or of a light without any, is no picture.
TEST(UsefulBuffers, BesideTheFrameBufferStandsOneThatIsNotZero) {
    for (const pipeline::BuiltInScene& built : pipeline::builtInScenes()) {
        pipeline::Scene scene = *pipeline::readScene(built.file);
        scene.settings.width = 160, scene.settings.height = 120;
        const auto useful = usefulBuffers(pipeline::StageId::Shading, scene, false);
        ASSERT_GT(useful.size(), 1u) << built.name;
        const auto frame = test::frameOf(scene, pipeline::setOf({useful[1].id}));
        const auto buffer = frame->buffer(useful[1]);
        ASSERT_TRUE(buffer) << built.name << ' ' << useful[1].text();
        bool any = false;
        for (std::size_t i = 0; i < buffer->count() && !any; ++i) any = buffer->flat(i) != 0;
        EXPECT_TRUE(any) << built.name << ' ' << useful[1].text();
        // Nor a buffer of a stage that the scene has no need of: its shadows are all 1.
        if (useful[1].id != BufferId::Shadow) continue;
        bool isShadowed = false;
        for (std::size_t i = 0; i < buffer->count() && !isShadowed; ++i) isShadowed = buffer->flat(i) < 1;
        EXPECT_TRUE(isShadowed) << built.name;
    }
}

// "ambient" has no highlight, "no hidden surface removal" no depth.
TEST(UsefulBuffers, OfEveryStageAreNotLeftOut) {
    for (const pipeline::BuiltInScene& built : pipeline::builtInScenes()) {
        const auto scene = pipeline::readScene(built.file);
        ASSERT_TRUE(scene);
        for (const pipeline::StageId stage : pipeline::kStages)
            for (const bool inside : {false, true}) {
                const auto all = usefulBuffers(stage, *scene, inside);
                for (std::size_t i = 1; i < all.size(); ++i) {
                    EXPECT_EQ(whyUseless(*scene, all[i].id), "") << built.title << ", " << all[i].text();
                    EXPECT_LT(all[i].light, int(scene->lights.size())) << built.title;
                    EXPECT_TRUE(!inside || bufferInfo(all[i].id).stage <= stage) << all[i].text();
                }
                EXPECT_TRUE(inside || all.size() >= 2) << built.title;
            }
    }
}

// barycentric is shown by nothing else.
TEST_F(WindowViews, WhatIsNotOnShowIsNotComputed) {
    const auto has = [&] { return document().frames().shown()->buffer({BufferId::Barycentric}).has_value(); };
    const auto change = [&](double theta) {
        document().change(*findSetting(document().scene(), "camera.theta"), theta);
        EXPECT_TRUE(waitForFrame());
    };
    canvas()->setFocus();
    press("Ctrl+Alt+R");
    views().second().setBuffer({BufferId::Barycentric});
    change(41);
    EXPECT_TRUE(has());
    press("Ctrl+Alt+W");
    change(42);
    EXPECT_FALSE(has()) << "its view is closed";
    press("Ctrl+Shift+3");
    views().second().setBuffer({BufferId::Barycentric});
    press("Ctrl+Shift+5");
    change(43);
    EXPECT_FALSE(has()) << "its view is not in this arrangement";
}

TEST_F(WindowViews, A3dViewThatIsNotOnShowTakesNoFrameAndThenTheNewest) {
    const glm::ivec2 rightFace{268, 281};
    SceneView& view = views().view3d().view();
    press("Ctrl+Shift+5");
    const auto before = view.space().content();
    document().change(*findSetting(document().scene(), "camera.theta"), 41);
    EXPECT_TRUE(waitForFrame());
    document().pointing().pick(rightFace);
    EXPECT_EQ(view.space().content(), before);
    press("Ctrl+Shift+4");
    EXPECT_TRUE(waitForFrame());
    ASSERT_TRUE(view.space().content());
    EXPECT_EQ(view.space().content()->eye.eye, pipeline::makeView(document().scene()).eye);
    EXPECT_GE(view.space().content()->pickedPolygon, 0);
    EXPECT_FALSE(view.space().content()->mesh->polygonNormals.empty()) << "its buffers are wanted again";
}

TEST_F(WindowViews, LinkedViewsZoomAndMoveTogether) {
    press("Ctrl+Shift+3");
    EXPECT_TRUE(test::waitUntilQuiet());
    BufferCanvas *a = views().first().canvas(), *b = views().second().canvas();
    EXPECT_TRUE(views().links().isOn()) << "they are there to be compared";
    EXPECT_EQ(a->placing().look().focus, b->placing().look().focus) << "and fit the same";
    a->placing().setZoom(8, QPointF(30, 40));
    EXPECT_EQ(b->placing().zoom(), 8);
    // The places are whole pixels of the screen.
    EXPECT_NEAR(b->placing().look().center.x(), a->placing().look().center.x(), 1.0 / 8);
    EXPECT_NEAR(b->placing().look().center.y(), a->placing().look().center.y(), 1.0 / 8);
    const QPointF before = a->placing().look().center;
    QTest::mousePress(b, Qt::LeftButton, {}, QPoint(100, 100));
    QTest::mouseMove(b, QPoint(140, 180));
    QTest::mouseRelease(b, Qt::LeftButton, {}, QPoint(140, 180));
    EXPECT_NEAR(a->placing().look().center.x(), before.x() - 5, 0.25) << "40 pixels at 8 a pixel";
    EXPECT_NEAR(a->placing().look().center.y(), before.y() - 10, 0.25);
    press("Ctrl+L");
    EXPECT_FALSE(views().links().isOn());
    a->placing().setZoom(2, QPointF(30, 40));
    EXPECT_EQ(b->placing().zoom(), 8);
    const auto state = window.shown().now();
    EXPECT_EQ(state->linked, std::optional(false)) << "a session keeps it";
    press("Ctrl+L");
    EXPECT_EQ(a->placing().zoom(), b->placing().zoom()) << "they stand together again";
}

TEST_F(WindowViews, AShadowBufferMovesAlone) {
    press("Ctrl+Shift+3");
    views().second().setBuffer({BufferId::ShadowBuffer, 0});
    ASSERT_TRUE(waitForFrame());
    const double zoom = views().second().canvas()->placing().zoom();
    canvas()->placing().setZoom(16, QPointF(30, 40));
    EXPECT_EQ(views().second().canvas()->placing().zoom(), zoom);
    views().second().setBuffer({BufferId::ZView});
    ASSERT_TRUE(waitForFrame());
    EXPECT_EQ(views().second().canvas()->placing().zoom(), 16) << "a buffer of the frame joins";
}

// Pins, what is selected, and a comparison in each of its ways.
TEST_F(WindowViews, AStateHasMarksAndComparisons) {
    document().pointing().pick(glm::ivec2(268, 281));
    views().first().setFocus();
    document().pointing().pins().toggle({10, 20});
    document().pointing().pins().toggle({268, 281});
    document().pointing().select(lessons::Selection{lessons::Selection::Kind::Polygon, 2});
    document().change(*findSetting(document().scene(), "camera.theta"), 41);
    ASSERT_TRUE(waitForFrame());
    BufferCompare& compare = views().first().compare();
    const auto shading = *findSetting(document().scene(), "shading");
    for (const OtherSource& source : {OtherSource{.kind = OtherSource::Kind::Buffer, .buffer = {BufferId::Normal}},
                                      OtherSource{.kind = OtherSource::Kind::PreviousStage},
                                      OtherSource{.kind = OtherSource::Kind::Setting, .setting = shading, .value = 2},
                                      OtherSource{.kind = OtherSource::Kind::Before}})
        for (const CompareMode mode : {CompareMode::A, CompareMode::B, CompareMode::Wipe, CompareMode::Difference}) {
            compare.compareWith(source);
            if (compare.mode() != mode) compare.setMode(mode);
            compare.difference().setMetric(pipeline::DifferenceMetric::Squared);
            const auto kept = window.shown().now();
            ASSERT_TRUE(kept);
            ASSERT_TRUE(kept->views[0].compared);
            compare.compareWith(std::nullopt);
            compare.difference().setMetric(pipeline::DifferenceMetric::Error);
            document().pointing().pins().clear();
            document().pointing().select(std::nullopt);
            window.files().showState(*kept, {}, SceneChanges::Given);
            const auto again = window.shown().now();
            EXPECT_EQ(toToml(*again), toToml(*kept));
            EXPECT_EQ(compare.mode(), mode);
            EXPECT_EQ(again->pins.size(), 2u);
            EXPECT_TRUE(again->selected);
        }
    // The change that "before" meant is kept with it: later the last change is another one.
    const std::string with = window.shown().now()->views[0].compared->with;
    EXPECT_TRUE(with.starts_with("setting camera.theta=") && with != "setting camera.theta=41") << with;
    lessons::WindowState wrong = *window.shown().now();
    wrong.views[0].compared->with = "setting shadin=flat";
    EXPECT_EQ(views().lookAt(wrong).size(), 1u);
    EXPECT_FALSE(compare.source());
}

// As layouts were kept once: the columns' sizes, then the buffer views'.
TEST_F(WindowViews, NumbersKeepTheirTypefaceInAnotherLayout) {
    views().first().setBuffer({BufferId::ZView});
    ASSERT_TRUE(waitForFrame());
    const auto* low = views().first().findChild<QLabel*>("rangeLow");
    for (const char* layout : {"Ctrl+Shift+3", "Ctrl+Shift+6", "Ctrl+Shift+4", "Ctrl+Shift+1"}) {
        press(layout);
        EXPECT_TRUE(test::waitUntilQuiet());
        if (!low->isVisible()) continue;
        EXPECT_EQ(low->font().family(), Theme::current().mono(12).family()) << layout;
    }
}

TEST_F(WindowViews, AnOldLayoutHasItsSizes) {
    QByteArray sizes;
    QDataStream stream(&sizes, QIODevice::WriteOnly);
    stream << QList<int>{600, 300} << QList<int>{200, 100};
    QSettings settings;
    settings.beginGroup("layouts/b2xk");  // "old"
    settings.setValue("arrangement", "two");
    settings.setValue("sizes", sizes);
    settings.endGroup();
    ASSERT_TRUE(keptLayout("old"));
    EXPECT_EQ(keptLayout("old")->arrangement, "600: (200: buffer / 100: buffer) | 300: 3d");
}

}  // namespace
}  // namespace app
