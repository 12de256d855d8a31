#include <QDropEvent>
#include <QFile>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QPlainTextEdit>
#include <QPointer>
#include <QPushButton>
#include <QTest>
#include <cmath>
#include <set>

#include "app/buffer_view/buffer_view.h"
#include "app/canvas/buffer_canvas.h"
#include "app/compare/buffer_compare.h"
#include "app/stages/stage_strip.h"
#include "app/start/start_card.h"
#include "app/start/start_order.h"
#include "app/start/start_page.h"
#include "app/start/start_view_card.h"
#include "app/views/view_area.h"
#include "app/widgets/error_list.h"
#include "pipeline/formats/built_in_scenes.h"
#include "tests/app/window/window_fixture.h"
#include "tests/support/gltf_files.h"
#include "tests/support/little_memory.h"
#include "tests/support/model_files.h"

namespace app {
namespace {

// As a file manager drops it.
void drop(QWidget& window, const QList<QUrl>& files) {
    QMimeData data;
    data.setUrls(files);
    const QPoint at(400, 400);
    QDragEnterEvent enter(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&window, &enter);
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent event(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&window, &event);
}
void drop(QWidget& window, const QString& file) { drop(window, QList{QUrl::fromLocalFile(file)}); }

using WindowOpen = WindowTest;

TEST_F(WindowOpen, BeginsOnTheStartPageWithPicturesOfTheScenes) {
    EXPECT_TRUE(find<StartPage>("startPage")->isVisible());
    EXPECT_FALSE(find<StageStrip>("stageStrip")->isVisible());
    auto* card = find<StartCard>("scene:pyramid");
    // The pipeline computes the picture: lecture 1's pyramid is bluer than it is red.
    const auto isBlue = [&] {
        const QImage shown = card->grab().toImage();
        const QColor middle = shown.pixelColor(shown.width() / 2, shown.height() * 2 / 5);
        return middle.blue() > 100 && middle.red() < 60;
    };
    EXPECT_TRUE(QTest::qWaitFor(isBlue, 10000));
}

// Which axis of a model is up is a guess: the status bar says it, and one click turns the model.
TEST_F(WindowOpen, AGuessedUpAxisIsSaidAndTurnedByOneClick) {
    QFile file(folder.filePath("chair.obj"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("v 0 0 0\nv 2 0 0\nv 2 3 0\nv 0 3 1\nf 1 2 3\nf 1 3 4\n");
    file.close();
    ASSERT_TRUE(window.openFile(file.fileName()));
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().hasScene(); }, 10000));
    ASSERT_TRUE(waitForFrame());
    auto* turn = find<QPushButton>("statusTurn");
    ASSERT_TRUE(turn->isVisible());
    EXPECT_EQ(turn->text(), "y taken as up: use z");
    turn->click();
    ASSERT_TRUE(waitForFrame());
    EXPECT_EQ(document().scene().objects[0].transform.up, pipeline::UpAxis::Z);
    EXPECT_FALSE(turn->isVisible()) << "it is no guess any more";
    document().history().stack()->undo();
    ASSERT_TRUE(waitForFrame());
    EXPECT_EQ(document().scene().objects[0].transform.up, pipeline::UpAxis::Y);
    EXPECT_TRUE(turn->isVisible());
    openPyramid();
    EXPECT_FALSE(turn->isVisible());
}

// Lecture 1's four pictures, each with the name of its scene, at one height and one zoom.
TEST_F(WindowOpen, TheFirstCardOpensFourAlignedPictures) {
    auto* card = find<StartViewCard>("view:four-pictures");
    ASSERT_TRUE(card->isVisible());
    EXPECT_TRUE(card->hasFocus());
    press("Return");
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().frames().shown() != nullptr; }, 20000));
    ASSERT_TRUE(waitForFrame());
    const auto views = window.views().shownBuffers();
    ASSERT_EQ(views.size(), 4u);
    EXPECT_EQ(window.views().grid().withoutRoom(), 0u);
    QStringList names;
    for (BufferView* view : views) {
        EXPECT_TRUE(QTest::qWaitFor([&] { return view->compare().difference().found().has_value(); }, 20000));
        EXPECT_EQ(view->canvas()->height(), views[0]->canvas()->height());
        EXPECT_EQ(view->canvas()->placing().zoom(), views[0]->canvas()->placing().zoom());
        names += view->canvas()->wipe().nameB;
    }
    EXPECT_TRUE(names[0].contains("No hidden surface removal") && names[1].contains("Back-face culling") &&
                names[2].contains("flat") && names[3].contains("Phong"))
        << names.join("; ").toStdString();
    EXPECT_EQ(views[3]->compare().difference().found()->differing, 0u) << "the last one is the scene itself";
    EXPECT_GT(views[0]->compare().difference().found()->differing, 0u);
}

