#include "lessons/site.h"

#include <gtest/gtest.h>

#include <map>
#include <stop_token>

namespace lessons {
namespace {

// Stopped at once, every page is begun and none made: the order alone.
std::vector<std::string> kindsInOrder() {
    std::vector<std::string> kinds;
    std::stop_source source;
    source.request_stop();
    const auto site = makeSite({}, {}, source.get_token(), [&](std::size_t, std::size_t, const std::string& what) {
        kinds.push_back(what.substr(0, what.find(' ')));
    });
    EXPECT_FALSE(site);
    return kinds;
}

// The printer says how much is left from the time so far. That is right only where the pages so far are like those that
// come: a talk takes much longer than a page of the manual. Page i of n stands at (i + 1/2) / n, so at any place p a kind
// has n p pages, give or take 1/2; all four kinds together N p, give or take 2; and a kind's share of those, where it is
// less than half of all, is off by 1/2 + 1 at most.
TEST(Site, EveryPartOfTheWorkHasItsShareOfEveryKind) {
    const std::vector<std::string> kinds = kindsInOrder();
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

}  // namespace
}  // namespace lessons
