#include "lessons/pages/site.h"

#include <gtest/gtest.h>

#include <map>
#include <stop_token>

#include "lessons/library.h"
#include "lessons/pages/live_page.h"

namespace lessons {
namespace {

// A site has the core of live pages, which the preset web builds.
class SiteOrder : public testing::Test {
protected:
    void SetUp() override {
        if (const auto parts = liveParts(LiveKind::Whole); !parts) GTEST_SKIP() << pipeline::format(parts.errors());
    }
};

// Stopped at once, every page is begun and none made: the order alone, as "lesson pyramid".
std::vector<std::string> pagesInOrder() {
    std::vector<std::string> pages;
    std::stop_source source;
    source.request_stop();
    const auto site = makeSite({}, {}, source.get_token(),
                               [&](std::size_t, std::size_t, const std::string& what) { pages.push_back(what); });
    EXPECT_FALSE(site);
    return pages;
}

// The printer says how much is left from the time so far. That is right only where the pages so far are like those that
// come: a talk takes much longer than a page of the manual. Page i of n stands at (i + 1/2) / n, so at any place p a kind
// has n p pages, give or take 1/2; all four kinds together N p, give or take 2; and a kind's share of those, where it is
// less than half of all, is off by 1/2 + 1 at most.
TEST_F(SiteOrder, EveryPartOfTheWorkHasItsShareOfEveryKind) {
    std::vector<std::string> kinds;
    for (const std::string& page : pagesInOrder()) kinds.push_back(page.substr(0, page.find(' ')));
    std::map<std::string, double> all, soFar;
    for (const std::string& kind : kinds) ++all[kind];
    EXPECT_EQ(all.size(), 4u) << "talks, lessons, scenes, the manual";
    for (std::size_t k = 1; k <= kinds.size(); ++k) {
        ++soFar[kinds[k - 1]];
        for (const auto& [kind, count] : all) {
            const double share = double(k) * count / double(kinds.size());
            EXPECT_NEAR(soFar[kind], share, 1.5) << kind << " after " << k;
        }
    }
}

// The last lessons of the course take thirty times as long as the first. Where a half of them is made, a half of each
// half of the course is, give or take one.
TEST_F(SiteOrder, LessonsComeFromTheWholeCourseAtAnyTime) {
    const std::vector<std::string> pages = pagesInOrder();
    const Library library = allLessons();
    const std::size_t half = library.lessons.size() / 2;
    std::size_t made = 0, ofFirstHalf = 0;
    for (const std::string& page : pages)
        for (std::size_t i = 0; i < library.lessons.size() && made < half; ++i)
            if (page == "lesson " + library.lessons[i].name) {
                ++made;
                ofFirstHalf += i < half;
            }
    EXPECT_EQ(made, half);
    EXPECT_NEAR(double(ofFirstHalf), double(half) / 2, 1);
}

}  // namespace
}  // namespace lessons
