#include "app/canvas/legend_bar.h"

#include <gtest/gtest.h>

#include "app/look/theme.h"

namespace {

// Four names in a bar that has room for two beside each other.
TEST(LegendBar, TakesASecondRowWhereThereIsHeight) {
    app::LegendBar bar;
    std::vector<app::LegendEntry> entries;
    for (const char* text : {"lit, 46.07 %", "shadowed, 7.74 %", "acne, 46.15 %", "leak, 0.04 %"})
        entries.push_back({Qt::gray, Qt::NoBrush, text});
    bar.setEntries(entries);
    bar.resize(2000, 48);
    ASSERT_EQ(bar.places().size(), 4u);
    const int two = bar.places()[1].right() + 1;
    EXPECT_EQ(bar.places()[3].top(), bar.places()[0].top()) << "one row where that is enough";
    const int line = app::Theme::current().px(20);
    bar.resize(two, 2 * line);
    ASSERT_EQ(bar.places().size(), 4u);
    for (const QRect& place : bar.places()) EXPECT_TRUE(bar.rect().contains(place));
    EXPECT_EQ(bar.places()[2].topLeft(), QPoint(0, line));
    bar.resize(two, line);
    EXPECT_EQ(bar.places().size(), 2u);
}

}  // namespace
