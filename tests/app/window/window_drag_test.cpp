// What a hand that drags a slider makes the window do: what has changed, and nothing else.
#include <QPaintEvent>
#include <QSignalSpy>
#include <QTest>
#include <map>

#include "app/canvas/buffer_canvas.h"
#include "app/frames/stage_status.h"
#include "app/stages/stage_card.h"
#include "app/stages/stage_strip.h"
#include "app/vtk/vtk_widget.h"
#include "app/widgets/value_slider.h"
#include "tests/app/quiet.h"
#include "tests/app/window/window_fixture.h"

namespace app {
namespace {

class Events : public QObject {
public:
    Events() { qApp->installEventFilter(this); }
    int count(const QObject* to, QEvent::Type type) const {
        const auto found = m_counts.find({to, type});
        return found == m_counts.end() ? 0 : found->second;
    }

protected:
    bool eventFilter(QObject* to, QEvent* event) override {
        ++m_counts[{to, event->type()}];
        return false;
    }

private:
    std::map<std::pair<const QObject*, QEvent::Type>, int> m_counts;
};

class WindowDrag : public WindowTest {
protected:
    // The camera's θ goes on by half a degree for every frame that comes.
    void drag(int frames, Document::Change last) {
        const auto theta = *findSetting(document().scene(), "camera.theta");
        const double begin = theta.get(document().scene());
        QSignalSpy ready(&document().frames(), &FrameFeed::frameReady);
        for (int i = 1; i <= frames; ++i) {
            const auto before = ready.count();
            document().change(theta, begin + 0.5 * i, i < frames ? Document::Change::Live : last);
            ASSERT_TRUE(QTest::qWaitFor([&] { return ready.count() > before; }, 10000));
        }
    }
};

TEST_F(WindowDrag, LaysNothingOutAnewAndPaintsNothingThatStaysAsItIs) {
    openPyramid();
    drag(2, Document::Change::Live);  // undo has a step, and its row of words
    ASSERT_TRUE(test::waitUntilQuiet());
    drag(1, Document::Change::Live);  // the status line's error of a picture at rest goes
    const Events events;
    drag(10, Document::Change::Live);
    QCoreApplication::sendPostedEvents();  // that error comes back at rest
    EXPECT_EQ(events.count(&window, QEvent::LayoutRequest), 0);
    EXPECT_EQ(events.count(find<ValueSlider>("material.0.kr"), QEvent::Paint), 0);
    EXPECT_GE(events.count(canvas(), QEvent::Paint), 1);
}

TEST_F(WindowDrag, TheStagesCardsFollowSeldomAndAreRightWhenItRests) {
    openPyramid();
    drag(2, Document::Change::Live);
    StageCard& card = find<StageStrip>("stageStrip")->card(pipeline::StageId::Shading);
    const Events events;
    QElapsedTimer time;
    time.start();
    drag(20, Document::Change::Live);
    // One in 150 ms, the one before it began, and the errors that come when it rests for a moment.
    EXPECT_LE(events.count(&card, QEvent::ToolTipChange), time.elapsed() / 150 + 2);
    drag(1, Document::Change::Done);
    const auto now = stageStatus(document().frames().whole().get(), document().frames().errors(), false);
    EXPECT_EQ(card.status().time, now[index(pipeline::StageId::Shading)].time);
}

}  // namespace
}  // namespace app
