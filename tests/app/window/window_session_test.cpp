// What the window shows, kept and shown again: states, sessions, recent files, and the question before changes are lost.
#include <QClipboard>
#include <QFile>
#include <QPushButton>
#include <QSplitter>
#include <QTest>

#include "app/buffer_view/buffer_overlays.h"
#include "app/buffer_view/buffer_range.h"
#include "app/buffer_view/buffer_view.h"
#include "app/canvas/buffer_canvas.h"
#include "app/commands/actions.h"
#include "app/document/recent_files.h"
#include "app/document/scene_opener.h"
#include "app/document/session_file.h"
#include "app/view3d/view3d_panel.h"
#include "app/views/view_area.h"
#include "app/widgets/error_list.h"
#include "tests/app/quiet.h"
#include "tests/app/window/window_fixture.h"

namespace app {
namespace {

class WindowSession : public WindowTest {
protected:
    // A window far from how it begins.
    void goFar() {
        openPyramid();
        document().change(*findSetting(document().scene(), "camera.theta"), 47.25);
        EXPECT_TRUE(waitForFrame());
        EXPECT_TRUE(QTest::qWaitFor([this] { return document().stepper().steps() != nullptr; }, 10000));
        document().stepper().goTo(*pipeline::parsePlace("z-buffer/polygon=2"));
        waitForState();
        document().pointing().pick(glm::ivec2(268, 281));
        window.views().setSecond(true);
        BufferView& first = window.views().first();
        first.setBuffer({pipeline::BufferId::ZView});
        first.features().range->set({700, 600});
        first.features().overlays->set(OverlayId::Edges, true);
        first.canvas()->placing().setZoom(8, QPointF(100, 100));
        OrbitCamera camera = window.views().view3d().view().camera().now();
        orbit(camera, 31, 7);
        window.views().view3d().view().camera().set(camera);
    }
    // Which the file in the folder names; empty where there is no such file.
    std::string keptScene(const char* name) {
        QFile in(folder.filePath(name));
        const QByteArray text = in.open(QIODevice::ReadOnly) ? in.readAll() : QByteArray();
        const auto state = lessons::readState(text.toStdString(), name);
        return state ? state->scene : std::string();
    }
    void waitForState() {
        EXPECT_TRUE(
            QTest::qWaitFor([this] { return !document().frames().busy() && document().stepper().isSettled(); }, 30000));
    }
};

TEST_F(WindowSession, AStateShownAgainIsTheSameState) {
    goFar();
    const auto far = window.shown().now();
    ASSERT_TRUE(far);
    EXPECT_EQ(far->scene, "pyramid");
    EXPECT_EQ(far->set, std::vector<std::string>{"camera.theta=47.25"});
    const QImage picture = pictureOnScreen();

    ASSERT_TRUE(window.openFile(resourceScene("two_pyramids.scene")));
    window.views().first().features().range->fit(true);
    document().stepper().leave();
    document().setStage(pipeline::StageId::Cull);
    EXPECT_TRUE(waitForFrame());
    window.files().showState(*far, {}, SceneChanges::Given);
    EXPECT_TRUE(waitForFrame());
    waitForState();
    EXPECT_TRUE(test::waitUntilQuiet());
    const auto again = window.shown().now();
    ASSERT_TRUE(again);
    EXPECT_EQ(toToml(*again), toToml(*far));
    EXPECT_EQ(pictureOnScreen(), picture);
    EXPECT_FALSE(document().isChanged()) << "the change belongs to the state";
}

TEST_F(WindowSession, AStateIsCopiedAndPastedAsTextInAnyWindow) {
    goFar();
    canvas()->setFocus();
    press("Ctrl+C");
    const QString text = QApplication::clipboard()->text();
    EXPECT_EQ(text.toStdString(), toToml(*window.shown().now()));
    const int steps = document().history().stack()->count();

    document().change(*findSetting(document().scene(), "camera.theta"), 10);
    EXPECT_TRUE(waitForFrame());
    document().setStage(pipeline::StageId::Cull);
    window.views().setArrangement("four");
    waitForState();
    const std::string before = toToml(*window.shown().now());
    window.views().view3d().setFocus();
    press("Ctrl+V");
    waitForState();
    EXPECT_EQ(toToml(*window.shown().now()), text.toStdString());
    EXPECT_EQ(document().history().stack()->count(), steps + 2) << "one step";
    EXPECT_EQ(document().history().stack()->undoText(), "paste");
    const auto settled = [&](const std::string& wanted) {
        return QTest::qWaitFor([&] { return toToml(*window.shown().now()) == wanted; }, 10000);
    };
    document().history().stack()->undo();
    EXPECT_EQ(document().scene().camera.theta, 10);
    EXPECT_TRUE(settled(before)) << "the views are the ones from before, too: " << toToml(*window.shown().now());
    document().history().stack()->redo();
    EXPECT_TRUE(settled(text.toStdString()));
    document().history().stack()->undo();
    document().history().stack()->setClean();

    MainWindow other;
    other.resize(window.size());
    other.show();
    other.actions()[ActionId::PasteState]->trigger();  // on its start page
    ASSERT_TRUE(other.document().hasScene());
    EXPECT_TRUE(QTest::qWaitFor(
        [&] { return !other.document().frames().busy() && other.document().stepper().isSettled(); }, 30000));
    EXPECT_EQ(toToml(*other.shown().now()), text.toStdString());
    other.document().history().stack()->setClean();
    other.close();
    window.windowLayout().showStart();
    QApplication::setActiveWindow(&window);
    EXPECT_TRUE(test::waitUntilQuiet());
    press("Ctrl+V");
    EXPECT_TRUE(QTest::qWaitFor([&] { return window.shown().now().has_value(); }, 5000)) << "by its key, too";
    document().history().stack()->setClean();
}

// A scene of a file of one's own is pasted as its text, which makes it anew: that is no change of it.
TEST_F(WindowSession, WhatWasCopiedIsNoChangeWherePastedAgain) {
    const QString file = folder.filePath("own.toml");
    ASSERT_TRUE(QFile::copy(resourceScene("coloured_lights.toml"), file));
    ASSERT_TRUE(window.openFile(file));
    ASSERT_TRUE(waitForFrame());
    canvas()->setFocus();
    const pipeline::FramePtr frame = document().frames().shown();
    press("Ctrl+C");
    press("Ctrl+V");
    ASSERT_TRUE(waitForFrame());
    EXPECT_FALSE(document().isChanged());
    EXPECT_EQ(document().frames().shown(), frame) << "nothing ran again";
    document().change(*findSetting(document().scene(), "material.0.kr"), 0.25);
    press("Ctrl+V");
    ASSERT_TRUE(waitForFrame());
    EXPECT_NE(document().scene().objects[0].material.diffuse.x, 0.25) << "what was changed meanwhile goes back";
}

// A place changes nothing that a file could keep.
TEST_F(WindowSession, APastedPlaceIsOneStepOfUndoAndNoChangeOfTheScene) {
    openPyramid();
    document().pointing().pick(glm::ivec2(268, 281));
    QApplication::clipboard()->setText("stage = \"cull\"\npixel = [3, 4]\n");
    canvas()->setFocus();
    press("Ctrl+V");
    EXPECT_EQ(document().stage(), pipeline::StageId::Cull);
    EXPECT_EQ(document().pointing().pixel(), glm::ivec2(3, 4));
    EXPECT_FALSE(document().isChanged());
    EXPECT_FALSE(document().history().sceneBefore()) << "nothing of the scene has been changed yet";
    press("Ctrl+Z");
    EXPECT_EQ(document().stage(), pipeline::StageId::Shading);
    EXPECT_EQ(document().pointing().pixel(), glm::ivec2(268, 281));
}

TEST_F(WindowSession, ACopyNeedsNoFile) {
    const QString file = folder.filePath("mine.toml");
    openPyramid();
    document().change(*findSetting(document().scene(), "camera.theta"), 12);
    ASSERT_TRUE(document().save(file));
    canvas()->setFocus();
    press("Ctrl+C");
    ASSERT_TRUE(QFile::remove(file));
    window.windowLayout().showStart();
    MainWindow other;
    other.show();
    other.actions()[ActionId::PasteState]->trigger();
    ASSERT_TRUE(other.document().hasScene());
    EXPECT_EQ(other.document().scene().camera.theta, 12);
}

TEST_F(WindowSession, WhatIsNoStateIsToldWithItsPlaceAndNothingChanges) {
    openPyramid();
    canvas()->setFocus();
    const std::string before = toToml(*window.shown().now());
    auto* errors = find<ErrorList>("errorList");
    for (const auto& [text, told] : {std::pair{"a letter", "clipboard:1:"},
                                     {"stage = \"cull\"\npixl = [1, 2]", "clipboard:2:1: no key \"pixl\""},
                                     {" \n", "clipboard:1:1: no text"}}) {
        QApplication::clipboard()->setText(text);
        press("Ctrl+V");
        EXPECT_TRUE(errors->isVisible());
        EXPECT_TRUE(errors->text().contains(told)) << errors->text().toStdString();
        EXPECT_EQ(toToml(*window.shown().now()), before);
    }
    // A place in the scene on show.
    QApplication::clipboard()->setText("stage = \"cull\"\npixel = [3, 4]\n");
    press("Ctrl+V");
    EXPECT_FALSE(errors->isVisible());
    EXPECT_EQ(document().stage(), pipeline::StageId::Cull);
    EXPECT_EQ(document().pointing().pixel(), glm::ivec2(3, 4));
}

TEST_F(WindowSession, TheNextStartShowsWhatWasLeftAndTheChangesAreStillUnsaved) {
    window.startSession(folder.path(), true);
    EXPECT_FALSE(document().hasScene());
    goFar();
    const auto far = window.shown().now();
    EXPECT_TRUE(SessionFile(folder.path()).write(*far));

    MainWindow next;
    next.opener().setPatience(std::chrono::minutes(1));
    next.resize(window.size());
    next.show();
    next.startSession(folder.path(), true);
    ASSERT_TRUE(next.document().hasScene());
    EXPECT_TRUE(QTest::qWaitFor(
        [&] { return !next.document().frames().busy() && next.document().stepper().isSettled(); }, 30000));
    EXPECT_EQ(next.document().scene().camera.theta, 47.25);
    EXPECT_EQ(text(*next.document().stepper().place()), "z-buffer/polygon=2");
    EXPECT_EQ(next.document().pointing().pixel(), glm::ivec2(268, 281));
    EXPECT_TRUE(next.document().isChanged());
    next.document().history().stack()->undo();
    EXPECT_FALSE(next.document().isChanged());
    EXPECT_NE(next.document().scene().camera.theta, 47.25);
}

TEST_F(WindowSession, ABrokenSessionIsReportedAndLeftAside) {
    QFile file(SessionFile(folder.path()).file());
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("scene = \"pyramid\"\nstage = \"shad");
    file.close();
    window.startSession(folder.path(), true);
    EXPECT_FALSE(document().hasScene());
    auto* errors = find<ErrorList>("errorList");
    EXPECT_TRUE(errors->isVisible());
    EXPECT_TRUE(errors->text().contains("session.broken.toml")) << errors->text().toStdString();
    EXPECT_TRUE(errors->text().contains("session.toml:2:")) << errors->text().toStdString();
    EXPECT_TRUE(QFile::exists(folder.filePath("session.broken.toml")));
    EXPECT_FALSE(file.exists());
}

TEST_F(WindowSession, ASessionThatEndedTheProgramIsNotTriedAgain) {
    lessons::WindowState state;
    state.scene = "pyramid";
    SessionFile file(folder.path());
    ASSERT_TRUE(file.write(state));
    EXPECT_TRUE(file.take().state);  // and then the program is gone
    window.startSession(folder.path(), true);
    EXPECT_FALSE(document().hasScene());
    EXPECT_TRUE(find<ErrorList>("errorList")->text().contains("ended while it restored"));
    EXPECT_FALSE(file.take().state);
    EXPECT_TRUE(file.take().errors.empty());
}

// Started with a file that cannot be read, or whose own scene is gone.
TEST_F(WindowSession, WhereNothingWasShownTheLastSessionStays) {
    lessons::WindowState state;
    state.scene = "pyramid";
    ASSERT_TRUE(SessionFile(folder.path()).write(state));
    window.startSession(folder.path(), false);
    window.openFile(folder.filePath("typo.scene"));
    window.close();
    EXPECT_EQ(keptScene("session.toml"), "pyramid");

    state.scene = folder.filePath("gone.scene").toStdString();
    ASSERT_TRUE(SessionFile(folder.path()).write(state));
    MainWindow next;
    next.opener().setPatience(std::chrono::minutes(1));
    next.show();
    next.startSession(folder.path(), true);
    EXPECT_FALSE(next.document().hasScene());
    next.close();
    EXPECT_EQ(keptScene("session.toml"), state.scene) << "it may be there again";
}

TEST_F(WindowSession, ASessionThatEndedTheProgramIsLeftAsideBeforeAFileToo) {
    lessons::WindowState state;
    state.scene = "two_pyramids";
    SessionFile file(folder.path());
    ASSERT_TRUE(file.write(state));
    ASSERT_TRUE(file.take().state);  // and then the program is gone
    window.startSession(folder.path(), false);
    openPyramid();
    EXPECT_EQ(keptScene("session.broken.toml"), "two_pyramids");
}

TEST_F(WindowSession, ASessionThatWasNotRestoredIsKeptBesideTheNew) {
    lessons::WindowState state;
    state.scene = "two_pyramids";
    state.set = {"camera.theta=47.25"};
    ASSERT_TRUE(SessionFile(folder.path()).write(state));
    window.startSession(folder.path(), false);
    openPyramid();
    EXPECT_TRUE(QTest::qWaitFor([this] { return keptScene("session.toml") == "pyramid"; }, 20000));
    EXPECT_EQ(keptScene("session.previous.toml"), "two_pyramids");
    press("Ctrl+W");
    EXPECT_FALSE(QFile::exists(folder.filePath("session.toml"))) << "what was closed is not shown again";
    EXPECT_EQ(keptScene("session.previous.toml"), "two_pyramids");
}

TEST_F(WindowSession, ItIsWrittenWhileTheWorkGoesOn) {
    window.startSession(folder.path(), false);
    openPyramid();
    int x = 0;
    const auto works = [&] {
        document().pointing().pick(glm::ivec2(100 + ++x % 200, 100));  // more often than the file is written
        return keptScene("session.toml") == "pyramid";
    };
    EXPECT_TRUE(QTest::qWaitFor(works, 10000));
}

TEST_F(WindowSession, ARestoredOneIsNeverWithoutAFile) {
    lessons::WindowState state;
    state.scene = "pyramid";
    state.set = {"camera.theta=47.25"};
    ASSERT_TRUE(SessionFile(folder.path()).write(state));
    bool there = false;
    QObject::connect(&document().frames(), &FrameFeed::frameReady, &window,
                     [&] { there = !keptScene("session.trying.toml").empty(); });
    window.startSession(folder.path(), true);
    ASSERT_TRUE(waitForFrame());
    EXPECT_TRUE(there) << "until the first frame";
    EXPECT_EQ(keptScene("session.toml"), "pyramid") << "from then on";
    EXPECT_FALSE(QFile::exists(folder.filePath("session.trying.toml")));
}

TEST_F(WindowSession, ThatItCannotBeWrittenIsSaidOnce) {
    QFile file(folder.filePath("file"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    int said = 0;
    QObject::connect(&document(), &Document::said, &window,
                     [&](const QString& words) { said += words.startsWith("The session is not kept: "); });
    window.startSession(folder.filePath("file"), false);  // no folder
    openPyramid();
    EXPECT_TRUE(QTest::qWaitFor([&] { return said == 1; }, 10000));
    document().setStage(pipeline::StageId::Cull);
    QTest::qWait(4000);
    EXPECT_EQ(said, 1);
}

TEST_F(WindowSession, SwitchedOffItBeginsOnTheStartPageAndLeavesNothing) {
    SessionFile::setWanted(false);
    lessons::WindowState state;
    state.scene = "pyramid";
    SessionFile file(folder.path());
    ASSERT_TRUE(file.write(state));
    window.startSession(folder.path(), true);
    EXPECT_FALSE(document().hasScene());
    window.close();
    EXPECT_FALSE(QFile::exists(file.file()));
}

TEST_F(WindowSession, AnotherArrangementOfViewsAloneIsKeptSoon) {
    window.startSession(folder.path(), false);
    openPyramid();
    SessionFile file(folder.path());
    const auto kept = [&] {
        QFile in(file.file());
        const QByteArray text = in.open(QIODevice::ReadOnly) ? in.readAll() : QByteArray();
        const auto state = lessons::readState(text.toStdString(), "session");
        return state ? state->arrangement : std::string();
    };
    EXPECT_TRUE(QTest::qWaitFor([&] { return kept() == "one"; }, 20000)) << "after the scene was opened";
    window.views().setArrangement("compare");
    EXPECT_TRUE(QTest::qWaitFor([&] { return kept() == "compare"; }, 20000));
    auto* splitter = window.views().findChild<QSplitter*>();
    ASSERT_TRUE(splitter);
    QTest::mousePress(splitter->handle(1), Qt::LeftButton, {}, {1, 50});
    QTest::mouseMove(splitter->handle(1), {-200, 50});
    QTest::mouseRelease(splitter->handle(1), Qt::LeftButton, {}, {-200, 50});
    const std::string moved = window.views().arrangement();
    EXPECT_NE(moved, "compare");
    EXPECT_TRUE(QTest::qWaitFor([&] { return kept() == moved; }, 20000));
}

TEST_F(WindowSession, ARecentFileOpensWhereItWasLeft) {
    goFar();
    press("Ctrl+W");
    const auto recent = recentFiles();
    ASSERT_EQ(recent.size(), 1u);
    EXPECT_EQ(recent[0].where, "z-buffer/polygon=2 · pixel 268, 281");
    ASSERT_TRUE(window.files().openRecent(recent[0].file));
    EXPECT_TRUE(waitForFrame());
    EXPECT_EQ(text(*document().stepper().place()), "z-buffer/polygon=2");
    EXPECT_EQ(document().pointing().pixel(), glm::ivec2(268, 281));
    EXPECT_NE(document().scene().camera.theta, 47.25) << "the changes were dropped";
    EXPECT_FALSE(document().isChanged());
}

}  // namespace
}  // namespace app
