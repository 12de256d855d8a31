// The document without a window: what it holds, what it refuses, what it undoes.
#include "app/document/document.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "pipeline/export/export_frame.h"
#include "pipeline/formats/scene_reader.h"
#include "pipeline/run/runner.h"
#include "tests/support/little_memory.h"

namespace app {
namespace {

class DocumentTest : public testing::Test {
protected:
    DocumentTest() {
        auto scene = pipeline::readScene(pipeline::resourceFolder() / "scenes" / "pyramid.scene");
        EXPECT_TRUE(scene);
        document.setScene(std::move(scene).value());
    }
    pipeline::SettingRef setting(const char* key) { return *findSetting(document.scene(), key); }
    double exponent() { return document.scene().objects[0].material.exponent; }
    bool waitForFrame() {
        return QTest::qWaitFor([this] { return document.frames().shown() && !document.frames().busy(); }, 30000);
    }
    Document document;
};

TEST_F(DocumentTest, DragIsOneStepNamedByItsEnds) {
    for (const double n : {7.0, 6.0, 5.0}) document.change(setting("material.0.n"), n, Document::Change::Live);
    document.change(setting("material.0.n"), 4, Document::Change::Done);
    EXPECT_EQ(document.history().stack()->count(), 1);
    EXPECT_EQ(document.history().stack()->undoText(), "n exponent 8 → 4");
    document.history().stack()->undo();
    EXPECT_EQ(exponent(), 8);
}

// A slider may outlive its light: undone while it is dragged, say.
TEST_F(DocumentTest, ASettingOfWhatHasGoneChangesNothing) {
    const pipeline::SettingRef light = setting("light.0.x"), material = setting("material.0.n");
    pipeline::Scene empty = document.scene();
    empty.lights.clear(), empty.objects.clear();
    document.edit(empty, "empty", Document::Change::Done);
    document.change(light, 3, Document::Change::Live);
    document.change(material, 3);
    EXPECT_EQ(document.scene(), empty);
    EXPECT_EQ(document.history().stack()->count(), 1);
}

TEST_F(DocumentTest, TwoDragsAreTwoSteps) {
    document.change(setting("material.0.n"), 6, Document::Change::Live);
    document.change(setting("material.0.n"), 6, Document::Change::Done);
    document.change(setting("material.0.n"), 5, Document::Change::Live);
    document.change(setting("material.0.n"), 4, Document::Change::Done);
    EXPECT_EQ(document.history().stack()->count(), 2);
    document.history().stack()->undo();
    EXPECT_EQ(exponent(), 6);
}

TEST_F(DocumentTest, DragBackToItsBeginningLeavesNoStep) {
    document.change(setting("material.0.n"), 6, Document::Change::Live);
    document.change(setting("material.0.n"), 8, Document::Change::Live);
    document.change(setting("material.0.n"), 8, Document::Change::Done);
    EXPECT_EQ(document.history().stack()->count(), 0);
}

TEST_F(DocumentTest, ACancelledFrameLeavesTheOneBeforeUntilItIsToGoOn) {
    ASSERT_TRUE(waitForFrame());
    const auto before = document.frames().shown();
    pipeline::Scene large = document.scene();
    large.settings.width = 4000, large.settings.height = 3000;
    const auto showLargeAndCancel = [&] {
        document.replace(large, "size");
        QCoreApplication::processEvents();
        ASSERT_TRUE(document.frames().busy());
        document.work().cancel();
        EXPECT_FALSE(document.frames().busy());
        EXPECT_TRUE(document.work().stopped().contains("the frame"));
    };
    showLargeAndCancel();
    QObject view;  // asks for what has been asked for, as one that is shown again does
    document.frames().want(&view, pipeline::setOf({pipeline::BufferId::Color}));
    QTest::qWait(300);
    EXPECT_FALSE(document.frames().busy());
    EXPECT_EQ(document.frames().shown(), before);
    EXPECT_TRUE(document.work().stopped().contains("the frame"));
    document.work().resume();
    EXPECT_TRUE(document.work().stopped().isEmpty());
    ASSERT_TRUE(waitForFrame());
    EXPECT_EQ(document.frames().shown()->scene().settings.width, 4000);
    ++large.settings.width;
    showLargeAndCancel();
    for (int i = 0; i < 2; ++i) document.history().stack()->undo();
    QCoreApplication::processEvents();
    EXPECT_FALSE(document.work().stopped().contains("the frame")) << "newer work is not stopped";
    ASSERT_TRUE(waitForFrame());
    EXPECT_EQ(document.frames().shown()->scene().settings.width, 640);
}

// Of 4000 × 3000 pixels the positions and the normals are 144 MB each: neither fits into 100 MB more.
TEST_F(DocumentTest, AFrameWithoutMemoryLeavesTheOneBeforeAndIsTold) {
    if (!test::LittleMemory::kWorks) GTEST_SKIP() << "a sanitizer reserves more addresses than there are";
    ASSERT_TRUE(waitForFrame());
    const auto before = document.frames().shown();
    QSignalSpy told(&document.frames(), &FrameFeed::outOfMemory);
    QObject view;
    document.frames().want(&view, pipeline::setOf({pipeline::BufferId::Position, pipeline::BufferId::Normal}));
    ASSERT_TRUE(waitForFrame());
    pipeline::Scene large = document.scene();
    large.settings.width = 4000, large.settings.height = 3000;
    {
        const test::LittleMemory little(100'000'000);
        document.replace(large, "size");
        ASSERT_TRUE(told.wait(30000));
        EXPECT_FALSE(document.frames().busy());
        EXPECT_EQ(document.frames().shown()->scene().settings.width, before->scene().settings.width);
        QTest::qWait(300);
        EXPECT_EQ(told.count(), 1) << "it is not tried again by itself";
    }
    ++large.settings.height;
    document.replace(large, "size");  // with memory again
    ASSERT_TRUE(waitForFrame());
    EXPECT_EQ(document.frames().shown()->scene().settings.width, 4000);
    EXPECT_EQ(told.count(), 1);
}

TEST_F(DocumentTest, RefusesWhatIsOutOfRange) {
    QSignalSpy failed(&document, &Document::failed);
    for (const double value : {-0.1, 1e300, double(NAN), double(INFINITY)})
        document.change(setting("material.0.n"), value);
    EXPECT_EQ(failed.count(), 4);
    EXPECT_EQ(document.history().stack()->count(), 0);
}

TEST_F(DocumentTest, ASavedSceneOpensAsItWas) {
    QTemporaryDir folder;
    const QString file = folder.filePath("mine.toml");
    document.change(setting("material.0.n"), 33);
    document.change(setting("shading"), 2);
    ASSERT_TRUE(document.save(file));
    EXPECT_TRUE(document.history().stack()->isClean());
    const pipeline::Scene saved = document.scene();
    Document other;
    const auto opened = readSceneFile(file);
    ASSERT_TRUE(opened) << format(opened.errors());
    other.open(*opened);
    EXPECT_EQ(other.scene().settings, saved.settings);
    EXPECT_EQ(other.scene().objects[0].material, saved.objects[0].material);
    EXPECT_EQ(other.scene().objects[0].mesh->positions, saved.objects[0].mesh->positions);
    QSignalSpy notWritten(&document, &Document::notWritten), failed(&document, &Document::failed);
    EXPECT_FALSE(document.save(folder.filePath("missing/mine.toml")));
    EXPECT_EQ(notWritten.count(), 1);
    EXPECT_EQ(failed.count(), 0) << "of what was read";
}

TEST_F(DocumentTest, APictureOpensItsSceneAtTheStageOfWhatItShows) {
    QTemporaryDir folder;
    document.change(setting("material.0.n"), 33);
    pipeline::FrameRequest wanted;
    wanted.wanted = pipeline::setOf({pipeline::BufferId::PolygonsVerdict, pipeline::BufferId::ZView});
    const auto frame = pipeline::runFrame(std::make_shared<const pipeline::Scene>(document.scene()), wanted, {});
    pipeline::ExportRequest request;
    request.folder = folder.filePath("out").toStdString();
    request.formats = {"png"};
    request.buffers = {{pipeline::BufferId::ZView}};
    ASSERT_TRUE(exportFrame(*frame, request, {}));
    Document other;
    const auto opened = readSceneFile(folder.filePath("out/z_view.png"));
    ASSERT_TRUE(opened) << format(opened.errors());
    other.open(*opened);
    EXPECT_EQ(other.scene().objects[0].material.exponent, 33);
    EXPECT_EQ(other.stage(), pipeline::StageId::ZBuffer);
}

TEST_F(DocumentTest, WantedBuffersAreInTheFrameAndForgottenWithWhoWantedThem) {
    using pipeline::BufferId;
    ASSERT_TRUE(waitForFrame());
    {
        QObject panel;
        document.frames().want(&panel, pipeline::setOf({BufferId::NDotL}));
        ASSERT_TRUE(waitForFrame());
        EXPECT_TRUE(document.frames().shown()->buffer({BufferId::NDotL, 0}));
    }
    // What nobody shows any more is not computed with the next change.
    document.change(setting("material.0.n"), 4);
    ASSERT_TRUE(waitForFrame());
    EXPECT_FALSE(document.frames().shown()->buffer({BufferId::NDotL, 0}));
    EXPECT_TRUE(document.frames().shown()->buffer({BufferId::Color}));
}

TEST_F(DocumentTest, WhatIsWantedAtRestComesAfterTheDragAndNotDuringIt) {
    const QObject thumbnails;
    document.frames().want(&thumbnails, pipeline::setOf({pipeline::BufferId::NDotL}), FrameFeed::When::AtRest);
    ASSERT_TRUE(waitForFrame());
    EXPECT_TRUE(document.frames().shown()->buffer({pipeline::BufferId::NDotL, 0}));
    document.change(setting("camera.theta"), 35, Document::Change::Live);
    ASSERT_TRUE(
        QTest::qWaitFor([&] { return document.frames().shown()->sharedScene()->camera == document.scene().camera; }));
    EXPECT_FALSE(document.frames().shown()->buffer({pipeline::BufferId::NDotL, 0}));
    // The hand rests, with the button still down.
    EXPECT_TRUE(QTest::qWaitFor([&] {
        return document.frames().shown()->buffer({pipeline::BufferId::NDotL, 0}).has_value();
    }));
    EXPECT_EQ(document.frames().shown()->sharedScene()->camera, document.scene().camera);
}

// Somebody that is behind for good holds no frame longer than 16 ms, and the last one of a drag not at all.
TEST_F(DocumentTest, AViewThatIsBehindHoldsFramesOfADragForAMoment) {
    const QObject view;
    document.frames().want(&view, {});
    ASSERT_TRUE(waitForFrame());
    QSignalSpy frames(&document.frames(), &FrameFeed::frameReady);
    QElapsedTimer time;
    time.start();
    document.change(setting("camera.theta"), 46, Document::Change::Live);
    document.frames().hold(&view, true);
    for (int i = 1; i <= 60; ++i) {
        document.change(setting("camera.theta"), 46 + 0.1 * i, Document::Change::Live);
        QTest::qWait(5);
    }
    EXPECT_GE(frames.count(), 3);
    EXPECT_LE(frames.count(), time.elapsed() / 16 + 2);
    const auto before = frames.count();
    document.change(setting("camera.theta"), 60, Document::Change::Done);
    ASSERT_TRUE(waitForFrame());
    EXPECT_LE(frames.count(), before + 2);
    EXPECT_EQ(document.frames().shown()->sharedScene()->camera, document.scene().camera);
}

TEST_F(DocumentTest, AViewThatHasCaughtUpLetsTheNextFrameBeginAtOnce) {
    const QObject view;
    document.frames().want(&view, {});
    ASSERT_TRUE(waitForFrame());
    QSignalSpy frames(&document.frames(), &FrameFeed::frameReady);
    document.change(setting("camera.theta"), 46, Document::Change::Live);
    document.frames().hold(&view, true);
    ASSERT_TRUE(QTest::qWaitFor([&] { return frames.count() == 1; }));
    document.change(setting("camera.theta"), 47, Document::Change::Live);
    document.frames().hold(&view, false);
    ASSERT_TRUE(waitForFrame());
    EXPECT_EQ(document.frames().shown()->sharedScene()->camera, document.scene().camera);
}

TEST_F(DocumentTest, PickedPixelStaysInThePicture) {
    document.pointing().pick(glm::ivec2(10000, -3));
    EXPECT_EQ(document.pointing().pixel(), glm::ivec2(639, 0));
    document.change(setting("width"), 100);
    EXPECT_EQ(document.pointing().pixel(), glm::ivec2(99, 0));
}

TEST_F(DocumentTest, StagesEndAtTheFirstAndTheLast) {
    document.setStage(pipeline::StageId::Shading);
    document.nextStage();
    EXPECT_EQ(document.stage(), pipeline::StageId::Shading);
    for (int i = 0; i < 10; ++i) document.previousStage();
    EXPECT_EQ(document.stage(), pipeline::StageId::Transform);
}

TEST_F(DocumentTest, LastChangeTellsTheValueBefore) {
    EXPECT_FALSE(document.history().lastChange());
    document.change(setting("material.0.n"), 4);
    ASSERT_TRUE(document.history().lastChange());
    EXPECT_EQ(document.history().lastChange()->before, 8);
    document.history().stack()->undo();
    EXPECT_FALSE(document.history().lastChange());
}

TEST_F(DocumentTest, SaysWhatRanAgainAndWhy) {
    ASSERT_TRUE(waitForFrame());
    QSignalSpy said(&document, &Document::said);
    document.change(setting("material.0.n"), 4);
    ASSERT_TRUE(waitForFrame());
    ASSERT_GT(said.count(), 0);
    // Transform, cull, normals and z-buffer do not read materials; the shadow buffer is left out.
    EXPECT_EQ(said.last().front().toString(), "Shading ran again because material 0 changed; 4 stages were reused.");
}

TEST_F(DocumentTest, ErrorsOfTheFrameComeInIdleTime) {
    QSignalSpy ready(&document.frames(), &FrameFeed::errorsReady);
    ASSERT_TRUE(QTest::qWaitFor([&] { return ready.count() > 0; }, 30000));
    EXPECT_TRUE(document.frames().errors()[index(pipeline::StageId::ZBuffer)]);
    EXPECT_EQ(document.frames().nanCount(), std::size_t(0));
}

}  // namespace
}  // namespace app
