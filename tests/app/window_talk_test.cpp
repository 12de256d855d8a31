// How a talk looks, and that the window behind it is what it was.
#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <algorithm>
#include <array>
#include <map>

#include "app/desktop/clean_view.h"
#include "app/desktop/panel_dock.h"
#include "app/desktop/presentation.h"
#include "app/desktop/view_area.h"
#include "app/panels/algorithm_view.h"
#include "app/panels/buffer_canvas.h"
#include "app/panels/buffer_compare.h"
#include "app/panels/buffer_view.h"
#include "app/panels/segmented.h"
#include "tests/app/window_fixture.h"

namespace app {
namespace {

class WindowTalk : public WindowTest {
protected:
    void SetUp() override { openPyramid(); }
    CleanView& present() {
        press("Ctrl+F11");
        CleanView& view = *window.presentation().cleanView();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&view));
        EXPECT_TRUE(waitForFrame());
        return view;
    }
};

// Letters as large as a talk's need more room than the window behind has.
TEST_F(WindowTalk, PanelsHaveTheirSizesAgainAfterwards) {
    const auto places = [this] {
        std::map<std::string, std::array<int, 4>> all;
        for (const PanelDock* dock : window.findChildren<PanelDock*>())
            if (const QRect r = dock->geometry(); !dock->visibleRegion().isEmpty())
                all[dock->objectName().toStdString()] = {r.x(), r.y(), r.width(), r.height()};
        return all;
    };
    const auto before = places();
    ASSERT_GT(before.size(), 3u);
    present();
    window.presentation().end();
    EXPECT_TRUE(QTest::qWaitFor([&] { return places() == before; }, 5000));
    EXPECT_EQ(places(), before);
}

// In place of the equation; in the window behind it is the panel that comes to the front.
TEST_F(WindowTalk, AShowsTheAlgorithmWithTheLineOfTheStep) {
    ASSERT_TRUE(QTest::qWaitFor([this] { return document().stepper().steps() != nullptr; }, 30000));
    CleanView& view = present();
    auto* algorithm = view.findChild<AlgorithmView*>();
    EXPECT_FALSE(algorithm->isVisible());
    EXPECT_TRUE(view.takeKey(Qt::Key_A));
    document().stepper().goTo(*pipeline::parsePlace("z-buffer/polygon=2/row=270/x=258/line=5"));
    EXPECT_TRUE(algorithm->isVisible());
    EXPECT_FALSE(algorithm->currentRect().isEmpty());
    EXPECT_TRUE(view.caption().contains("line 5")) << view.caption().toStdString();
    EXPECT_TRUE(window.state({})->algorithm);
    EXPECT_TRUE(view.takeKey(Qt::Key_A));
    EXPECT_FALSE(algorithm->isVisible());
}

// Both sides bear a name, which the buffer's own would cover; the words stand beside the choices.
TEST_F(WindowTalk, AComparisonHasOneSetOfNamesAndOneLine) {
    BufferView& shown = present().views().first();
    const auto hasTitle = [&] {
        return std::ranges::any_of(shown.canvas()->findChildren<QLabel*>(),
                                   [](QLabel* label) { return label->isVisible() && label->text() == "color"; });
    };
    EXPECT_TRUE(hasTitle());
    const auto shading = *findSetting(document().scene(), "shading");
    shown.findChild<BufferCompare*>()->compareWith(OtherSource{.kind = OtherSource::Kind::Setting, .setting = shading});
    EXPECT_TRUE(waitForFrame());
    EXPECT_FALSE(hasTitle());
    const auto* bar = shown.findChild<CompareBar*>();
    ASSERT_TRUE(bar->isVisible());
    EXPECT_LT(bar->height(), 2 * bar->findChild<Segmented*>()->height());
    EXPECT_TRUE(bar->findChild<QLabel*>()->isVisible());
    for (const auto* button : bar->findChildren<QPushButton*>())
        EXPECT_TRUE(!button->isVisible() || button->property("kind") == "segment") << button->text().toStdString();
}

}  // namespace
}  // namespace app
