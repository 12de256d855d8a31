#include "pipeline/inspect/fragment_report.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace pipeline {
namespace {

TEST(FragmentReport, DepthsThatDifferNeverReadAlike) {
    using V = FragmentVerdict;
    EXPECT_EQ(comparisonText({0, 1.00000001, 1.00000002, V::WonStays, "<"}).whole(), "1.00000001 < 1.00000002");
    EXPECT_EQ(comparisonText({0, 1, 1, V::NotNearer, "≥"}).whole(), "1.000000 ≥ 1.000000");
    EXPECT_EQ(comparisonText({0, 671.4539, 700, V::PaintedLast, {}}).whole(), "671.4539");
    const NumberText chosen = [](double value) { return std::optional(fmt::format("{:.1f}", value)); };
    EXPECT_EQ(comparisonText({0, 1.01, 1.02, V::WonStays, "<"}, chosen).whole(), "1.0 < 1.0") << "as asked for";
}

TEST(FragmentReport, FragmentsAreCountedByWhatTheDepthTestSaidOfThem) {
    using V = FragmentVerdict;
    EXPECT_EQ(fragmentCounts({}), "0 fragments, 0 passed");
    const std::vector<FragmentReport> tested{
        {0, 2, 3, V::Overwritten, "<"}, {1, 1, 2, V::WonStays, "<"}, {2, 4, 1, V::NotNearer, "≥"}};
    EXPECT_EQ(fragmentCounts(tested), "3 fragments, 2 passed");
    const std::vector<FragmentReport> begun{{0, 2, 3, V::WonStays, "<"}, {1, 1, 2, V::NotYet, {}}};
    EXPECT_EQ(fragmentCounts(begun), "1 fragment, 1 passed; 1 to come");
    const std::vector<FragmentReport> painted{{0, 2, 0, V::PaintedOver, {}}, {1, 3, 0, V::PaintedLast, {}}};
    EXPECT_EQ(fragmentCounts(painted), "2 fragments, 2 written");
}

}  // namespace
}  // namespace pipeline
