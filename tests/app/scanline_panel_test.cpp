#include "app/panels/scanline_panel.h"

#include <gtest/gtest.h>

#include <QTest>

#include "app/core/theme.h"
#include "app/panels/scanline_plot_view.h"
#include "tests/support/scenes.h"

namespace {

using app::Document;
using app::ScanlinePanel;

struct ScanlinePanelTest : testing::Test {
    Document document;
    ScanlinePanel panel{document};

    ScanlinePanelTest() {
        panel.resize(900, 320);
        panel.show();
        document.setScene(test::pyramid());
        EXPECT_TRUE(waitForRow(240)) << "the middle row of a new scene";
    }
    bool waitForRow(int row) {
        return QTest::qWaitFor([&] { return panel.section() && panel.section()->row == row; }, 10000);
    }
    // Where a column stands in the plot.
    QPoint placeOf(int x) {
        const pipeline::PlotSize size{double(panel.plot()->width()), double(panel.plot()->height()),
                                      double(app::Theme::current().px(13.5))};
        return {int(axesOf(*panel.section(), size).depth.place(x + 0.5)), panel.plot()->height() / 3};
    }
};

TEST_F(ScanlinePanelTest, FollowsThePickedPixelsRow) {
    document.pick(glm::ivec2(268, 281));
    ASSERT_TRUE(waitForRow(281));
    EXPECT_EQ(panel.section()->winnerAt(268), 2);
    EXPECT_FALSE(panel.plot()->drawing().lines.empty());
    EXPECT_TRUE(panel.csv().startsWith("x,seen,z_view.1,z_view.2,flat.r"));
    EXPECT_TRUE(panel.svg().contains("<svg"));
}

TEST_F(ScanlinePanelTest, ItsCursorIsThatOfEveryView) {
    document.pick(glm::ivec2(268, 281));
    ASSERT_TRUE(waitForRow(281));
    QTest::mouseMove(panel.plot(), placeOf(260));
    ASSERT_TRUE(QTest::qWaitFor([&] { return document.hovered().has_value(); }, 5000));
    EXPECT_EQ(document.hovered(), glm::ivec2(260, 281));
    QTest::mouseClick(panel.plot(), Qt::LeftButton, Qt::NoModifier, placeOf(262));
    EXPECT_EQ(document.pixel(), glm::ivec2(262, 281));
    QTest::keyClick(panel.plot(), Qt::Key_Down);
    EXPECT_EQ(document.pixel(), glm::ivec2(262, 282)) << "the mark goes along";
    ASSERT_TRUE(waitForRow(282));
}

TEST_F(ScanlinePanelTest, AnEmptyRowSaysSo) {
    panel.setRow(3);
    ASSERT_TRUE(waitForRow(3));
    EXPECT_TRUE(panel.section()->empty());
    EXPECT_TRUE(panel.plot()->drawing().lines.empty());
    EXPECT_TRUE(panel.svg().isEmpty());
}

}  // namespace
