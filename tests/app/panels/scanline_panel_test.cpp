#include "app/tables/scanline_panel.h"

#include <gtest/gtest.h>

#include <QTest>

#include "app/look/theme.h"
#include "app/tables/scanline_plot_view.h"
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
        // Row 240, the picture's middle, is empty: the pyramid's apex, its highest point, lies below (README's picture).
        EXPECT_TRUE(QTest::qWaitFor([&] { return panel.section() && !panel.section()->empty(); }, 10000));
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
    document.pointing().pick(glm::ivec2(268, 281));
    ASSERT_TRUE(waitForRow(281));
    EXPECT_EQ(panel.section()->winnerAt(268), 2);
    EXPECT_FALSE(panel.plot()->drawing().lines.empty());
    EXPECT_TRUE(panel.csv().startsWith("x,seen,z_view.1,z_view.2,flat.r"));
    EXPECT_TRUE(panel.svg().contains("<svg"));
}

TEST_F(ScanlinePanelTest, ItsCursorIsThatOfEveryView) {
    document.pointing().pick(glm::ivec2(268, 281));
    ASSERT_TRUE(waitForRow(281));
    QTest::mouseMove(panel.plot(), placeOf(260));
    ASSERT_TRUE(QTest::qWaitFor([&] { return document.pointing().hovered().has_value(); }, 5000));
    EXPECT_EQ(document.pointing().hovered(), glm::ivec2(260, 281));
    QTest::mouseClick(panel.plot(), Qt::LeftButton, Qt::NoModifier, placeOf(262));
    EXPECT_EQ(document.pointing().pixel(), glm::ivec2(262, 281));
    QTest::keyClick(panel.plot(), Qt::Key_Down);
    EXPECT_EQ(document.pointing().pixel(), glm::ivec2(262, 282)) << "the mark goes along";
    ASSERT_TRUE(waitForRow(282));
}

// The first and the last row with a polygon lie equally far from it, but for the one pixel that two do not share.
TEST_F(ScanlinePanelTest, BeginsInTheMiddleOfWhatIsDrawn) {
    ASSERT_EQ(panel.row(), panel.section()->row);
    const auto polygons = *document.frames().shown()->buffer({pipeline::BufferId::PolygonId});
    const auto isDrawn = [&](int row) {
        for (std::size_t x = 0; x < polygons.columns(); ++x)
            if (polygons.value(x, std::size_t(row)) >= 0) return true;
        return false;
    };
    int above = 0, below = 0;
    while (isDrawn(panel.row() - above - 1)) ++above;
    while (isDrawn(panel.row() + below + 1)) ++below;
    EXPECT_GT(above, 0);
    EXPECT_TRUE(below == above || below == above + 1) << above << ' ' << below;
    document.change(*findSetting(document.scene(), "material.0.n"), 3, Document::Change::Done);
    panel.setRow(3);
    ASSERT_TRUE(waitForRow(3)) << "a row that was chosen stays, though nothing is drawn there";
}

TEST_F(ScanlinePanelTest, AnEmptyRowSaysSo) {
    panel.setRow(3);
    ASSERT_TRUE(waitForRow(3));
    EXPECT_TRUE(panel.section()->empty());
    EXPECT_TRUE(panel.plot()->drawing().lines.empty());
    EXPECT_TRUE(panel.svg().isEmpty());
}

}  // namespace
