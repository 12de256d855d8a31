// Sections along a row.
#include "pipeline/inspect/scanline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "pipeline/inspect/pixel_report.h"
#include "pipeline/study/scanline_plot.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

FramePtr frameWithIntensity(const Scene& scene) { return test::frameOf(scene, setOf({BufferId::Intensity})); }

// A row in which several polygons lie behind one another; 0 where there is none.
int crowdedRow(const Frame& frame) {
    for (int row = 0; row < frame.scene().settings.height; ++row) {
        const ScanlineSection section = scanlineSection(frame, row);
        const auto isHidden = [](const ScanlineRun& run) { return !run.samples.front().stays; };
        if (section.runs.size() > 2 && std::ranges::any_of(section.runs, isHidden)) return row;
    }
    return 0;
}

// What every pixel's own replay tells, one after the other.
void expectTheSameAsPixels(const Frame& frame, int row) {
    const ScanlineSection section = scanlineSection(frame, row);
    for (int x = 0; x < frame.scene().settings.width; ++x) {
        const PixelReport pixel = inspectPixel(frame, {x, row});
        std::vector<std::pair<int, double>> expected, found;
        int seen = -1;
        for (const FragmentReport& fragment : pixel.fragments) {
            expected.emplace_back(fragment.polygon, fragment.depth);
            if (fragment.verdict == FragmentVerdict::WonStays || fragment.verdict == FragmentVerdict::PaintedLast)
                seen = fragment.polygon;
        }
        for (const ScanlineRun& run : section.runs)
            for (const ScanlineRun::Sample& sample : run.samples)
                if (sample.x == x) found.emplace_back(run.polygon, sample.depth);
        std::ranges::sort(expected);
        std::ranges::sort(found);
        ASSERT_EQ(found, expected) << x << ',' << row;
        ASSERT_EQ(section.winnerAt(x).value_or(-1), seen) << x << ',' << row;
    }
}

bool isOfLegend(const std::string& text) {
    return text.starts_with("flat") || text.starts_with("Gouraud") || text.starts_with("Phong");
}

}  // namespace

TEST(ScanlineSection, HasTheFragmentsOfEveryPixelOfItsRow) {
    for (const unsigned seed : {2u, 5u, 7u}) {
        Scene scene = test::randomScene(seed);
        if (scene.settings.visibility == Visibility::None) scene.settings.visibility = Visibility::ZBuffer;
        const FramePtr frame = test::frameOf(scene);
        const int row = crowdedRow(*frame);
        EXPECT_GT(row, 0) << seed;
        for (const int further : {0, 2}) expectTheSameAsPixels(*frame, row + further);
    }
}

// Row 281 of lecture 1's pyramid: polygons 1 and 2 side by side, each one run, and nothing else.
TEST(ScanlineSection, OfThePyramid) {
    const ScanlineSection section = scanlineSection(*test::frameOf(test::pyramid()), 281);
    ASSERT_EQ(section.runs.size(), 2u);
    EXPECT_EQ(section.runs[0].polygon, 1);
    EXPECT_EQ(section.runs[1].polygon, 2);
    for (const ScanlineRun& run : section.runs)
        EXPECT_TRUE(std::ranges::all_of(run.samples, &ScanlineRun::Sample::stays)) << "nothing lies before them";
    EXPECT_EQ(section.winnerAt(268), 2);
    EXPECT_FALSE(section.winnerAt(0));
    EXPECT_TRUE(scanlineSection(*test::frameOf(test::pyramid()), 3).empty());
}

// Against frames that were asked for each shading method on their own.
TEST(ScanlineSection, IntensitiesAreThoseOfEachShadingMethod) {
    Scene scene = test::pyramid();
    const auto section = shadedSection(frameWithIntensity(scene), 281, 1);
    ASSERT_TRUE(section);
    for (const Shading shading : {Shading::Flat, Shading::Gouraud, Shading::Phong}) {
        scene.settings.shading = shading;
        const FramePtr frame = frameWithIntensity(scene);
        const AnyBuffer intensity = *frame->buffer({BufferId::Intensity});
        for (int x = 0; x < scene.settings.width; ++x) {
            const Vec3d value = section->intensity[std::size_t(shading)][std::size_t(x)];
            ASSERT_EQ(std::isnan(value.x), !section->winnerAt(x)) << x;
            for (int c = 0; c < 3 && !std::isnan(value.x); ++c)
                ASSERT_EQ(value[c], intensity.value(std::size_t(x), 281, c)) << x;
        }
    }
    EXPECT_NEAR(section->intensity[std::size_t(Shading::Flat)][268].z, 114.739, 5e-4);
}

