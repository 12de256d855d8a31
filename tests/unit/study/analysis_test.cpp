#include "pipeline/study/analysis.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "pipeline/study/analysis_text.h"
#include "pipeline/study/errors.h"
#include "tests/support/studies.h"

namespace pipeline {
namespace {

using test::sphereStudy;
using test::studyPoint;
using Indices = std::vector<std::size_t>;

// Points of one axis of choices, so that each is a method.
StudyAnalysis analysisOf(std::vector<StudyPoint> points) {
    StudyReport report;
    report.axes = {{"shading", "Shading", {}}};
    for (const StudyPoint& point : points) report.axes[0].values.push_back(point.values[0]);
    report.points = std::move(points);
    return analyse(report, {});
}

TEST(Analysis, ChoicesMakeMethodsAndTheLastNumbersAreRefined) {
    EXPECT_EQ(refinedAxis({{"shading", "", {"flat", "phong"}}, {"tessellation", "", {"1", "2"}}}), 1u);
    EXPECT_EQ(refinedAxis({{"tessellation", "", {"1", "2"}}, {"shading", "", {"flat", "phong"}}}), 0u);
    EXPECT_EQ(refinedAxis({{"shadow.size", "", {"64", "128"}}, {"shadow.filter", "", {"0", "1"}}}), 1u);
    EXPECT_EQ(refinedAxis({{"shading", "", {"flat", "phong"}}, {"tessellation", "", {"8"}}}), std::nullopt);
    EXPECT_EQ(refinedAxis({}), std::nullopt);
}

TEST(Analysis, ACurveIsAMethodFromCoarseToFine) {
    StudyReport report = sphereStudy();
    report.axes[1].values = {"128", "4", "64", "16"};  // not in order
    for (StudyPoint& point : report.points) point.values[1] = report.axes[1].values[point.number % 4];
    const StudyAnalysis analysis = analyse(report, report.choice);
    ASSERT_EQ(analysis.curves.size(), 3u);
    EXPECT_EQ(analysis.curves[0].name, "flat");
    EXPECT_EQ(analysis.curves[0].points, (Indices{1, 3, 2, 0}));
    EXPECT_EQ(analysis.curves[1].name, "gouraud");
    EXPECT_EQ(analysis.curves[1].points, (Indices{5, 6, 4}));  // the fourth failed
    EXPECT_EQ(analysis.points[5].label, "gouraud, tessellation 4");
    EXPECT_EQ(analysis.points[5].step, "4");
    EXPECT_EQ(analysis.points[7].curve, 1u);
}

TEST(Analysis, WithoutNumbersEachMethodIsAPoint) {
    const StudyAnalysis analysis = analysisOf({studyPoint(0, {"flat"}, 1, 0.1), studyPoint(1, {"phong"}, 2, 0.01)});
    ASSERT_EQ(analysis.curves.size(), 2u);
    EXPECT_EQ(analysis.curves[1].points, Indices{1});
    EXPECT_TRUE(analysis.curves[1].order.steps.empty());
}

// A value alone does not say what it is where it is a number, a switch or another axis's too.
TEST(Analysis, NamesSayWhatAValueIs) {
    StudyReport report;
    report.axes = {{"shading", "Shading", {"flat", "phong"}},          {"normal_weight", "Vertex normals", {"mean"}},
                   {"two_sided", "Two-sided lighting", {"off", "on"}}, {"model", "Model", {"phong", "blinn-phong"}},
                   {"shadow.size", "Shadow buffer", {"64", "128"}},    {"light.0.x", "L x", {"1", "2"}}};
    report.points = {studyPoint(0, {"phong", "mean", "on", "blinn-phong", "64", "2"}, 1, 1)};
    const StudyAnalysis analysis = analyse(report, {});
    EXPECT_EQ(analysis.points[0].label, "shading phong, two-sided lighting on, blinn-phong, shadow buffer 64, L x 2");
    EXPECT_EQ(analysis.curves[0].name, "shading phong, two-sided lighting on, blinn-phong, shadow buffer 64");
    EXPECT_EQ(analysis.points[0].step, "2");
}

// The table of the measured sphere, read by hand: the front goes down from left to right.
TEST(Analysis, FindsTheFrontOfTheSphere) {
    const StudyReport report = sphereStudy();
    const StudyAnalysis analysis = analyse(report, report.choice);
    EXPECT_EQ(analysis.byTime, (Indices{0, 4, 1, 5, 8, 9, 6, 2, 10, 11, 3}));
    EXPECT_EQ(analysis.front, (Indices{0, 4, 1, 5, 9, 6, 10, 11}));
    EXPECT_EQ(standing(analysis, 8), "gouraud, tessellation 16");  // 0.86 ms, 2.1e-3 against 2.70 ms, 4.4e-3
    EXPECT_EQ(standing(analysis, 2), "gouraud, tessellation 64");  // the smallest error among four that beat it
    EXPECT_EQ(standing(analysis, 3), "phong, tessellation 128");
    EXPECT_EQ(standing(analysis, 0), "on the front");
    EXPECT_EQ(standing(analysis, 7), "stopped after 60 s");
    EXPECT_FALSE(analysis.points[7].placed());
}

TEST(Analysis, OfEqualErrorsTheTimesMustBeToldApart) {
    // 1.0 and 1.2 ms, both ±0.5 ms: the intervals overlap.
    const StudyAnalysis noisy = analysisOf({studyPoint(0, {"a"}, 1, 0.1, 0.5), studyPoint(1, {"b"}, 1.2, 0.1, 0.5)});
    EXPECT_EQ(noisy.front, (Indices{0, 1}));
    // The same medians with ±1 %.
    const StudyAnalysis calm = analysisOf({studyPoint(0, {"a"}, 1, 0.1), studyPoint(1, {"b"}, 1.2, 0.1)});
    EXPECT_EQ(calm.front, Indices{0});
    EXPECT_EQ(calm.points[1].dominatedBy, 0u);
    // What is slower and worse is nobody's choice, told apart or not; what is slower and better may be.
    const StudyAnalysis worse = analysisOf({studyPoint(0, {"a"}, 1, 0.1, 0.5), studyPoint(1, {"b"}, 1.2, 0.2, 0.5)});
    EXPECT_EQ(worse.front, Indices{0});
    const StudyAnalysis better = analysisOf({studyPoint(0, {"a"}, 1, 0.2, 0.5), studyPoint(1, {"b"}, 1.2, 0.1, 0.5)});
    EXPECT_EQ(better.front, (Indices{0, 1}));
}

// As exact where both are compared, but 300 pixels show another object: the slower one, with 2 such pixels, stays on the
// front, and the answers say what their errors leave out.
TEST(Analysis, PixelsThatAnErrorLeavesOutCountBesideIt) {
    std::vector<StudyPoint> points{studyPoint(0, {"fixed16"}, 1, 0), studyPoint(1, {"float"}, 2, 0),
                                   studyPoint(2, {"linear"}, 3, 0)};
    const double leftOut[]{300, 2, 2};
    for (StudyPoint& point : points)
        point.errors.push_back({"object_id",
                                StageId::ZBuffer,
                                "pixels that differ",
                                "pixels",
                                {leftOut[point.number], std::nullopt, std::nullopt}});
    const StudyAnalysis analysis = analysisOf(points);
    EXPECT_EQ(analysis.points[0].leftOut, 300);
    EXPECT_EQ(analysis.front, (Indices{0, 1}));
    EXPECT_EQ(analysis.points[2].dominatedBy, 1u);
    EXPECT_EQ(
        cheapestSentence(analysis, 1e-3),
        "RMSE of intensity up to 0.001 takes at least 1.00 ms: fixed16. 300 pixels do not show what the reference "
        "shows, and are not in this error.");
    EXPECT_EQ(bestWithin(analysis, 5), 1u);  // of equal errors the one that leaves out less
    // As fast as each other: then the pixels decide.
    points[1].frame = points[0].frame;
    EXPECT_EQ(analysisOf(points).front, Indices{1});
    // An error of the whole picture leaves out none.
    EXPECT_FALSE(leftOutOf({"color", "RMSE", ErrorKind::Model}));
    EXPECT_FALSE(leftOutOf({"depth", "RMSE", ErrorKind::Storage}));
    EXPECT_EQ(leftOutOf({"shadow.1", "leak", ErrorKind::Model}),
              (ErrorChoice{"object_id", "pixels that differ", ErrorKind::Model}));
    EXPECT_EQ(leftOutOf({"z_view", "RMSE", ErrorKind::Arithmetic}),
              (ErrorChoice{"polygon_id", "pixels that differ", ErrorKind::Arithmetic}));
}

TEST(Analysis, WhereNoPixelIsComparedThatIsWhy) {
    std::vector<StudyPoint> points{studyPoint(0, {"a"}, 1, 0.1)};
    points[0].errors = {{"object_id", StageId::ZBuffer, "pixels that differ", "pixels", {84, {}, {}}}};
    EXPECT_EQ(analysisOf(points).points[0].missing, "no pixel shows what the reference shows");
}

TEST(Analysis, BelowTwoPercentOfTimeOnlyTheErrorCounts) {
    // Samples without any spread: intervals are points and never overlap.
    const StudyAnalysis near = analysisOf({studyPoint(0, {"a"}, 1.00, 0.2, 0), studyPoint(1, {"b"}, 1.019, 0.1, 0)});
    EXPECT_EQ(near.front, Indices{1});
    const StudyAnalysis same = analysisOf({studyPoint(0, {"a"}, 1.00, 0.1, 0), studyPoint(1, {"b"}, 1.019, 0.1, 0)});
    EXPECT_EQ(same.front, (Indices{0, 1}));
    const StudyAnalysis apart = analysisOf({studyPoint(0, {"a"}, 1.00, 0.2, 0), studyPoint(1, {"b"}, 1.021, 0.1, 0)});
    EXPECT_EQ(apart.front, (Indices{0, 1}));
}

// 1.015 is within 2 % of 1 and of 1.03, which are not of each other: groups begin at 1 and at 1.03, so that b beats a, and
// c, of the next group, beats nobody.
TEST(Analysis, WhatIsOnNoFrontIsBeatenByAPointThatIs) {
    const StudyAnalysis chain = analysisOf(
        {studyPoint(0, {"a"}, 1.00, 0.3, 0), studyPoint(1, {"b"}, 1.015, 0.2, 0), studyPoint(2, {"c"}, 1.03, 0.1, 0)});
    EXPECT_EQ(chain.front, (Indices{1, 2}));
    EXPECT_EQ(chain.points[0].dominatedBy, 1u);

    std::mt19937 random(1);
    const auto below = [&](unsigned end) { return double(random() % end); };
    for (int study = 0; study < 200; ++study) {
        std::vector<StudyPoint> points;
        for (std::size_t i = 0; i < 12; ++i) {
            const double ms = 1 + 0.004 * below(40), error = 0.1 * (1 + below(6)), spread = 0.001 * below(20);
            points.push_back(studyPoint(i, {"v"}, ms, error, spread));
        }
        const StudyAnalysis analysis = analysisOf(points);
        for (const PointAnalysis& point : analysis.points)
            ASSERT_TRUE(!point.dominatedBy || analysis.points[*point.dominatedBy].onFront()) << study;
    }
}

TEST(Analysis, AnErrorOfZeroBeatsEveryOther) {
    const StudyAnalysis analysis =
        analysisOf({studyPoint(0, {"a"}, 1, 0), studyPoint(1, {"b"}, 2, 0), studyPoint(2, {"c"}, 3, 1e-300)});
    EXPECT_EQ(analysis.front, Indices{0});
    EXPECT_EQ(analysis.points[2].dominatedBy, 0u);
}

TEST(Analysis, WhatHasNoErrorOrTimeHasNoPlace) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    std::vector<StudyPoint> points{studyPoint(0, {"a"}, 1, nan), studyPoint(1, {"b"}, 1, 0.1),
                                   studyPoint(2, {"c"}, 1, 0.1), studyPoint(3, {"d"}, 1, -1)};
    points[1].errors.clear();
    points[2].frame = {};
    const StudyAnalysis analysis = analysisOf(points);
    EXPECT_TRUE(analysis.byTime.empty());
    EXPECT_EQ(analysis.points[0].missing, "its error is not a finite number");
    EXPECT_EQ(analysis.points[1].missing, "it has no such error");
    EXPECT_EQ(analysis.points[2].missing, "no time was measured");
    EXPECT_EQ(analysis.points[3].missing, "its error is not a finite number");
    EXPECT_FALSE(middleOfFront(analysis));
    EXPECT_EQ(cheapestSentence(analysis, 1), "No point has both a time and this error.");
}

TEST(Analysis, AMeasureOfWhichMoreIsBetterIsNoError) {
    StudyReport report = sphereStudy();
    for (StudyPoint& point : report.points)
        point.errors.push_back({"color", StageId::Shading, "PSNR", "dB", {40, std::nullopt, std::nullopt}});
    const StudyAnalysis analysis = analyse(report, {"color", "PSNR", ErrorKind::Model});
    EXPECT_TRUE(analysis.byTime.empty());
    EXPECT_EQ(analysis.points[0].missing, "of this measure more is better: it is no error");
}

// Six samples are the fewest whose order bounds the median; of fewer all are taken.
// Three processes of six frames, which agree among themselves: their medians are 1.5, 2.5 and 9.5. Of all 18 frames, by
// order statistics, the interval goes from the 5th to the 14th, 2 to 9.
TEST(Analysis, AnIntervalHoldsTheMedianOfEachProcess) {
    StudyPoint point = studyPoint(0, {"a"}, 1, 0.1);
    point.frame.processes = {{1, 1, 1, 2, 2, 2}, {2, 2, 2, 3, 3, 3}, {9, 9, 9, 10, 10, 10}};
    const std::pair<double, double> interval = analysisOf({point}).points[0].interval;
    EXPECT_EQ(interval.first, 1.5);
    EXPECT_EQ(interval.second, 9.5);
    point.frame.processes = {{1, 1, 1, 2, 2, 2}};
    EXPECT_EQ(analysisOf({point}).points[0].interval, (std::pair{1.0, 2.0}));
}

TEST(Analysis, FewSamplesMakeAnIntervalOfThemAll) {
    StudyPoint point = studyPoint(0, {"a"}, 1, 0.1);
    point.frame.processes = {{3, 1}, {2}};
    const StudyAnalysis analysis = analysisOf({point});
    EXPECT_EQ(analysis.points[0].time, 2);
    EXPECT_EQ(analysis.points[0].interval, (std::pair{1.0, 3.0}));
}

// p = log2(e / e') / log2(h / h'), each worked out with a table of logarithms.
TEST(Analysis, ObservesTheOrderOfTheSphere) {
    const StudyReport report = sphereStudy();
    const StudyAnalysis analysis = analyse(report, report.choice);
    const ObservedOrder& flat = analysis.curves[0].order;
    ASSERT_EQ(flat.steps.size(), 3u);
    EXPECT_NEAR(*flat.steps[0], 0.966, 5e-4);                          // log2(42 / 11) / 2 = 1.9329 / 2
    EXPECT_NEAR(*flat.steps[1], 1.013, 5e-4);                          // log2(11 / 2.7) / 2 = 2.0265 / 2
    EXPECT_NEAR(*flat.steps[2], 1.054, 5e-4);                          // log2(2.7 / 1.3)
    EXPECT_NEAR(*analysis.curves[1].order.steps.back(), 1.857, 5e-4);  // log2(2.1 / 0.16) / 2 = 3.7142 / 2
    EXPECT_NEAR(*analysis.curves[2].order.steps.back(), 1.912, 5e-4);  // log2(35 / 9.3)
}

TEST(Analysis, FitsTheOrderThroughAllLevels) {
    // e = h^2 but for the last level, twice as large: logs of 2: (0,0) (-1,-2) (-2,-4) (-3,-5).
    // Means −1.5 and −2.75; sum xy 8.5, sum xx 5: slope 1.7. The last two levels alone: 1.
    const ObservedOrder order = observedOrder({1, 0.5, 0.25, 0.125}, {1, 0.25, 0.0625, 0.03125});
    EXPECT_NEAR(*order.fit, 1.7, 1e-12);
    EXPECT_NEAR(*order.steps.back(), 1, 1e-12);
    // The line leaves 0.2, -0.1, -0.4, 0.3: squares sum to 0.3. t of 97.5 % with two degrees of freedom is 4.303, and
    // 4.303 √(0.3 / 2 / 5) = 0.745.
    EXPECT_NEAR(*order.within, 0.7453, 1e-4);
    EXPECT_EQ(orderText(order), "1.70 ± 0.75");
    // Two levels have an order and no interval, so it is not printed.
    EXPECT_EQ(orderText(observedOrder({1, 0.5}, {1, 0.25})), "");
}

TEST(Analysis, HasNoOrderWhereAnErrorIsZeroOrAWidthIsNone) {
    const ObservedOrder order = observedOrder({1, 0.5, 0.25}, {1, 0.5, 0});
    EXPECT_NEAR(*order.steps[0], 1, 1e-12);
    EXPECT_FALSE(order.steps[1]);
    EXPECT_NEAR(*order.fit, 1, 1e-12);
    EXPECT_FALSE(observedOrder({std::nullopt, 0.5}, {1, 0.5}).steps[0]);
    EXPECT_FALSE(observedOrder({0.5}, {1}).fit);
    EXPECT_FALSE(observedOrder({0.5, 0.5}, {1, 2}).fit);
    EXPECT_TRUE(observedOrder({}, {}).steps.empty());
}

TEST(Analysis, AWidthIsOneOverTheValueAndBitsHalveIt) {
    EXPECT_EQ(stepWidth({"tessellation", "", {}}, "8"), 0.125);
    EXPECT_EQ(stepWidth({"subpixel_bits", "", {}}, "4"), 0.0625);
    EXPECT_EQ(stepWidth({"object.#.tessellation", "", {}}, "8"), 0.125);
    EXPECT_EQ(stepWidth({"light.0.samples", "", {}}, "4"), 0.25);
    EXPECT_EQ(stepWidth({"shadow.size", "", {}}, "64"), 1.0 / 64);
    EXPECT_EQ(stepWidth({"shadow.filter", "", {}}, "0"), std::nullopt);
    EXPECT_EQ(stepWidth({"shading", "", {}}, "flat"), std::nullopt);
}

// An exponent, a distance or a light's width is a value, and none of them is finer than another.
TEST(Analysis, ASettingThatIsNoResolutionHasNoOrder) {
    for (const char* key : {"material.#.n", "camera.near", "light.0.width", "shadow.bias_value", "exponent_factor"})
        EXPECT_EQ(stepWidth({key, "", {}}, "8"), std::nullopt) << key;
    StudyReport report = sphereStudy();
    report.axes[1].key = "material.#.n";
    const StudyAnalysis analysis = analyse(report, report.choice);
    EXPECT_EQ(analysis.refined, 1u);
    for (const MethodCurve& curve : analysis.curves) EXPECT_FALSE(curve.order.fit) << curve.name;
}

TEST(Analysis, AMissingErrorIsGivenTheStudysReason) {
    StudyReport report = sphereStudy();
    report.whyNone[index(ErrorKind::Arithmetic)] = "not measurable";
    const StudyAnalysis analysis = analyse(report, {"intensity", "RMSE", ErrorKind::Arithmetic});
    EXPECT_EQ(analysis.points[1].missing, "not measurable");
}

TEST(Analysis, AnswersInWords) {
    const StudyReport report = sphereStudy();
    const StudyAnalysis analysis = analyse(report, report.choice);
    // Fifth of the eight points of the front: 2.94 ms, 3.4e-4.
    const auto limits = middleOfFront(analysis);
    ASSERT_TRUE(limits);
    EXPECT_EQ(limits->error, 5e-4);
    EXPECT_EQ(limits->milliseconds, 5);
    EXPECT_EQ(cheapestSentence(analysis, 1e-3),
              "RMSE of intensity up to 0.001 takes at least 2.94 ms: phong, tessellation 16.");
    EXPECT_EQ(bestSentence(analysis, 1), "Within 1 ms RMSE of intensity is at best 2.1e-3: gouraud, tessellation 16.");
    EXPECT_EQ(cheapestSentence(analysis, 1e-9),
              "No setting reaches RMSE of intensity up to 1e-9; the best reaches 9.3e-6: phong, tessellation 128.");
    EXPECT_EQ(bestSentence(analysis, 0.5),
              "No setting is done within 0.5 ms; the fastest takes 0.590 ms: flat, tessellation 4.");
}

TEST(Analysis, SentencesNameTheUnit) {
    const StudyReport report = sphereStudy();
    const StudyAnalysis analysis = analyse(report, {"normal", "largest angle", ErrorKind::Model});
    EXPECT_EQ(measureWithUnit(analysis), "largest angle of normal (degrees)");
    EXPECT_EQ(bestSentence(analysis, 1),
              "Within 1 ms largest angle of normal is at best 10 degrees: flat, tessellation 4.");
}

TEST(Analysis, NamesThePicturesSizeWhereThereIsOne) {
    StudyReport report = sphereStudy();
    report.width = 640, report.height = 480;
    EXPECT_EQ(pictureSizeText(report), "640 × 480");
    report.axes.push_back({"width", "Width", {"8", "16"}});
    EXPECT_EQ(pictureSizeText(report), "several sizes");
}

TEST(Analysis, WritesNumbersShort) {
    EXPECT_EQ(errorText(0), "0");
    EXPECT_EQ(errorText(84), "84");
    EXPECT_EQ(errorText(4.2e-2), "4.2e-2");
    EXPECT_EQ(errorText(0.0996), "0.10");
    EXPECT_EQ(errorText(1.25e-300), "1.2e-300");
    EXPECT_EQ(errorText(12345678), "1.2e7");
    EXPECT_EQ(errorText(1.34), "1.3");
    EXPECT_EQ(timeText(0.59), "0.590");
    EXPECT_EQ(timeText(0.99971), "1.00");
    EXPECT_EQ(timeText(10.62), "10.6");
    EXPECT_EQ(timeText(1340.4), "1340");
    EXPECT_EQ(timeText(0.00321), "0.00321");
    EXPECT_EQ(threadsText(0), "all threads");
    EXPECT_EQ(threadsText(1), "1 thread");
    EXPECT_EQ(threadsText(4), "4 threads");
    EXPECT_EQ(orderText(1.9849), "1.98");
    EXPECT_EQ(orderText(-0.5), "\u22120.50");
    EXPECT_EQ(orderText(-0.001), "0.00");
}

}  // namespace
}  // namespace pipeline
