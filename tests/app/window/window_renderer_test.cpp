// Somebody else's renderer in the window: a folder is dropped, and the views show mine, reference and classes.
#include <QDropEvent>
#include <QMimeData>
#include <QTest>
#include <QTreeWidget>

#include "app/buffer_view/buffer_view.h"
#include "app/compare/buffer_compare.h"
#include "app/compare/stage_differences.h"
#include "app/document/recent_files.h"
#include "app/my_renderer/renderer_panel.h"
#include "app/start/start_line.h"
#include "app/views/view_area.h"
#include "app/widgets/error_list.h"
#include "pipeline/formats/toml/toml_writer.h"
#include "tests/app/panels/renderer_files.h"
#include "tests/app/window/window_fixture.h"

namespace app {
namespace {

using pipeline::Defect;
using pipeline::StageId;

class WindowRenderer : public WindowTest {
protected:
    WindowRenderer() { handIn(folder.path(), Defect::NormalMatrix); }
    void openScene() {
        document().setScene(smallCheckMe());
        ASSERT_TRUE(waitForFrame());
    }
    void drop(const QString& file) {
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(file)});
        QDragEnterEvent enter(QPoint(400, 400), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&window, &enter);
        QDropEvent event(QPointF(400, 400), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&window, &event);
    }
    bool waitForNames() { return waitForReport(document().renderer()) && waitForFrame(); }
};

TEST_F(WindowRenderer, ADroppedFolderIsComparedAndShownInAllViews) {
    openScene();
    const std::string before = window.views().arrangement();
    drop(folder.path());
    ASSERT_TRUE(waitForNames());
    EXPECT_TRUE(find<RendererPanel>("rendererPanel")->isVisible());
    EXPECT_EQ(document().stage(), StageId::Normals);
    EXPECT_TRUE(document().pointing().pixel());
    const auto views = window.views().shownBuffers();
    ASSERT_GE(views.size(), 2u);
    for (BufferView* view : views) {
        EXPECT_TRUE(view->compare().isMine());
        EXPECT_EQ(view->buffer().id, pipeline::BufferId::Normal);
    }
    // The first shows mine, the second the reference.
    EXPECT_EQ(views[0]->compare().mode(), CompareMode::B);
    EXPECT_EQ(views[1]->compare().mode(), CompareMode::A);
    ASSERT_TRUE(QTest::qWaitFor([&] { return views[0]->compare().difference().found().has_value(); }, 30000));
    EXPECT_GT(views[0]->compare().difference().found()->differing, 0u);

    document().renderer().close();
    EXPECT_EQ(window.views().arrangement(), before);
    for (BufferView* view : window.views().shownBuffers()) EXPECT_FALSE(view->compare().isOn());
}

TEST_F(WindowRenderer, ByStageComparesTheStagesOwnFiles) {
    openScene();
    drop(folder.path());
    ASSERT_TRUE(waitForNames());
    BufferView& view = window.views().first();
    auto* stages = view.findChild<StageDifferences*>();
    ASSERT_NE(stages, nullptr);
    document().frames().want(&window, pipeline::usefulBuffers(document().scene()));
    ASSERT_TRUE(waitForFrame());
    emit view.compare().stagesChosen();
    // Five files were handed in: a row each, below those of their stages.
    const auto rowOf = [&](const QString& buffer) -> QTreeWidgetItem* {
        const auto found = stages->list().findItems(buffer, Qt::MatchExactly | Qt::MatchRecursive);
        return found.isEmpty() ? nullptr : found.front();
    };
    ASSERT_TRUE(QTest::qWaitFor([&] { return rowOf("color") != nullptr; }, 30000));
    EXPECT_NE(rowOf("vertices.normal")->text(1), "the same");
    EXPECT_NE(rowOf("normal")->text(1), "the same");
    EXPECT_EQ(rowOf("ambient"), nullptr) << "it was not handed in";
    stages->close();
}

TEST_F(WindowRenderer, AFolderBringsItsScene) {
    QFile scene(folder.filePath("check_me.toml"));
    ASSERT_TRUE(scene.open(QIODevice::WriteOnly));
    scene.write(QByteArray::fromStdString(*toTomlScene(smallCheckMe())));
    scene.close();
    drop(folder.path());
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().hasScene(); }, 30000));
    ASSERT_TRUE(waitForNames());
    EXPECT_EQ(document().renderer().report()->firstWrong, StageId::Normals);
}

// shadescope FOLDER
TEST_F(WindowRenderer, AFolderThatIsOpenedAsAFileIsCheckedAsADroppedOneIs) {
    QFile scene(folder.filePath("check_me.toml"));
    ASSERT_TRUE(scene.open(QIODevice::WriteOnly));
    scene.write(QByteArray::fromStdString(*toTomlScene(smallCheckMe())));
    scene.close();
    window.openFile(folder.path());
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().hasScene(); }, 30000));
    ASSERT_TRUE(waitForNames());
    EXPECT_TRUE(find<RendererPanel>("rendererPanel")->isVisible());
    EXPECT_EQ(document().renderer().report()->firstWrong, StageId::Normals);
}

// From the start page, with the scene that it was compared with, which is not in the folder.
TEST_F(WindowRenderer, ACheckedFolderIsAmongTheRecentFilesWithWhatWasFound) {
    QTemporaryDir elsewhere;
    const QString file = elsewhere.filePath("check_me.toml");
    QFile scene(file);
    ASSERT_TRUE(scene.open(QIODevice::WriteOnly));
    scene.write(QByteArray::fromStdString(*toTomlScene(smallCheckMe())));
    scene.close();
    ASSERT_TRUE(window.openFile(file));
    ASSERT_TRUE(waitForFrame());
    drop(folder.path());
    ASSERT_TRUE(waitForNames());
    const std::vector<RecentFile> recent = recentFiles();
    ASSERT_FALSE(recent.empty());
    EXPECT_EQ(recent.front().file, QFileInfo(folder.path()).absoluteFilePath());
    EXPECT_TRUE(recent.front().where.contains("Normals")) << recent.front().where.toStdString();
    window.files().close();
    for (StartLine* line : window.findChildren<StartLine*>())
        if (line->text() == nameOf(recent.front())) QTest::mouseClick(line, Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().hasScene() && document().renderer().isOpen(); }, 30000));
    EXPECT_EQ(document().scene().file, file.toStdString());
}

TEST_F(WindowRenderer, WithoutASceneTheReasonIsSaid) {
    drop(folder.path());
    auto* errors = window.centralWidget()->findChild<ErrorList*>();
    EXPECT_TRUE(errors->text().contains("there is no scene to compare")) << errors->text().toStdString();
    EXPECT_FALSE(document().renderer().isOpen());
}

TEST_F(WindowRenderer, OpeningALessonLeavesTheRenderersViews) {
    openScene();
    const std::string before = window.views().arrangement();
    drop(folder.path());
    ASSERT_TRUE(waitForNames());
    window.lessons().open("pyramid");
    for (BufferView* view : window.views().shownBuffers()) EXPECT_FALSE(view->compare().isMine());
}

}  // namespace
}  // namespace app
