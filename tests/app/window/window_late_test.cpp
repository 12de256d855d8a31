// Frames are late on a slow machine: until a cue's own picture is there, no other stands under its words.
#include <QLabel>
#include <QTest>

#include "app/buffer_view/buffer_view.h"
#include "app/canvas/buffer_canvas.h"
#include "app/talk/cue_model.h"
#include "app/talk/cue_panel.h"
#include "app/views/view_area.h"
#include "tests/app/window/window_fixture.h"

namespace app {
namespace {

// What the veil over a view's picture says; empty without one.
QString lateWords(const BufferView& view) {
    const auto* veil = view.findChild<QLabel*>("lateVeil");
    return veil->isHidden() ? QString() : veil->text();
}

using WindowLate = WindowTest;

TEST_F(WindowLate, NoPictureOfAnotherCueStandsUnderACuesWords) {
    CueModel& model = window.cues().model();
    model.clear();
    ASSERT_TRUE(model.saveAs(folder.filePath("talk.cues")));
    openPyramid();
    press("Ctrl+B");
    document().change(*findSetting(document().scene(), "camera.theta"), 47.25);
    ASSERT_TRUE(waitForFrame());
    press("Ctrl+B");
    document().history().stack()->setClean();
    ASSERT_TRUE(window.openFile(resourceScene("two_pyramids.scene")));
    ASSERT_TRUE(waitForFrame());
    press("Ctrl+B");
    ASSERT_EQ(model.size(), 3);
    int seen = 0;
    QObject context;
    QObject::connect(&model, &CueModel::changed, &context, [&] {
        for (const BufferView* view : window.views().shownBuffers()) {
            const bool isOwn = view->frame() && view->frame()->sharedScene() == document().sharedScene() &&
                               view->frame() == document().frames().shown() && !document().frames().busy();
            EXPECT_TRUE(isOwn || !lateWords(*view).isEmpty() || !view->message().isEmpty())
                << "cue " << model.current();
            ++seen;
        }
    });
    for (const int cue : {0, 1, 0, 2, 1}) {
        emit window.findChild<CuePanel*>()->asked(cue);
        ASSERT_TRUE(QTest::qWaitFor([&] { return model.current() == cue; }, 20000));
        ASSERT_TRUE(waitForFrame());
        for (const BufferView* view : window.views().shownBuffers())
            EXPECT_EQ(lateWords(*view), "") << "the picture has come, cue " << cue;
    }
    EXPECT_GE(seen, 5);
}

// A's picture is not B's because B has not come yet.
TEST_F(WindowLate, ASideThatIsNotThereYetIsNotShownAsTheOther) {
    openPyramid();
    lessons::BufferShown shown;
    shown.compared = lessons::BufferShown::Compared{.with = "scene two_pyramids", .mode = "b"};
    BufferView& view = window.views().first();
    ASSERT_TRUE(view.lookAt(shown).empty());
    EXPECT_NE(lateWords(view), "");
    EXPECT_TRUE(QTest::qWaitFor([&] { return lateWords(view).isEmpty(); }, 20000));
    EXPECT_NE(&view.canvas()->seen(), &view.canvas()->content()) << "B is seen";
}

}  // namespace
}  // namespace app