TEST_F(WindowOpen, TheSecondLecturesFirstCardOpensTheTermsAndTheirSum) {
    QTest::mouseClick(find<QPushButton>("open:three-terms"), Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().frames().shown() != nullptr; }, 20000));
    ASSERT_TRUE(waitForFrame());
    std::vector<std::string> buffers;
    for (BufferView* view : window.views().shownBuffers()) buffers.push_back(view->buffer().text());
    EXPECT_EQ(buffers, (std::vector<std::string>{"ambient", "diffuse.0", "specular.0", "color"}));
}

TEST_F(WindowOpen, TheFilterLeavesWhatMatchesAndSaysIfNothingDoes) {
    auto* field = find<QLineEdit>("startFilter");
    const auto isShown = [&](const char* name) { return find<QWidget>(name)->isVisible(); };
    ASSERT_TRUE(isShown("scene:shadow_bias") && isShown("scene:lambert") && isShown("view:three-terms"));
    field->setText("shadow");
    EXPECT_TRUE(isShown("scene:shadow_bias"));
    EXPECT_FALSE(isShown("scene:lambert"));
    EXPECT_FALSE(isShown("view:three-terms"));
    field->setText("no such scene at all");
    EXPECT_FALSE(isShown("scene:shadow_bias"));
    field->clear();
    EXPECT_TRUE(isShown("scene:lambert"));
}