// A pane before nothing is drawn: it has a colour, and no depth.
TEST(ScanlineSection, TranslucentLayersBeforeNothingHaveAnIntensity) {
    Scene scene = test::pyramid();
    scene.objects[0].material.alpha = 0.5;
    FrameRequest request;
    request.wanted = sectionBuffers();
    const FramePtr frame = runFrame(std::make_shared<const Scene>(scene), request, nullptr);
    const auto section = shadedSection(frame, 281, 1),
               opaque = shadedSection(frameWithIntensity(test::pyramid()), 281, 1);
    ASSERT_TRUE(section && opaque);
    EXPECT_TRUE(section->runs.empty());
    EXPECT_FALSE(section->empty());
    EXPECT_EQ(section->extent(), opaque->extent());
    for (std::size_t shading = 0; shading < 3; ++shading)
        for (std::size_t x = 0; x < section->intensity[shading].size(); ++x) {
            const Vec3d through = section->intensity[shading][x], solid = opaque->intensity[shading][x];
            ASSERT_EQ(std::isnan(through.z), std::isnan(solid.z)) << x;
            if (std::isnan(solid.z)) continue;
            ASSERT_NEAR(through.z, 0.5 * solid.z, 1e-4) << x;
        }
}

TEST(ScanlineSection, IsWrittenAsATable) {
    const auto section = shadedSection(frameWithIntensity(test::pyramid()), 281, 1);
    const std::string csv = sectionCsv(*section);
    EXPECT_TRUE(csv.starts_with("x,seen,z_view.1,z_view.2,flat.r,flat.g,flat.b,gouraud.r,")) << csv.substr(0, 100);
    EXPECT_EQ(std::ranges::count(csv, '\n'), 641) << "a heading and a line per pixel";
    EXPECT_NE(csv.find("\r\n0,,,,,,"), std::string::npos) << "nothing is drawn at x = 0";
    EXPECT_NE(csv.find("\r\n268,2,,671."), std::string::npos);
}

// Polygon 7 is drawn first, comes twice to x = 1 and has two runs; polygon 4 is seen at x = 0 and 1, nothing at x = 3.
// A painter compares distances, whatever format the frame's depths have: near is small there.
TEST(ScanlineSection, OfAPainterSaysZView) {
    Scene scene = test::pyramid();
    scene.settings.visibility = Visibility::Painter;
    for (const DepthFormat format : {DepthFormat::Fixed16, DepthFormat::Reversed}) {
        scene.settings.depthFormat = format;
        const FramePtr frame = frameWithIntensity(scene);
        const ScanlineSection section = scanlineSection(*frame, 281);
        EXPECT_TRUE(sectionCsv(section).starts_with("x,seen,z_view.")) << sectionCsv(section).substr(0, 40);
        EXPECT_FALSE(section.nearIsLarger);
        const int x = section.runs[0].samples[0].x;
        EXPECT_EQ(section.runs[0].samples[0].depth, inspectPixel(*frame, {x, 281}).zView);
    }
}

TEST(ScanlineSection, ATableHasAPolygonsFirstDepthInItsColumn) {
    ScanlineSection section;
    section.width = 4;
    section.runs = {{7, {{0, 9.5, false}, {1, 8, false}, {1, 6, false}}},
                    {7, {{2, 7, true}}},
                    {4, {{0, 2, true}, {1, 2.25, true}}}};
    EXPECT_EQ(sectionCsv(section),
              "x,seen,z_view.7,z_view.4\r\n"
              "0,4,9.5,2\r\n"
              "1,4,8,2.25\r\n"
              "2,7,7,\r\n"
              "3,,,\r\n");
}

class ScanlinePlotOfACrowdedRow : public testing::Test {
protected:
    const std::optional<ScanlineSection> section = [] {
        Scene scene = test::randomScene(7);
        scene.settings.visibility = Visibility::ZBuffer;
        const FramePtr frame = frameWithIntensity(scene);
        return shadedSection(frame, crowdedRow(*frame), 1);
    }();
};

