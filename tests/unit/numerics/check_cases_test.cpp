// Every case of the catalogue holds; the catalogue itself is in order.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "pipeline/check/case.h"
#include "pipeline/scene/settings_table.h"
#include "tests/support/looks.h"
#include "tests/support/scenes.h"

namespace pipeline::check {
namespace {

class CheckCase : public testing::TestWithParam<const Case*> {};

std::vector<const Case*> everyCase() {
    std::vector<const Case*> all;
    for (const Case& c : caseTable()) all.push_back(&c);
    return all;
}
INSTANTIATE_TEST_SUITE_P(Catalogue, CheckCase, testing::ValuesIn(everyCase()),
                         [](const auto& one) { return std::string(one.param->id); });

TEST_P(CheckCase, Holds) {
    const CaseResult result = runCase(*GetParam());
    EXPECT_TRUE(result.holds) << result.reason;
    // A naive form that is as good as ours makes no case.
    EXPECT_FALSE(result.finding.naive <= result.what->bound) << "naive: " << result.naiveText();
}

// Else their reference, that a planar surface covers each pixel once, would not hold.
TEST(CheckCases, RandomTriangulationsHaveNoTriangleTurnedOver) {
    for (const std::string_view id : {"C12", "C13"}) {
        const Case* const which = findCase(id);
        ASSERT_TRUE(which) << id;
        const Scene scene = which->scene();
        const Mesh& mesh = *scene.objects[0].mesh;
        ASSERT_GT(mesh.triangles.size(), 1000u);
        for (const Triangle& t : mesh.triangles) {
            const Vec3d a = mesh.positions[t.vertices[0]], ab = mesh.positions[t.vertices[1]] - a,
                        ac = mesh.positions[t.vertices[2]] - a;
            ASSERT_GT(ab.x * ac.y - ab.y * ac.x, 0) << id;
        }
    }
}

// The stop comes while H10 makes its sphere, before it draws: it is not the next case that is left out.
TEST(CheckCases, AStopEndsTheCaseThatRuns) {
    const Filter one{.ids = {"H10"}};
    {
        const test::Looks whole;
        EXPECT_EQ(runChecks(one, 1, test::Looks::stop()).size(), 1u);
        ASSERT_GT(test::Looks::count(), 0u);
    }
    const test::Looks stopping(1);
    EXPECT_TRUE(runChecks(one, 1, test::Looks::stop()).empty());
}

TEST_P(CheckCase, OpensAsASceneThatIsAccepted) {
    if (!GetParam()->scene) return;
    const Scene scene = GetParam()->scene();
    EXPECT_EQ(format(checkScene(scene)), "");
    const Knob& knob = GetParam()->knob;
    for (const double at : {knob.low, std::sqrt(knob.low * knob.high), knob.high})
        if (knob.scene) {
            EXPECT_EQ(format(checkScene(knob.scene(at))), "") << at;
        }
    if (knob.setting.empty()) return;
    EXPECT_TRUE(bool(findSetting(scene, knob.setting))) << knob.setting;
}

TEST_P(CheckCase, TheNaiveFormIsSeenWhereASettingOffersIt) {
    const Case& which = *GetParam();
    if (which.naiveWith.empty()) return;
    ASSERT_TRUE(which.scene);
    const Scene scene = which.scene();
    const auto naive = withNaiveForm(which, scene);
    ASSERT_TRUE(naive) << which.naiveWith;
    EXPECT_EQ(format(checkScene(*naive)), "");
    const FramePtr a = test::frameOf(scene, setOf({BufferId::Color})), b = test::frameOf(*naive);
    EXPECT_EQ(test::buffersWithoutNumbers(*b), "");
    const AnyBuffer ours = *a->buffer({BufferId::Color}), theirs = *b->buffer({BufferId::Color});
    std::size_t differ = 0;
    for (std::size_t i = 0; i < ours.count(); ++i) differ += ours.flat(i) != theirs.flat(i);
    EXPECT_GT(differ, 0u) << "both pictures are the same";
}

TEST_P(CheckCase, KnobTellsTheFormsApartAtItsStiffEnd) {
    const Knob& knob = GetParam()->knob;
    if (knob.label.empty()) return;
    const double atLow = knob.naive(knob.low), atHigh = knob.naive(knob.high);
    const bool stiffAtHigh = !(atHigh <= atLow);
    const double stiff = stiffAtHigh ? knob.high : knob.low;
    EXPECT_FALSE(knob.naive(stiff) <= 10 * knob.ours(stiff));
    for (const double at : {knob.low, std::sqrt(knob.low * knob.high), knob.high})
        EXPECT_TRUE(std::isfinite(knob.ours(at)));
}

TEST(CheckTable, SaysEverythingAboutEachCase) {
    std::set<std::string_view> ids;
    for (const Case& c : caseTable()) {
        EXPECT_TRUE(ids.insert(c.id).second) << c.id << " stands there twice";
        for (const std::string_view words : {c.title, c.input, c.naive, c.stable, c.measure, c.reference})
            EXPECT_FALSE(words.empty()) << c.id;
    }
    EXPECT_EQ(findCase("s10"), findCase("S10"));
    EXPECT_NE(findCase("S10"), nullptr);
    EXPECT_EQ(findCase("S999"), nullptr);
}

TEST(CheckRun, GivesTheCasesThatTheFilterAdmits) {
    EXPECT_EQ(runChecks({{"g1", "C9"}, {}}, 2).size(), 2u);
    std::stop_source stopped;
    stopped.request_stop();
    EXPECT_TRUE(runChecks({}, 2, stopped.get_token()).empty());
}

TEST(CheckNumbers, AreShort) {
    EXPECT_EQ(measured(1.13e-7, ""), "1.1e-7");
    EXPECT_EQ(measured(1e9, "eps"), "1e9 eps");
    EXPECT_EQ(measured(2.5e12, ""), "2.5e12");
    EXPECT_EQ(measured(0, "pixels"), "0 pixels");
    EXPECT_EQ(measured(90, "°"), "90°");
    EXPECT_EQ(measured(std::nan(""), "°"), "NaN");
}

}  // namespace
}  // namespace pipeline::check
