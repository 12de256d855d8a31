// What an audience sees beside each other, and what a lecturer finds in the notes.
#include <QListView>
#include <QStyledItemDelegate>
#include <QTest>
#include <algorithm>

#include "app/buffer_view/buffer_view.h"
#include "app/canvas/buffer_canvas.h"
#include "app/canvas/range_bar.h"
#include "app/talk/clean_view.h"
#include "app/talk/cue_model.h"
#include "app/talk/notes_window.h"
#include "app/talk/presentation.h"
#include "app/views/view_area.h"
#include "tests/app/window/window_fixture.h"

namespace app {
namespace {

using WindowAudience = WindowTest;

// One stands above a histogram, the other has none.
TEST_F(WindowAudience, PicturesBesideAHistogramAreAlignedWithThoseAboveIt) {
    openPyramid();
    press("Ctrl+F11");
    window.views().setArrangement("compare");
    CleanView& view = *window.presentation().cleanView();
    lessons::WindowState state = *window.shown().now();
    state.arrangement = "compare";
    state.views = {{"color"}, {"z_view"}};
    ASSERT_TRUE(view.lookAt(state).empty());
    ASSERT_TRUE(waitForFrame());
    const auto views = view.views().shownBuffers();
    ASSERT_EQ(views.size(), 2u);
    const auto feet = view.findChildren<RangeBar*>();
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return std::ranges::count_if(feet, [](const RangeBar* foot) { return foot->isVisible(); }) == 1; },
        10000));
    const auto bottomOf = [&](BufferView* one) {
        return one->canvas()->mapTo(&view, one->canvas()->rect().bottomLeft()).y();
    };
    EXPECT_TRUE(QTest::qWaitFor([&] { return bottomOf(views[0]) == bottomOf(views[1]); }, 5000));
    EXPECT_EQ(views[0]->canvas()->placing().zoom(), views[1]->canvas()->placing().zoom());
}

TEST_F(WindowAudience, TheNotesListCuesByTheCaptionThatAnAudienceReads) {
    openPyramid();
    CueModel& model = window.cues().model();
    model.clear();
    press("Ctrl+B");
    ASSERT_EQ(model.size(), 1);
    model.setCaption(0, "The nearest polygon wins.");
    NotesWindow notes(model, window);
    auto* list = notes.findChild<QListView*>();
    QStyleOptionViewItem option;
    option.initFrom(list);
    struct Delegate : QStyledItemDelegate {
        using QStyledItemDelegate::initStyleOption;
    };
    notes.resize(1280, 720);
    EXPECT_TRUE(model.index(0).data(CueModel::CaptionRole).toString().contains("The nearest polygon wins."));
    (static_cast<const QStyledItemDelegate*>(list->itemDelegate())->*(&Delegate::initStyleOption))(&option,
                                                                                                   model.index(0));
    EXPECT_EQ(option.text, "1  The nearest polygon wins.");
}

}  // namespace
}  // namespace app
