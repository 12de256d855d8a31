#include <QDropEvent>
#include <QFile>
#include <QMimeData>
#include <QPlainTextEdit>
#include <QTest>

#include "app/panels/error_list.h"
#include "app/panels/stage_strip.h"
#include "app/panels/start_card.h"
#include "app/panels/start_page.h"
#include "tests/app/window_fixture.h"

namespace app {
namespace {

// As a file manager drops it.
void drop(QWidget& window, const QString& file) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(file)});
    const QPoint at(400, 400);
    QDragEnterEvent enter(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&window, &enter);
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent event(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&window, &event);
}

using WindowOpen = WindowTest;

TEST_F(WindowOpen, BeginsOnTheStartPageWithPicturesOfTheScenes) {
    EXPECT_TRUE(find<StartPage>("startPage")->isVisible());
    EXPECT_FALSE(find<StageStrip>("stageStrip")->isVisible());
    auto* card = find<StartCard>("scene:pyramid");
    // The pipeline computes the picture: lecture 1's pyramid is bluer than it is red.
    const auto isBlue = [&] {
        const QImage shown = card->grab().toImage();
        const QColor middle = shown.pixelColor(shown.width() / 2, shown.height() / 4);
        return middle.blue() > 100 && middle.red() < 60;
    };
    EXPECT_TRUE(QTest::qWaitFor(isBlue, 10000));
}

TEST_F(WindowOpen, CardOfASceneOpensItByEnter) {
    auto* card = find<StartCard>("scene:pyramid");
    card->setFocus();
    QTest::keyClick(card, Qt::Key_Return);
    ASSERT_TRUE(document().hasScene());
    EXPECT_EQ(document().scene().name, "pyramid.scene");
    EXPECT_TRUE(find<StageStrip>("stageStrip")->isVisible());
}

TEST_F(WindowOpen, DroppedFileOpens) {
    drop(window, resourceScene("pyramid.scene"));
    ASSERT_TRUE(document().hasScene());
    EXPECT_TRUE(waitForFrame());
}

TEST_F(WindowOpen, FailedLoadKeepsTheSceneAndSaysWhereAndWhy) {
    openPyramid();
    const QImage before = pictureOnScreen();
    QFile bad(folder.filePath("bad.scene"));
    ASSERT_TRUE(bad.open(QIODevice::WriteOnly));
    bad.write("this is no scene\n");
    bad.close();

    drop(window, bad.fileName());

    EXPECT_EQ(document().scene().name, "pyramid.scene");
    auto* errors = find<ErrorList>("errorList");
    EXPECT_TRUE(errors->isVisible());
    EXPECT_TRUE(errors->text().contains("The scene before is still open."));
    EXPECT_TRUE(errors->text().contains("bad.scene:1:"));
    EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
    // The list takes some of the height; closed again, the picture is the one from before.
    QTest::keyClick(errors, Qt::Key_Escape);
    EXPECT_FALSE(errors->isVisible());
    QTest::qWait(50);
    EXPECT_EQ(pictureOnScreen(), before);
}

TEST_F(WindowOpen, CloseLeadsBackToTheStartPage) {
    openPyramid();
    press("Ctrl+W");
    EXPECT_TRUE(find<StartPage>("startPage")->isVisible());
    EXPECT_FALSE(find<StageStrip>("stageStrip")->isVisible());
}

}  // namespace
}  // namespace app
