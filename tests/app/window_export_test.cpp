#include <QCheckBox>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>

#include "app/panels/export_dialog.h"
#include "tests/app/window_fixture.h"

namespace app {
namespace {

class WindowExport : public WindowTest {
protected:
    ExportDialog* openDialog() {
        press("Ctrl+E");
        auto* dialog = window.findChild<ExportDialog*>();
        EXPECT_NE(dialog, nullptr);
        QTest::qWait(50);
        EXPECT_TRUE(waitForFrame());  // with every buffer that the dialog lists
        dialog->findChild<QLineEdit*>("exportFolder")->setText(folder.filePath("out"));
        return dialog;
    }
};

TEST_F(WindowExport, WritesTheFrameThatTheWindowShows) {
    openPyramid();
    ExportDialog* dialog = openDialog();
    QTest::mouseClick(dialog->findChild<QPushButton*>("exportStart"), Qt::LeftButton);
    auto* message = dialog->findChild<QLabel*>("exportMessage");
    ASSERT_TRUE(QTest::qWaitFor([&] { return message->text().contains("in the folder"); }, 60000));
    const QDir out(folder.filePath("out"));
    EXPECT_TRUE(out.exists("manifest.json"));
    EXPECT_TRUE(out.exists("depth.npy"));
    const QImage picture(out.filePath("color.png"));
    ASSERT_EQ(picture.size(), QSize(640, 480));
    for (const glm::ivec2 pixel : {glm::ivec2(268, 281), glm::ivec2(0, 0), glm::ivec2(292, 259)})
        EXPECT_EQ(picture.pixelColor(pixel.x, pixel.y), frameColor(pixel));
}

TEST_F(WindowExport, CommandLineNamesWhatWasChanged) {
    openPyramid();
    document().change(*findSetting(document().scene(), "material.0.n"), 4);
    ASSERT_TRUE(waitForFrame());
    ExportDialog* dialog = openDialog();
    const QString command = dialog->findChild<QLineEdit*>("exportCommand")->text();
    EXPECT_TRUE(command.contains("shadescope export"));
    EXPECT_TRUE(command.contains("pyramid.scene"));
    EXPECT_TRUE(command.contains("--format npy,png"));
    EXPECT_TRUE(command.contains("--set material.0.n=4"));
    EXPECT_FALSE(command.contains("--buffers"));  // all of them, as the command takes by itself
}

TEST_F(WindowExport, SaysWhyASceneHasNoOpenGlCalls) {
    openPyramid();
    ExportDialog* dialog = openDialog();
    auto* calls = dialog->findChild<QCheckBox*>("format:opengl");
    ASSERT_NE(calls, nullptr);
    EXPECT_FALSE(calls->isEnabled());
    EXPECT_TRUE(calls->toolTip().contains("set model to opengl")) << calls->toolTip().toStdString();
}

TEST_F(WindowExport, WritesTheOpenGlCalls) {
    openPyramid();
    document().change(*findSetting(document().scene(), "model"), 2);  // opengl
    ASSERT_TRUE(waitForFrame());
    ExportDialog* dialog = openDialog();
    ASSERT_NE(dialog, nullptr);
    auto* calls = dialog->findChild<QCheckBox*>("format:opengl");
    ASSERT_TRUE(calls->isEnabled());
    calls->click();
    EXPECT_TRUE(dialog->findChild<QLineEdit*>("exportCommand")->text().contains("--format npy,png,opengl"));
    QTest::mouseClick(dialog->findChild<QPushButton*>("exportStart"), Qt::LeftButton);
    auto* message = dialog->findChild<QLabel*>("exportMessage");
    ASSERT_TRUE(QTest::qWaitFor([&] { return message->text().contains("in the folder"); }, 60000));
    QFile file(folder.filePath("out/pyramid.gl.c"));
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_TRUE(file.readAll().contains("glBegin("));
}

TEST_F(WindowExport, CancelledExportLeavesNothing) {
    openPyramid();
    ExportDialog* dialog = openDialog();
    // Large enough to be cancelled while it is computed.
    dialog->findChild<QLineEdit*>("exportWidth")->setText("4000");
    dialog->findChild<QLineEdit*>("exportHeight")->setText("3000");
    QTest::mouseClick(dialog->findChild<QPushButton*>("exportStart"), Qt::LeftButton);
    QTest::mouseClick(dialog->findChild<QPushButton*>("exportCancel"), Qt::LeftButton);
    auto* message = dialog->findChild<QLabel*>("exportMessage");
    ASSERT_TRUE(QTest::qWaitFor([&] { return message->text().contains("Cancelled"); }, 60000));
    EXPECT_FALSE(QFile::exists(folder.filePath("out/manifest.json")));
    EXPECT_FALSE(QFile::exists(folder.filePath("out/color.png")));
}

}  // namespace
}  // namespace app
