#include <QCheckBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QProcess>
#include <QPushButton>
#include <QTest>
#include <QTreeWidget>
#include <algorithm>

#include "app/buffer_view/buffer_view.h"
#include "app/commands/actions.h"
#include "app/export/export_dialog.h"
#include "app/export/figure_dialog.h"
#include "app/look/theme.h"
#include "app/views/view_area.h"
#include "app/vtk/offscreen.h"
#include "tests/app/quiet.h"
#include "tests/app/window/window_fixture.h"

namespace app {
namespace {

class WindowExport : public WindowTest {
protected:
    ExportDialog* openDialog() {
        press("Ctrl+E");
        auto* dialog = window.findChild<ExportDialog*>();
        EXPECT_NE(dialog, nullptr);
        EXPECT_TRUE(test::waitUntilQuiet());
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

// As `export --views` does.
TEST_F(WindowExport, WritesTheViewsThatTheCommandLineWrites) {
    openPyramid();
    document().pointing().pick(glm::ivec2(268, 281));
    ASSERT_TRUE(waitForFrame());
    ExportDialog* dialog = openDialog();
    auto* views = dialog->findChild<QCheckBox*>("exportViews");
    ASSERT_TRUE(views && views->isVisible() && !views->isChecked());
    views->setChecked(true);
    EXPECT_TRUE(dialog->findChild<QLabel*>("exportFiles")->text().contains("world.png"));
    EXPECT_TRUE(dialog->findChild<QLineEdit*>("exportCommand")->text().contains(" --views --pixel 268,281"));
    QTest::mouseClick(dialog->findChild<QPushButton*>("exportStart"), Qt::LeftButton);
    auto* message = dialog->findChild<QLabel*>("exportMessage");
    ASSERT_TRUE(QTest::qWaitFor([&] { return message->text().contains("in the folder"); }, 60000))
        << message->text().toStdString();
    const QDir out(folder.filePath("out"));
    for (const std::string& file : viewFiles()) EXPECT_TRUE(out.exists(QString::fromStdString(file))) << file;
    EXPECT_TRUE(out.exists("point.png"));
}

std::vector<std::string> chosenIn(const ExportDialog& dialog) {
    std::vector<std::string> names;
    for (const pipeline::BufferName& name : dialog.request().buffers) names.push_back(name.text());
    return names;
}

// As seen: what lies right of a stage's check box, up to its number, is the list's ground.
TEST_F(WindowExport, ACheckBoxKeepsOffItsWordsInLargeLettersToo) {
    openPyramid();
    for (const double scale : {1.0, 2.0}) {
        Theme::current().setScale(scale);
        ExportDialog dialog(document());
        dialog.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&dialog));
        QTreeWidget* list = dialog.findChild<QTreeWidget*>();
        ASSERT_TRUE(QTest::qWaitFor([&] { return list->topLevelItemCount() > 0; }));
        const QImage row = list->viewport()->grab(list->visualItemRect(list->topLevelItem(1))).toImage();
        const auto has = [&](int x, QColor color) {
            for (int y = 0; y < row.height(); ++y)
                if (row.pixelColor(x, y) == color) return true;
            return false;
        };
        int x = 0;
        while (x < row.width() && !has(x, Theme::current().colors().fill)) ++x;
        while (x < row.width() && has(x, Theme::current().colors().fill)) ++x;
        const QColor ground = row.pixelColor(row.width() - 1, 0);
        for (const int gap : {1, 2})  // the box's smoothed border takes one
            for (int y = 0; y < row.height(); ++y) EXPECT_EQ(row.pixelColor(x + gap, y), ground) << scale;
    }
    Theme::current().setScale(1);
}

TEST_F(WindowExport, ChecksAllOrNoneOrWhatIsShown) {
    openPyramid();
    ExportDialog* dialog = openDialog();
    const auto all = chosenIn(*dialog);
    ASSERT_GT(all.size(), 10u);
    const auto click = [&](const char* name) {
        QTest::mouseClick(dialog->findChild<QPushButton*>(name), Qt::LeftButton);
        return chosenIn(*dialog);
    };
    EXPECT_EQ(click("exportNone"), std::vector<std::string>{});
    EXPECT_FALSE(dialog->findChild<QPushButton*>("exportStart")->isEnabled());
    const auto shown = click("exportShown");
    EXPECT_EQ(std::ranges::count(shown, "color"), 1);
    EXPECT_LE(shown.size(), 2u) << "of two views at most";
    EXPECT_EQ(click("exportAll"), all);
}

// Culling has one buffer and normals two; the shadow buffer of one convex object is left out, and its stage has no mark.
TEST_F(WindowExport, AStagesMarkAndSpaceCheckSeveral) {
    openPyramid();
    ExportDialog* dialog = openDialog();
    auto* list = dialog->findChild<QTreeWidget*>("exportBuffers");
    const auto all = chosenIn(*dialog);
    QTest::mouseClick(dialog->findChild<QPushButton*>("exportNone"), Qt::LeftButton);
    QTreeWidgetItem* cull = list->topLevelItem(1);
    ASSERT_EQ(cull->text(0), "2 Cull");
    EXPECT_EQ(cull->checkState(0), Qt::Unchecked);
    cull->setCheckState(0, Qt::Checked);
    EXPECT_EQ(chosenIn(*dialog), std::vector<std::string>{"polygons.verdict"});
    cull->child(0)->setCheckState(0, Qt::Unchecked);
    EXPECT_EQ(cull->checkState(0), Qt::Unchecked);
    QTreeWidgetItem* transform = list->topLevelItem(0);
    transform->child(0)->setCheckState(0, Qt::Checked);
    EXPECT_EQ(transform->checkState(0), Qt::PartiallyChecked);
    EXPECT_FALSE(list->topLevelItem(3)->data(0, Qt::CheckStateRole).isValid());

    list->setFocus();
    list->setCurrentItem(cull->child(0));
    QTest::keyClick(list, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClick(list, Qt::Key_Space);
    EXPECT_GE(chosenIn(*dialog).size(), all.size());
    QTest::keyClick(list, Qt::Key_Space);
    EXPECT_TRUE(chosenIn(*dialog).empty());
}

TEST_F(WindowExport, SavesTheActiveViewsBufferAlone) {
    openPyramid();
    window.views().showBuffer({pipeline::BufferId::Depth});
    ASSERT_TRUE(waitForFrame());
    window.findChild<Actions*>()->operator[](ActionId::SaveBuffer)->trigger();
    auto* dialog = window.findChild<ExportDialog*>();
    ASSERT_NE(dialog, nullptr);
    EXPECT_TRUE(test::waitUntilQuiet());
    ASSERT_TRUE(waitForFrame());  // with more buffers, which stay unchecked
    EXPECT_EQ(chosenIn(*dialog), std::vector<std::string>{"depth"});
    EXPECT_TRUE(dialog->findChild<QLineEdit*>("exportCommand")->text().contains("--buffers depth"));
    EXPECT_TRUE(dialog->findChild<QLabel*>("exportTotal")->text().startsWith("1 buffer, "));
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

// The file of a large scene takes long to read: more than once would hold the window with every key.
TEST_F(WindowExport, CommandLineNeedsTheSceneFileNoMore) {
    openPyramid();
    const QString file = folder.filePath("own.toml");
    ASSERT_TRUE(document().save(file));
    ASSERT_TRUE(window.openFile(file));
    document().change(*findSetting(document().scene(), "material.0.n"), 4);
    ASSERT_TRUE(waitForFrame());
    ExportDialog* dialog = openDialog();
    ASSERT_TRUE(QFile::remove(file));
    dialog->findChild<QLineEdit*>("exportFolder")->setText(folder.filePath("other"));
    const QString command = dialog->findChild<QLineEdit*>("exportCommand")->text();
    EXPECT_TRUE(command.contains("other") && command.contains("--set material.0.n=4")) << command.toStdString();
    document().history().stack()->setClean();
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

TEST_F(WindowExport, EscapeCancelsAndSaysSoAndThenCloses) {
    openPyramid();
    ExportDialog* dialog = openDialog();
    dialog->findChild<QLineEdit*>("exportWidth")->setText("4000");
    dialog->findChild<QLineEdit*>("exportHeight")->setText("3000");
    QTest::mouseClick(dialog->findChild<QPushButton*>("exportStart"), Qt::LeftButton);
    QTest::keyClick(dialog, Qt::Key_Escape);
    ASSERT_TRUE(dialog->isVisible());
    auto* message = dialog->findChild<QLabel*>("exportMessage");
    ASSERT_TRUE(QTest::qWaitFor([&] { return message->text().contains("Cancelled"); }, 60000));
    QTest::keyClick(dialog, Qt::Key_Escape);
    EXPECT_FALSE(dialog->isVisible());
}

class WindowFigure : public WindowTest {
protected:
    FigureDialog* openDialog() {
        openPyramid();
        document().pointing().pick(glm::ivec2(268, 281));
        window.views().first().setBuffer({pipeline::BufferId::ZView});
        EXPECT_TRUE(waitForFrame());
        window.actions()[ActionId::Figure]->trigger();
        auto* dialog = window.findChild<FigureDialog*>();
        EXPECT_NE(dialog, nullptr);
        auto* picture = dialog->findChild<QLabel*>("figurePreview");
        EXPECT_TRUE(QTest::qWaitFor([=] { return !picture->pixmap().isNull(); }, 30000));
        return dialog;
    }
    void save(FigureDialog& dialog, const QString& file) {
        dialog.save(file);
        EXPECT_TRUE(QTest::qWaitFor([&] { return dialog.message().contains("Saved"); }, 30000))
            << dialog.message().toStdString();
    }
    static QByteArray bytesOf(const QString& file) {
        QFile read(file);
        EXPECT_TRUE(read.open(QFile::ReadOnly));
        return read.readAll();
    }
    static void choosePng(FigureDialog& dialog) {
        const auto buttons = dialog.findChild<QWidget*>("figureFormat")->findChildren<QPushButton*>();
        QTest::mouseClick(buttons.back(), Qt::LeftButton);
    }
};

// The dialog's last line, run in a shell, gives the same bytes.
TEST_F(WindowFigure, WritesWhatTheCommandWrites) {
    FigureDialog* dialog = openDialog();
    dialog->findChild<QCheckBox*>("figureEdges")->setChecked(true);
    dialog->findChild<QCheckBox*>("figureGrid")->setChecked(true);
    dialog->findChild<QDoubleSpinBox*>("figureWidth")->setValue(120);
    save(*dialog, folder.filePath("z.svg"));
    QStringList words = QProcess::splitCommand(dialog->findChild<QLineEdit*>("figureCommand")->text());
    ASSERT_GT(words.size(), 4);
    EXPECT_EQ(words.takeFirst(), "shadescope");
    EXPECT_TRUE(words.contains("z_view") && words.contains("268,281") && words.contains("120mm")) << words.size();
    words.replace(words.indexOf("-o") + 1, folder.filePath("same.svg"));
    QProcess program;
    program.start(SHADESCOPE_PROGRAM, words);
    ASSERT_TRUE(program.waitForFinished(60000));
    EXPECT_EQ(program.exitCode(), 0) << program.readAllStandardError().toStdString();
    EXPECT_TRUE(bytesOf(folder.filePath("z.svg")) == bytesOf(folder.filePath("same.svg")));
}

// Width and format; the caption that is typed stays until "As made".
TEST_F(WindowFigure, TheNextFigureBeginsWithTheSizeAndFormatOfTheLast) {
    FigureDialog* dialog = openDialog();
    choosePng(*dialog);
    dialog->findChild<QDoubleSpinBox*>("figureWidth")->setValue(50.8);  // two inches: 600 dots
    auto* caption = dialog->findChild<QPlainTextEdit*>("figureCaption");
    EXPECT_TRUE(caption->toPlainText().contains("671.45 world units")) << caption->toPlainText().toStdString();
    caption->setPlainText("Mine");
    save(*dialog, folder.filePath("z.png"));
    EXPECT_EQ(QImage(folder.filePath("z.png")).width(), 600);
    EXPECT_TRUE(dialog->findChild<QLineEdit*>("figureCommand")->text().contains("--caption Mine"));
    QTest::mouseClick(dialog->findChild<QPushButton*>("figureAsMade"), Qt::LeftButton);
    EXPECT_TRUE(QTest::qWaitFor([&] { return caption->toPlainText().contains("671.45"); }, 30000));
    delete dialog;
    FigureDialog again(document(), {.buffer = {pipeline::BufferId::Color}});
    EXPECT_EQ(again.findChild<QDoubleSpinBox*>("figureWidth")->value(), 50.8);
    EXPECT_TRUE(again.findChild<QLineEdit*>("figureCommand")->text().endsWith("color.png"));
}

TEST_F(WindowFigure, SaysWhyThereIsNone) {
    openPyramid();
    FigureDialog dialog(document(), {.buffer = {pipeline::BufferId::VerticesWorld}});
    EXPECT_TRUE(dialog.findChild<QLabel*>("figurePreview")->text().contains("no pixels"));
    EXPECT_FALSE(dialog.findChild<QPushButton*>("figureStart")->isEnabled());
    EXPECT_FALSE(dialog.findChild<QPushButton*>("figureCopy")->isEnabled());
}

}  // namespace
}  // namespace app