// Bold and solid where a polygon is seen, thin and dashed where it is hidden; nothing leaves the drawing.
TEST_F(ScanlinePlotOfACrowdedRow, DrawsEveryRunOnceAndNothingOutside) {
    ASSERT_TRUE(section && !section->empty());
    const PlotDrawing drawing = layOut(ScanlinePlot{&*section, 0, 3, 5}, {900, 400, 14});
    std::size_t solid = 0, dashed = 0;
    for (const PlotLine& line : drawing.lines) {
        for (const auto& point : line.points) {
            EXPECT_GE(point.x, 0);
            EXPECT_LE(point.x, drawing.width);
            EXPECT_GE(point.y, 0);
            EXPECT_LE(point.y, drawing.height);
        }
        solid += line.ink.role == PlotRole::Series && line.dash == PlotDash::Solid;
        dashed += line.ink.role == PlotRole::Series && line.dash == PlotDash::Dashed;
    }
    EXPECT_GT(solid, 0u);
    EXPECT_GT(dashed, 0u);
    const ScanlineAxes axes = axesOf(*section, {900, 400, 14});
    for (const int x : {int(axes.depth.first), int(axes.depth.first) + 3})
        EXPECT_EQ(axes.at(axes.depth.centre(x)).pixelAt(axes.depth.centre(x)), x);
}

// 170 points of height leave 3 of 18 for words above and 1.7 below: 85 for the curves, of which two plots above each
// other would have 45 each. Both have the same columns, and the place of one is found in either.
TEST_F(ScanlinePlotOfACrowdedRow, InALowPlotTheIntensityStandsBesideTheDepth) {
    ASSERT_TRUE(section && !section->empty());
    const PlotSize low{770, 170, 18};
    const ScanlineAxes axes = axesOf(*section, low);
    ASSERT_TRUE(axes.isBeside);
    EXPECT_FALSE(axesOf(*section, {770, 340, 18}).isBeside);
    EXPECT_FALSE(axesOf(*section, {500, 170, 18}).isBeside);
    const int x = int(axes.depth.first) + 3;
    EXPECT_EQ(axes.at(axes.depth.centre(x)).pixelAt(axes.depth.centre(x)), x);
    EXPECT_EQ(axes.at(axes.intensity.centre(x)).pixelAt(axes.intensity.centre(x)), x);
    const PlotDrawing drawing = layOut(ScanlinePlot{&*section, 0, x, std::nullopt}, low);
    int marks = 0;
    for (const PlotLine& line : drawing.lines) {
        for (const auto& point : line.points) EXPECT_TRUE(point.y >= 0 && point.y <= low.height);
        if (line.ink.role != PlotRole::Front || line.points.size() != 2) continue;
        ++marks;
        EXPECT_NEAR(line.points[1].y - line.points[0].y, 85, 1);
    }
    EXPECT_EQ(marks, 2);
    // In the line above stand numbers and legend.
    for (const double width : {660.0, 700.0, 770.0}) {
        const PlotDrawing narrow = layOut(ScanlinePlot{&*section, 0, x, std::nullopt}, {width, 170, 18});
        EXPECT_GE(std::ranges::count_if(narrow.texts, [](const PlotText& text) { return text.at.y < 25; }), 4) << width;
    }
}

// Names, numbers, legend and the labels along the foot.
TEST_F(ScanlinePlotOfACrowdedRow, TextsOfALineKeepOffEachOtherAtAnySize) {
    ASSERT_TRUE(section && !section->empty());
    const int x = int(axesOf(*section, {900, 400, 14}).depth.first) + 3;
    for (const std::optional<int> column : {std::optional<int>(), std::optional(x)})
        for (const double height : {150.0, 170.0, 200.0, 340.0})
            for (double width = 360; width < 900; width += 20) {
                const PlotDrawing drawing =
                    layOut(ScanlinePlot{&*section, 0, column, std::nullopt}, {width, height, 18});
                std::map<double, std::vector<std::pair<double, double>>> lines;  // from the top
                for (const PlotText& text : drawing.texts) {
                    if (text.ink.role == PlotRole::Series && !isOfLegend(text.text)) continue;  // at its run
                    const double wide = textWidth(text.text, text.size);
                    const double left = text.at.x - (text.anchor == PlotText::Anchor::End      ? wide
                                                     : text.anchor == PlotText::Anchor::Middle ? wide / 2
                                                                                               : 0);
                    lines[text.at.y].emplace_back(left, left + wide);
                }
                for (auto& [y, line] : lines) {
                    std::ranges::sort(line);
                    double reached = 0;
                    for (const auto& [left, right] : line) {
                        EXPECT_GE(left, reached) << width << " × " << height << " at " << y;
                        EXPECT_LE(right, width) << width << " × " << height << " at " << y;
                        reached = right;
                    }
                }
            }
}

}  // namespace pipeline
