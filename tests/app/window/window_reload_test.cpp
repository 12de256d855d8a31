// F5: a scene file that is being written beside the window.
#include <QFile>
#include <QLabel>
#include <QTest>

#include "app/buffer_view/buffer_view.h"
#include "app/canvas/buffer_canvas.h"
#include "app/commands/actions.h"
#include "app/document/file_watch.h"
#include "app/frames/stepper.h"
#include "app/views/view_area.h"
#include "app/widgets/error_list.h"
#include "lessons/state/window_state.h"
#include "tests/app/window/window_fixture.h"

namespace app {
namespace {

constexpr const char* kLight = "\n[[light]]\nposition = [3, -5, 7]\nintensity = 120\n";

class WindowReload : public WindowTest {
protected:
    // One triangle; the ambient light is on line 6.
    void write(const QByteArray& ambient, const QByteArray& lights = kLight) {
        QFile out(file);
        ASSERT_TRUE(out.open(QIODevice::WriteOnly));
        out.write(
            "[camera]\nkind = \"look-at\"\neye = [3, -4, 3]\ntarget = [0, 0, 0]\n[ambient]\nintensity = " + ambient +
            lights + "\n[[object]]\nvertices = [[0, 0, 0], [1, 0, 0], [1, 1, 0]]\npolygons = [[0, 1, 2]]\n");
    }
    void openOwn() {
        write("30");
        ASSERT_TRUE(window.openFile(file));
        ASSERT_TRUE(waitForFrame());
    }
    void lookClosely() {
        ASSERT_TRUE(QTest::qWaitFor([this] { return document().stepper().steps() != nullptr; }, 10000));
        document().stepper().goTo(*pipeline::parsePlace("z-buffer/polygon=0"));
        ASSERT_TRUE(QTest::qWaitFor([this] { return document().stepper().isSettled(); }, 10000));
        document().pointing().pick(glm::ivec2(30, 20));
        window.views().setSecond(true);
        window.views().first().setBuffer({pipeline::BufferId::ZView});
        window.views().first().canvas()->placing().setZoom(8, QPointF(100, 100));
    }
    // What the window shows, but for its scene.
    std::string place() {
        auto now = window.shown().now();
        now->set.clear();
        return toToml(*now);
    }
    QString file = folder.filePath("own.toml");
};

TEST_F(WindowReload, TheFileIsReadAgainAndWhatIsLookedAtStays) {
    openOwn();
    lookClosely();
    const std::string before = place();
    const auto mesh = document().scene().objects[0].mesh;
    write("60");
    press("F5");
    ASSERT_TRUE(waitForFrame());
    EXPECT_EQ(document().scene().ambient.intensity, 60);
    EXPECT_EQ(place(), before);
    EXPECT_EQ(document().scene().objects[0].mesh, mesh) << "it has not changed, and what was computed of it is reused";
    EXPECT_FALSE(document().isChanged());
}

TEST_F(WindowReload, AChangedFileIsToldAndReadByItselfWhereThatIsChosen) {
    openOwn();
    const auto title = [this] { return find<QLabel>("title")->text(); };
    write("60.5");  // of another length: some file systems count time in seconds
    EXPECT_TRUE(QTest::qWaitFor([&] { return title().contains("its file has changed (F5)"); }, 10000));
    EXPECT_EQ(document().scene().ambient.intensity, 30) << "not unasked";
    press("F5");
    EXPECT_EQ(document().scene().ambient.intensity, 60.5);
    EXPECT_FALSE(title().contains("changed"));

    FileWatch::setReadsAgain(true);
    lookClosely();
    const std::string before = place();
    write("70");
    EXPECT_TRUE(QTest::qWaitFor([&] { return document().scene().ambient.intensity == 70; }, 10000));
    ASSERT_TRUE(waitForFrame());
    EXPECT_EQ(place(), before);

    document().change(*findSetting(document().scene(), "ambient.intensity"), 40);
    write("80.25");
    EXPECT_TRUE(QTest::qWaitFor([&] { return title().contains("changed"); }, 10000));
    EXPECT_EQ(document().scene().ambient.intensity, 40) << "what was changed here is not given up";
    document().history().stack()->setClean();
}

// As a program does that takes a file away and writes another one a while later.
TEST_F(WindowReload, AFileThatWasGoneForAWhileIsSeenAgain) {
    openOwn();
    ASSERT_TRUE(QFile::remove(file));
    QTest::qWait(1500);
    write("60.5");
    const auto told = [this] { return find<QLabel>("title")->text().contains("its file has changed (F5)"); };
    EXPECT_TRUE(QTest::qWaitFor(told, 10000));
    press("F5");
    EXPECT_FALSE(told());
    write("70");
    EXPECT_TRUE(QTest::qWaitFor(told, 10000)) << "from then on as before";
}

// What the program itself writes is no news.
TEST_F(WindowReload, SavingIsNoChangeByAnother) {
    openOwn();
    document().change(*findSetting(document().scene(), "ambient.intensity"), 40);
    ASSERT_TRUE(document().save(file));
    ASSERT_TRUE(document().save(file));
    QTest::qWait(1000);
    EXPECT_FALSE(find<QLabel>("title")->text().contains("changed"));
}

// Also where nothing had been changed.
TEST_F(WindowReload, AfterSavingAsAnotherFileThatOneIsWatched) {
    openOwn();
    const QString before = file;
    file = folder.filePath("other.toml");
    ASSERT_TRUE(document().save(file));
    const auto told = [this] { return find<QLabel>("title")->text().contains("its file has changed (F5)"); };
    write("60.5");
    EXPECT_TRUE(QTest::qWaitFor(told, 10000));
    press("F5");
    file = before;
    write("50.25");
    QTest::qWait(1000);
    EXPECT_FALSE(told()) << "the file before is no longer the scene's";
}

TEST_F(WindowReload, ItIsOneStepOfUndoAndTheStepsBeforeStay) {
    openOwn();
    document().change(*findSetting(document().scene(), "ambient.intensity"), 40);
    document().history().stack()->setClean();
    write("60");
    press("F5");
    EXPECT_EQ(document().scene().ambient.intensity, 60);
    press("Ctrl+Z");
    EXPECT_EQ(document().scene().ambient.intensity, 40);
    EXPECT_TRUE(document().isChanged()) << "against what is in the file now";
    press("Ctrl+Z");
    EXPECT_EQ(document().scene().ambient.intensity, 30);
    document().history().stack()->setClean();
}

TEST_F(WindowReload, AFileThatIsAsItWasLeavesNoStep) {
    openOwn();
    press("F5");
    EXPECT_EQ(document().history().stack()->count(), 0);
}

TEST_F(WindowReload, WithOtherLightsTheStepsOfUndoGoAndTheViewsStay) {
    openOwn();
    lookClosely();
    document().change(*findSetting(document().scene(), "ambient.intensity"), 40);
    document().history().stack()->setClean();
    ASSERT_TRUE(waitForFrame());
    for (const QByteArray& lights : {QByteArray(kLight) + kLight, QByteArray(), QByteArray(kLight)}) {
        const std::string before = place();
        write("60", lights);
        press("F5");
        ASSERT_TRUE(waitForFrame());
        EXPECT_TRUE(QTest::qWaitFor([this] { return document().stepper().isSettled(); }, 10000));
        EXPECT_EQ(document().scene().lights.size(), std::size_t(lights.count("[[light]]")));
        EXPECT_EQ(document().history().stack()->count(), 0);
        EXPECT_EQ(document().pointing().pixel(), glm::ivec2(30, 20));
        EXPECT_TRUE(QTest::qWaitFor([&] { return place() == before; }, 5000)) << place() << before;
    }
}

TEST_F(WindowReload, AMistakeIsNamedWithItsPlaceAndTheSceneStays) {
    openOwn();
    const auto before = document().sharedScene();
    write("\"much\"");
    press("F5");
    EXPECT_EQ(document().sharedScene(), before);
    EXPECT_TRUE(find<ErrorList>("errorList")->text().contains("own.toml:6:13"))
        << find<ErrorList>("errorList")->text().toStdString();
    write("60");
    press("F5");
    EXPECT_FALSE(find<ErrorList>("errorList")->isVisible());
    EXPECT_EQ(document().scene().ambient.intensity, 60);
}

TEST_F(WindowReload, ChangesThatAreNotSavedAreAskedAbout) {
    openOwn();
    document().change(*findSetting(document().scene(), "ambient.intensity"), 40);
    write("60");
    answer("Cancel", [this] { window.actions()[ActionId::ReadAgain]->trigger(); });
    EXPECT_EQ(document().scene().ambient.intensity, 40);
    answer("Discard", [this] { window.actions()[ActionId::ReadAgain]->trigger(); });
    EXPECT_EQ(document().scene().ambient.intensity, 60);
    EXPECT_FALSE(document().isChanged());
}

TEST_F(WindowReload, WithoutAFileItSaysWhyNot) {
    pipeline::Scene scene;
    document().setScene(scene);
    ASSERT_TRUE(waitForFrame());
    const QAction* action = window.actions()[ActionId::ReadAgain];
    EXPECT_FALSE(action->isEnabled());
    EXPECT_TRUE(action->toolTip().contains("no file"));
}

}  // namespace
}  // namespace app
