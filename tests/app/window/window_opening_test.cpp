// Scenes are read away from the window: it shows the one before until then, says how far it is, and can be told to stop.
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <cmath>

#include "app/canvas/buffer_canvas.h"
#include "app/commands/actions.h"
#include "app/document/recent_files.h"
#include "app/document/scene_opener.h"
#include "app/document/session_file.h"
#include "app/start/start_page.h"
#include "app/talk/clean_view.h"
#include "app/talk/cue_panel.h"
#include "app/talk/presentation.h"
#include "app/talk/talk_keys.h"
#include "app/talk/talk_work.h"
#include "app/view3d/view3d_panel.h"
#include "app/views/view_area.h"
#include "app/widgets/error_list.h"
#include "app/widgets/opening_bar.h"
#include "app/widgets/work_bar.h"
#include "tests/app/quiet.h"
#include "tests/app/window/window_fixture.h"

namespace app {
namespace {

class WindowOpening : public WindowTest {
protected:
    // From here on nothing comes within the call, as with a large file.
    void beSlow() { window.opener().setPatience(std::chrono::milliseconds(0)); }
    bool waitForScene() {
        return QTest::qWaitFor([this] { return !window.opener().busy(); }, 60000) && waitForFrame();
    }
    // A ring of so many quads.
    QString writeModel(const QString& name, int quads) {
        QFile file(folder.filePath(name));
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        QByteArray text;
        for (int i = 0; i < quads; ++i) {
            const double angle = 6.283185307179586 * i / quads;
            const QByteArray place = QByteArray::number(std::cos(angle)) + ' ' + QByteArray::number(std::sin(angle));
            text += "v " + place + " 0\nv " + place + " 1\n";
        }
        for (int i = 0; i < quads; ++i) {
            const int a = 2 * i + 1, b = 2 * ((i + 1) % quads) + 1;
            for (const int corner : {a, b, b + 1, a + 1})
                text += (corner == a ? "f " : " ") + QByteArray::number(corner);
            text += '\n';
        }
        file.write(text);
        return file.fileName();
    }
    QString pyramid = resourceScene("pyramid.scene"), pyramids = resourceScene("two_pyramids.scene");
};

TEST_F(WindowOpening, TheSceneBeforeStaysUntilTheNewOneIsThere) {
    openPyramid();
    beSlow();
    EXPECT_TRUE(window.openFile(pyramids));
    EXPECT_TRUE(window.opener().busy());
    EXPECT_EQ(document().scene().name, "pyramid.scene");
    EXPECT_TRUE(find<OpeningBar>("openingBar")->isVisible());
    EXPECT_EQ(window.opener().name(), "two_pyramids.scene");
    ASSERT_TRUE(waitForScene());
    EXPECT_EQ(document().scene().name, "two_pyramids.scene");
    EXPECT_FALSE(find<OpeningBar>("openingBar")->isVisible());
    EXPECT_EQ(recentFiles().front().file, pyramids);
}

TEST_F(WindowOpening, ASmallSceneIsThereAtOnceAndNothingFlickers) {
    bool wasSeen = false;
    QObject::connect(&window.opener(), &SceneOpener::changed, &window,
                     [&] { wasSeen = wasSeen || find<OpeningBar>("openingBar")->isVisible(); });
    openPyramid();
    EXPECT_FALSE(wasSeen);
}

TEST_F(WindowOpening, EscapeOrTheButtonCancelsAndNothingHasChanged) {
    openPyramid();
    const QImage before = pictureOnScreen();
    const QString ring = writeModel("ring.obj", 100000);
    beSlow();
    for (const bool byKey : {true, false}) {
        window.openFile(ring);
        if (byKey)
            press("Esc");
        else
            find<QPushButton>("cancelOpening")->click();
        EXPECT_FALSE(window.opener().busy());
        QTest::qWait(100);
        EXPECT_EQ(document().scene().name, "pyramid.scene");
        EXPECT_FALSE(find<OpeningBar>("openingBar")->isVisible());
        EXPECT_EQ(pictureOnScreen(), before);
    }
    EXPECT_EQ(recentFiles().size(), 1u) << "only what was opened";
}

// Work that ends when it is told to.
TEST_F(WindowOpening, EscapeOrTheButtonStopsWhatTakesLongAndOneClickGoesOn) {
    openPyramid();
    canvas()->setFocus();
    WorkList& list = document().work();
    const auto idle = [&] {
        const Stepper& stepper = document().stepper();
        return stepper.steps() && stepper.isSettled() && window.views().view3d().view().isDrawn();
    };
    ASSERT_TRUE(QTest::qWaitFor(idle, 20000));
    QObject who;
    list.add(
        &who, "a test", [&] { list.setBusy(&who, false); }, [&] { list.setBusy(&who, true); });
    auto* bar = find<WorkBar>("workBar");
    auto* link = find<QPushButton>("workLink");
    EXPECT_FALSE(bar->isVisible());
    list.setBusy(&who, true);
    for (const bool byKey : {true, false}) {
        ASSERT_TRUE(QTest::qWaitFor([&] { return link->isVisible() && link->text().startsWith("Cancel"); }, 5000));
        EXPECT_TRUE(bar->findChild<QLabel*>()->text().contains("a test"));
        byKey ? press("Esc") : link->click();
        EXPECT_EQ(list.stopped(), QStringList("a test"));
        EXPECT_EQ(bar->findChild<QLabel*>()->text(), "Stopped: a test. What you see does not have it yet.");
        EXPECT_EQ(link->text(), "Go on");
        link->click();
        EXPECT_TRUE(list.stopped().isEmpty());
    }
    list.setBusy(&who, false);
    EXPECT_FALSE(bar->isVisible());
}

TEST_F(WindowOpening, WhilePresentingTheAudienceSeesHowFarAndEscapeCancelsThat) {
    openPyramid();
    window.cues().present();
    ASSERT_TRUE(window.presentation().isOn());
    CleanView& clean = *window.presentation().cleanView();
    auto* bar = clean.findChild<OpeningBar*>("openingBar");
    ASSERT_TRUE(bar);
    EXPECT_FALSE(bar->isVisible());
    beSlow();
    window.openFile(writeModel("ring.obj", 100000));
    EXPECT_TRUE(bar->isVisible());
    EXPECT_TRUE(clean.rect().contains(bar->geometry().translated(bar->parentWidget()->pos())));
    clean.keys().take(Qt::Key_Escape);
    EXPECT_FALSE(window.opener().busy());
    EXPECT_FALSE(bar->isVisible());
    EXPECT_TRUE(window.presentation().isOn()) << "the talk goes on";
    window.presentation().end();
}

TEST_F(WindowOpening, WhilePresentingEscapeStopsWhatTakesLongAndDoesNotEndTheTalkByMistake) {
    openPyramid();
    window.cues().present();
    CleanView& clean = *window.presentation().cleanView();
    auto* line = clean.findChild<WorkBar*>("workBar");
    auto* link = line->findChild<QPushButton*>("workLink");
    const auto isQuiet = [&] {
        return document().stepper().steps() && !line->isVisible() && clean.views().view3d().view().isDrawn();
    };
    ASSERT_TRUE(QTest::qWaitFor(isQuiet, 20000));
    WorkList& list = document().work();
    QObject who;
    list.add(
        &who, "a test", [&] { list.setBusy(&who, false); }, [&] { list.setBusy(&who, true); });
    list.setBusy(&who, true);
    const auto runs = [&] { return line->isVisible() && link->text().startsWith("Cancel"); };
    ASSERT_TRUE(QTest::qWaitFor(runs, 5000));
    EXPECT_TRUE(clean.rect().contains(line->geometry().translated(line->parentWidget()->pos())));
    const auto talksOnAfterEscape = [&] {
        clean.keys().take(Qt::Key_Escape);
        EXPECT_TRUE(test::waitUntilQuiet());
        return window.presentation().isOn();
    };
    EXPECT_TRUE(talksOnAfterEscape());
    EXPECT_EQ(list.stopped(), QStringList("a test"));
    EXPECT_EQ(link->text(), "Go on");
    EXPECT_TRUE(talksOnAfterEscape()) << "pressed twice";
    link->click();
    ASSERT_TRUE(QTest::qWaitFor(runs, 5000));
    list.setBusy(&who, false);
    EXPECT_FALSE(line->isVisible());
    EXPECT_TRUE(talksOnAfterEscape()) << "meant for what has just ended";
    ASSERT_TRUE(QTest::qWaitFor([&] { return !clean.findChild<TalkWork*>()->hasJustEnded(); }));
    EXPECT_FALSE(talksOnAfterEscape());
}

TEST_F(WindowOpening, AnotherFileReplacesTheOneThatIsBeingRead) {
    openPyramid();
    beSlow();
    window.openFile(writeModel("ring.obj", 100000));
    window.openFile(pyramids);
    EXPECT_EQ(window.opener().name(), "two_pyramids.scene");
    int opened = 0;
    QObject::connect(&document(), &Document::sceneOpened, &window, [&] { ++opened; });
    ASSERT_TRUE(waitForScene());
    QTest::qWait(100);
    EXPECT_EQ(document().scene().name, "two_pyramids.scene");
    EXPECT_EQ(opened, 1);
}

TEST_F(WindowOpening, WhatCannotBeReadIsReportedAndTheSceneStays) {
    openPyramid();
    beSlow();
    QFile bad(folder.filePath("bad.scene"));
    ASSERT_TRUE(bad.open(QIODevice::WriteOnly));
    bad.write("this is no scene\n");
    bad.close();
    window.openFile(bad.fileName());
    ASSERT_TRUE(QTest::qWaitFor([this] { return !window.opener().busy(); }, 30000));
    EXPECT_EQ(document().scene().name, "pyramid.scene");
    EXPECT_TRUE(find<ErrorList>("errorList")->text().contains("bad.scene:1:"));
}

TEST_F(WindowOpening, FromTheStartPageItSaysHowFarItIs) {
    beSlow();
    window.openFile(writeModel("ring.obj", 100000));
    EXPECT_TRUE(find<StartPage>("startPage")->isVisible());
    EXPECT_TRUE(find<OpeningBar>("openingBar")->isVisible());
    double most = 0;
    QObject::connect(&window.opener(), &SceneOpener::changed, &window,
                     [&] { most = std::max(most, window.opener().share()); });
    ASSERT_TRUE(waitForScene());
    EXPECT_EQ(most, 1);
    EXPECT_EQ(document().scene().objects[0].mesh->polygonCount(), 100000u);
}

TEST_F(WindowOpening, CuesOfOtherScenesLeadOnFromTheOneThatIsAskedFor) {
    CueModel& model = window.cues().model();
    model.clear();
    ASSERT_TRUE(model.saveAs(folder.filePath("talk.cues")));
    for (const QString& file : {pyramid, pyramids, pyramid}) {
        window.openFile(file);
        ASSERT_TRUE(waitForScene());
        press("Ctrl+B");
    }
    ASSERT_EQ(model.current(), 2);
    beSlow();
    press("PgUp");
    EXPECT_EQ(model.current(), 2) << "the second cue's scene is being read";
    press("PgUp");
    ASSERT_TRUE(waitForScene());
    EXPECT_EQ(model.current(), 0);
    press("PgDown");
    ASSERT_TRUE(waitForScene());
    EXPECT_EQ(model.current(), 1);
    EXPECT_EQ(document().scene().name, "two_pyramids.scene");
}

TEST_F(WindowOpening, PresentingBeginsOnceTheCueIsThere) {
    QFile talk(folder.filePath("talk.cues"));
    ASSERT_TRUE(talk.open(QIODevice::WriteOnly));
    talk.write("[[cue]]\nname = \"one\"\nscene = \"two_pyramids\"\n");
    talk.close();
    beSlow();
    ASSERT_TRUE(window.cues().open(talk.fileName(), {}, [this] { window.cues().present(); }));
    EXPECT_FALSE(window.presentation().isOn());
    ASSERT_TRUE(waitForScene());
    EXPECT_TRUE(window.presentation().isOn());
    window.cues().present();
}

TEST_F(WindowOpening, ASessionThatIsStillBeingReadIsThereForTheNextStart) {
    lessons::WindowState state;
    state.scene = writeModel("ring.obj", 100000).toStdString();
    SessionFile file(folder.path());
    ASSERT_TRUE(file.write(state));
    beSlow();
    window.startSession(folder.path(), true);
    ASSERT_TRUE(window.opener().busy());
    window.close();
    const auto left = file.take();
    ASSERT_TRUE(left.errors.empty()) << format(left.errors);
    ASSERT_TRUE(left.state);
    EXPECT_EQ(left.state->scene, state.scene);
}

TEST_F(WindowOpening, AnOpenedLessonGoesBeforeWhatIsBeingRead) {
    beSlow();
    window.openFile(writeModel("ring.obj", 100000));
    window.lessons().open("pyramid");
    EXPECT_FALSE(window.opener().busy());
    QTest::qWait(100);
    EXPECT_NE(document().scene().name, "ring.obj");
}

}  // namespace
}  // namespace app