// Scenes that are added later come at the end by themselves.
TEST(StartOrder, EverySceneOfTheProgramIsAFirstPictureOrInOneGroup) {
    const std::vector<StartLecture> lectures = startOrder();
    std::multiset<std::string> placed;
    for (const StartLecture& lecture : lectures)
        for (const StartGroup& group : lecture.groups) placed.insert(group.scenes.begin(), group.scenes.end());
    for (const StartView::Part& part : lectures.front().first.parts) placed.insert(part.scene);
    for (const pipeline::BuiltInScene& scene : pipeline::builtInScenes())
        EXPECT_EQ(placed.count(scene.name), 1u) << scene.name;
    EXPECT_EQ(placed.size(), pipeline::builtInScenes().size());
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

TEST_F(WindowOpen, DroppedModelOpens) {
    QFile model(folder.filePath("triangle.obj"));
    ASSERT_TRUE(model.open(QIODevice::WriteOnly));
    model.write("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    model.close();
    drop(window, model.fileName());
    ASSERT_TRUE(document().hasScene());
    EXPECT_EQ(document().scene().objects[0].mesh->polygonCount(), 1u);
}

// The square stands before the file's camera, which looks along the file's -z, our +y.
TEST_F(WindowOpen, ACameraOfTheModelsFileIsChosenByName) {
    test::Parts parts = test::squareParts();
    parts["nodes"] = R"([{"mesh": 0, "children": [1]}, {"camera": 0, "name": "front", "translation": [0.5, 0.5, 3]}])";
    parts["cameras"] = R"([{"type": "perspective", "perspective": {"yfov": 0.5, "znear": 0.5, "zfar": 9}}])";
    QFile file(folder.filePath("square.gltf"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(QByteArray::fromStdString(test::fileOf(parts)));
    file.close();
    const auto menuOf = [&]() -> QMenu* {
        for (QMenu* const menu : window.findChildren<QMenu*>())
            if (menu->title() == "Camera of the model's file") return menu;
        return nullptr;
    };
    QMenu* const cameras = menuOf();
    ASSERT_TRUE(cameras);
    auto* const all = qobject_cast<QMenu*>(cameras->parent());
    ASSERT_TRUE(all);
    openPyramid();
    emit all->aboutToShow();
    EXPECT_FALSE(cameras->isEnabled()) << "the lecture's scene has its own";
    drop(window, file.fileName());
    ASSERT_TRUE(document().hasScene());
    emit all->aboutToShow();
    ASSERT_TRUE(cameras->isEnabled());
    emit cameras->aboutToShow();
    ASSERT_TRUE(QTest::qWaitFor([&] { return cameras->actions()[0]->text() == "front"; }, 10000));
    cameras->actions()[0]->trigger();
    const auto at = [&] { return document().scene().camera.eye; };
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().history().stack()->canUndo(); }, 10000));
    EXPECT_NEAR(at().y, -3, 1e-12);
    EXPECT_NEAR(document().scene().camera.fovY, 0.5 * 180 / M_PI, 1e-12);
    document().history().stack()->undo();
    EXPECT_NE(at().y, -3);
}

TEST_F(WindowOpen, WhatCannotBeOpenedIsAnsweredWhenItIsDropped) {
    openPyramid();
    auto* errors = find<ErrorList>("errorList");
    QFile notes(folder.filePath("notes.pdf"));
    ASSERT_TRUE(notes.open(QIODevice::WriteOnly));
    notes.write("%PDF-1.7\n");
    notes.close();
    drop(window, notes.fileName());
    EXPECT_TRUE(errors->text().contains("notes.pdf could not be read.")) << errors->text().toStdString();
    EXPECT_TRUE(errors->text().contains(".scene") && errors->text().contains(".obj")) << "says what opens";
    drop(window, QList{QUrl::fromLocalFile(notes.fileName()), QUrl::fromLocalFile("/other.obj")});
    EXPECT_TRUE(errors->text().contains("2 files were dropped")) << errors->text().toStdString();
    drop(window, QList{QUrl("https://example.org/a.obj")});
    EXPECT_TRUE(errors->text().contains("is no file of this machine")) << errors->text().toStdString();
    EXPECT_EQ(document().scene().name, "pyramid.scene");
}

// A z-buffer of 4000 × 3000 numbers is 48 MB, more than there are.
TEST_F(WindowOpen, AFrameWithoutMemoryIsAnsweredAndTheWindowGoesOn) {
    if (!test::LittleMemory::kWorks) GTEST_SKIP() << "a sanitizer reserves more addresses than there are";
    openPyramid();
    auto* errors = find<ErrorList>("errorList");
    pipeline::Scene large = document().scene();
    large.settings.width = 4000, large.settings.height = 3000;
    {
        const test::LittleMemory little(40'000'000);
        document().replace(large, "size");
        EXPECT_TRUE(QTest::qWaitFor([&] { return errors->text().contains("not enough memory"); }, 30000))
            << errors->text().toStdString();
    }
    EXPECT_EQ(document().frames().shown()->scene().settings.width, 640);
    document().history().stack()->undo();
    document().change(*findSetting(document().scene(), "material.0.n"), 4);
    EXPECT_TRUE(QTest::qWaitFor(
        [&] {
            return !document().frames().busy() &&
                   document().frames().shown()->scene().objects[0].material.exponent == 4;
        },
        30000));
}

// Three million vertices are 72 MB, more than there are.
TEST_F(WindowOpen, AFileWithoutMemoryIsAnsweredAndTheWindowGoesOn) {
    if (!test::LittleMemory::kWorks) GTEST_SKIP() << "a sanitizer reserves more addresses than there are";
    openPyramid();
    auto* errors = find<ErrorList>("errorList");
    const QString file = folder.filePath("large.ply");
    QFile out(file);
    ASSERT_TRUE(out.open(QIODevice::WriteOnly));
    out.write(QByteArray::fromStdString(test::plyBytes(1'000'000)));
    out.close();
    {
        const test::LittleMemory little(40'000'000);
        window.openFile(file);
        EXPECT_TRUE(QTest::qWaitFor([&] { return errors->text().contains("not enough memory"); }, 30000))
            << errors->text().toStdString();
    }
    ASSERT_TRUE(window.openFile(resourceScene("two_pyramids.scene")));
    EXPECT_TRUE(waitForFrame());
    EXPECT_EQ(document().scene().name, "two_pyramids.scene");
}

TEST_F(WindowOpen, AFileMayBeDroppedOnAnyPartOfTheWindow) {
    openPyramid();
    int parts = 0;
    // Another scene brings other fields for its settings.
    QList<QPointer<QWidget>> all;
    for (QWidget* part : window.findChildren<QWidget*>()) all << part;
    for (const QPointer<QWidget>& part : all) {
        if (!part || !part->acceptDrops() || part->window() != &window) continue;
        ++parts;
        const std::string kind = part->metaObject()->className();
        drop(*part, resourceScene("two_pyramids.scene"));
        EXPECT_EQ(document().scene().name, "two_pyramids.scene") << kind;
        ASSERT_TRUE(window.openFile(resourceScene("pyramid.scene")));
    }
    EXPECT_GT(parts, 0) << "text fields take drops by themselves";
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
    EXPECT_TRUE(QTest::qWaitFor([&] { return pictureOnScreen() == before; }));
}

TEST_F(WindowOpen, CloseLeadsBackToTheStartPage) {
    openPyramid();
    press("Ctrl+W");
    EXPECT_TRUE(find<StartPage>("startPage")->isVisible());
    EXPECT_FALSE(find<StageStrip>("stageStrip")->isVisible());
}

}  // namespace
}  // namespace app
