// A talk as a page has the pictures of the window.
#include <QFile>
#include <QImage>
#include <QTest>
#include <algorithm>

#include "app/buffer_view/buffer_view.h"
#include "app/commands/actions.h"
#include "app/export/slide_picture.h"
#include "app/talk/cue_panel.h"
#include "app/talk/cue_picture.h"
#include "app/views/view_area.h"
#include "lessons/state/state_scene.h"
#include "pipeline/formats/built_in_scenes.h"
#include "tests/app/window/window_fixture.h"

namespace app {
namespace {

using lessons::ViewLeaf;

class WindowTalkPage : public WindowTest {
protected:
    void settle() {
        EXPECT_TRUE(waitForFrame());
        EXPECT_TRUE(
            QTest::qWaitFor([this] { return !document().frames().busy() && document().stepper().isSettled(); }, 30000));
    }
};

QImage imageOf(const pipeline::Result<lessons::TalkPicture>& picture) {
    EXPECT_TRUE(picture) << format(picture.errors());
    QImage image;
    if (picture)
        image.loadFromData(reinterpret_cast<const uchar*>(picture->png.data()), int(picture->png.size()), "PNG");
    return image.convertToFormat(QImage::Format_ARGB32);
}

// The window draws the same view into as many pixels for a slide: two ways to the same picture, the one by the document
// and its widgets, the other by the cue's text alone.
TEST_F(WindowTalkPage, EveryCuesPictureIsTheWindows) {
    const QString file = folder.filePath("tour.cues");
    ASSERT_TRUE(
        QFile::copy(QString::fromStdString((pipeline::resourceFolder() / "manual" / "tour.cues").string()), file));
    ASSERT_TRUE(window.openFile(file));
    const CueModel& model = window.cues().model();
    ASSERT_GT(model.size(), 5);
    int buffers = 0, spaces = 0;
    for (int i = 0; i < model.size(); ++i) {
        document().history().stack()->setClean();  // given to the talk: not what was changed in the scene is asked for
        if (i > 0) window.actions()[ActionId::NextCue]->trigger();
        ASSERT_TRUE(QTest::qWaitFor([&] { return model.current() == i; }, 30000)) << i << " " << model.current();
        settle();
        const lessons::WindowState& state = model.cue(i).state;
        const auto scene = lessons::sceneOf(state, model.folder());
        ASSERT_TRUE(scene) << format(scene.errors());
        const auto shared = std::make_shared<const pipeline::Scene>(*scene);
        const auto tree = lessons::arrangementOf(state.arrangement);
        ASSERT_TRUE(tree);
        const std::vector<ViewLeaf> leaves = lessons::leavesOf(*tree);
        const auto shown = std::size_t(std::ranges::count(leaves, ViewLeaf::Kind::Buffer, &ViewLeaf::kind));
        ASSERT_TRUE(
            QTest::qWaitFor([&] { return shown == 0 || window.views().shownBuffers().size() == shown; }, 10000));
        for (const ViewLeaf view : leaves) {
            const bool isBuffer = view.kind == ViewLeaf::Kind::Buffer;
            const auto& views = state.views;
            if (isBuffer && views[std::size_t(view.number)].compared) continue;  // a slide has both of its sides
            const SlideRequest request{.what = isBuffer ? SlideRequest::What::Buffer : SlideRequest::What::Space,
                                       .size = {800, 600},
                                       .transparent = false,
                                       .view = std::size_t(view.number)};
            const auto slide = slidePicture(document(), window.views(), request);
            ASSERT_TRUE(slide) << format(slide.errors());
            const QImage page = imageOf(drawCueView(state, shared, view, {{800, 600}}, {}));
            EXPECT_EQ(page, slide->convertToFormat(QImage::Format_ARGB32))
                << model.cue(i).name << ", " << (isBuffer ? "buffer " : "3D view ") << view.number;
            ++(isBuffer ? buffers : spaces);
        }
    }
    EXPECT_GT(buffers, 5);
    EXPECT_GT(spaces, 1);
}

}  // namespace
}  // namespace app
