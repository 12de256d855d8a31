#include "pipeline/study/plot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "pipeline/export/figure/plot_file.h"
#include "pipeline/study/plot_axis.h"
#include "tests/support/files.h"
#include "tests/support/studies.h"

namespace pipeline {
namespace {

using test::sphereStudy;
using test::studyPoint;

PlotDrawing drawingOf(const StudyReport& report, const PlotSize& size = {}) {
    return layOut(plotOf(report, analyse(report, report.choice)), size);
}

std::vector<std::string> labelsOf(const LogAxis& axis, int most) {
    std::vector<std::string> labels;
    for (const Tick& tick : ticksOf(axis, most, 0.1)) labels.push_back(tick.label);
    return labels;
}

const PlotText* find(const PlotDrawing& drawing, const std::string& words) {
    for (const PlotText& text : drawing.texts)
        if (text.text == words) return &text;
    return nullptr;
}

struct Box {
    double left, top, right, bottom;
};

// From above: the widest font, and a line's whole height above the base line.
Box boxOf(const PlotText& text) {
    const double width = textWidth(text.text, text.size);
    const double before = text.anchor == PlotText::Anchor::Start    ? 0
                          : text.anchor == PlotText::Anchor::Middle ? width / 2
                                                                    : width;
    if (text.upwards) return {text.at.x - 0.7 * text.size, text.at.y - width + before, text.at.x, text.at.y + before};
    return {text.at.x - before, text.at.y - 0.7 * text.size, text.at.x - before + width, text.at.y};
}

// Nothing leaves the drawing, no number in it is not finite, no two texts lie over each other.
void expectTidy(const PlotDrawing& drawing) {
    const auto inside = [&](double x, double y) {
        return x >= 0 && x <= drawing.width && y >= 0 && y <= drawing.height;  // false for NaN
    };
    for (const PlotLine& line : drawing.lines)
        for (const auto& point : line.points) EXPECT_TRUE(inside(point.x, point.y)) << point.x << ' ' << point.y;
    for (const PlotMarker& marker : drawing.markers) {
        EXPECT_TRUE(inside(marker.at.x - marker.size / 2, marker.at.y - marker.size / 2));
        EXPECT_TRUE(inside(marker.at.x + marker.size / 2, marker.at.y + marker.size / 2));
    }
    for (std::size_t i = 0; i < drawing.texts.size(); ++i) {
        const PlotText& text = drawing.texts[i];
        const Box a = boxOf(text);
        EXPECT_TRUE(inside(a.left, a.top) && inside(a.right, a.bottom)) << text.text;
        for (std::size_t k = 0; k < i; ++k) {
            const Box b = boxOf(drawing.texts[k]);
            EXPECT_FALSE(a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom)
                << text.text << " over " << drawing.texts[k].text;
        }
    }
}

TEST(PlotAxis, TicksAreRound) {
    EXPECT_EQ(labelsOf({3e-4, 30}, 20), (std::vector<std::string>{"1e-3", "1e-2", "0.1", "1", "10"}));
    EXPECT_EQ(labelsOf({1e-9, 1e9}, 7), (std::vector<std::string>{"1e-9", "1e-6", "1e-3", "1", "1000", "1e6", "1e9"}));
    EXPECT_EQ(labelsOf({0.4, 21}, 20), (std::vector<std::string>{"0.5", "1", "2", "5", "10", "20"}));
    EXPECT_EQ(labelsOf({0.81, 1.22}, 20), (std::vector<std::string>{"0.9", "1", "1.1", "1.2"}));
    EXPECT_EQ(labelsOf({101, 104}, 5), (std::vector<std::string>{"101", "102", "103", "104"}));
}

TEST(PlotAxis, StepsEndWhereNumbersAreFartherApartThanTheyAre) {
    EXPECT_EQ(roundSteps(0, 100, 5), (std::vector<double>{0, 20, 40, 60, 80, 100}));
    EXPECT_EQ(roundSteps(0.25, 0.45, 2), (std::vector<double>{0.3, 0.4}));
    // Neighbours in double, 2^-50 apart: 4.3 / 2^-50 lies above 2^52, where k + 1 is k or k + 2.
    const double low = 4.2999999999999989, next = std::nextafter(low, 5.0);
    const std::vector<double> steps = roundSteps(low, next, 4);
    EXPECT_TRUE(std::ranges::is_sorted(steps, std::less_equal()));
    for (const double step : steps) EXPECT_TRUE(step == low || step == next);
    EXPECT_EQ(roundSteps(3, 3, 4), std::vector<double>{3});
    EXPECT_EQ(roundSteps(-1e308, 1e308, 4), std::vector<double>{-1e308});  // their distance is no number
}

// log10 of 100 is half of that of 10^4: halfway along the axis.
TEST(PlotAxis, IsLogarithmic) {
    const LogAxis axis{1, 1e4, 500, 100};
    EXPECT_NEAR(axis.place(1), 500, 1e-9);
    EXPECT_NEAR(axis.place(100), 300, 1e-9);
    EXPECT_NEAR(axis.place(1e4), 100, 1e-9);
}

TEST(Plot, ShowsEachSettingOnceAndDominatedOnesHollow) {
    const StudyReport report = sphereStudy();
    const PlotDrawing drawing = drawingOf(report);
    std::vector<int> seen(report.points.size(), 0);
    for (const PlotMarker& marker : drawing.markers) {
        if (!marker.point) continue;
        ++seen[*marker.point];
        const bool dominated = *marker.point == 2 || *marker.point == 3 || *marker.point == 8;
        EXPECT_EQ(marker.filled, !dominated) << *marker.point;
        EXPECT_EQ(marker.ink, (PlotInk{PlotRole::Series, *marker.point / 4}));
    }
    EXPECT_EQ(seen, (std::vector<int>{1, 1, 1, 1, 1, 1, 1, 0, 1, 1, 1, 1}));  // the eighth failed
    EXPECT_TRUE(find(drawing, "stopped after 60 s"));
    EXPECT_TRUE(find(drawing, "gouraud, tessellation 128"));
}

TEST(Plot, NamesCurvesAndTheirOrders) {
    const PlotDrawing drawing = drawingOf(sphereStudy());
    for (const char* words : {"flat", "gouraud", "phong", "order 1.00 ± 0.05", "order 1.81 ± 0.37", "order 1.76 ± 0.14",
                              "RMSE of intensity", "run time of the frame (ms, median)", "Pareto front"})
        EXPECT_TRUE(find(drawing, words)) << words;
}

// A step line: every piece goes right or down, and it starts at the fastest point of the front.
TEST(Plot, TheFrontIsAStepLine) {
    const PlotDrawing drawing = drawingOf(sphereStudy());
    const auto front = std::ranges::find_if(
        drawing.lines, [](const PlotLine& line) { return line.ink.role == PlotRole::Front && line.points.size() > 4; });
    ASSERT_NE(front, drawing.lines.end());
    EXPECT_EQ(front->points.size(), 2 * 8 + 2u);  // eight points, each a way right and down
    for (std::size_t i = 1; i < front->points.size(); ++i) {
        const auto step = front->points[i] - front->points[i - 1];
        EXPECT_TRUE((step.x >= 0 && step.y == 0) || (step.x == 0 && step.y >= 0)) << step.x << ' ' << step.y;
    }
}

TEST(Plot, AnErrorOfZeroStandsAtTheFoot) {
    StudyReport report = sphereStudy();
    report.points[11].errors[0].value[0] = 0.0;
    const PlotDrawing drawing = drawingOf(report);
    ASSERT_TRUE(find(drawing, "0"));
    double lowest = 0, zero = 0;
    for (const PlotMarker& marker : drawing.markers) {
        if (!marker.point) continue;
        (*marker.point == 11 ? zero : lowest) = std::max(*marker.point == 11 ? zero : lowest, marker.at.y);
    }
    EXPECT_GT(zero, lowest);
    EXPECT_NEAR(find(drawing, "0")->at.y, zero, find(drawing, "0")->size / 2);
}

TEST(Plot, IntervalsShowWhereTheyAreWide) {
    StudyReport report = sphereStudy();
    const auto bars = [&] {
        const PlotDrawing drawing = drawingOf(report);
        return std::ranges::count_if(drawing.lines, [](const PlotLine& line) {
            return line.ink.role == PlotRole::Series && line.dash == PlotDash::Solid && line.points.size() == 2 &&
                   line.points[0].y == line.points[1].y;
        });
    };
    EXPECT_EQ(bars(), 0);  // ±0.5 % is less than a marker
    report.points[3] = studyPoint(3, report.points[3].values, 10.6, 1.3e-3, 0.5);
    EXPECT_EQ(bars(), 1);
    report.points[2].errors[0].drawn = {1.3e-3, 5.4e-3};  // upright, with a cap at each end
    EXPECT_EQ(bars(), 3);
}

TEST(Plot, SaysWhereThereIsNothingToShow) {
    StudyReport report = sphereStudy();
    for (StudyPoint& point : report.points) point.failure = "stopped";
    EXPECT_TRUE(find(drawingOf(report), "No setting has both a time and this error."));
    report = sphereStudy();
    for (StudyPoint& point : report.points)
        if (!point.errors.empty()) point.errors[0].value[0] = 0.0;
    EXPECT_TRUE(find(drawingOf(report), "Every error is exactly 0."));
}

TEST(Plot, SaysThatNothingHasBeenMeasured) { EXPECT_TRUE(find(layOut(Plot{}, {}), "Nothing has been measured yet.")); }

TEST(Plot, OddStudiesLayOutTidily) {
    std::vector<StudyReport> reports(6, sphereStudy());
    reports[0].axes.clear();  // one setting
    reports[0].points = {studyPoint(0, {}, 3, 0.01, 0.9)};
    reports[1].points.resize(2);  // all equal
    reports[1].points[1] = studyPoint(1, reports[1].points[1].values, 0.59, 4.2e-2);
    for (StudyPoint& point : reports[2].points)  // the ends of what a double holds
        if (!point.errors.empty()) point.errors[0].value[0] = point.number % 2 ? 1e300 : 5e-324;
    reports[3].errorBars[0].value[0] = 1;
    reports[4].scene = std::string(300, 'W');
    reports[4].axes[0].label = std::string(300, 'W');
    for (StudyPoint& point : reports[4].points) point.values[0] += std::string(200, 'm');
    for (StudyPoint& point : reports[5].points) {  // a reason each
        point.failure = "the reason " + std::to_string(point.number) + " why this setting has neither time nor error";
        point.values[0] = std::string(80, 'x') + std::to_string(point.number);
    }
    for (std::size_t i = 0; i < reports.size(); ++i) {
        SCOPED_TRACE(i);
        expectTidy(drawingOf(reports[i]));
        expectTidy(drawingOf(reports[i], {480, 320, 13}));
    }
}

TEST(Plot, CrowdedStudiesLayOutTidily) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> unit(0, 1);
    for (const int methods : {1, 3, 8, 40}) {
        SCOPED_TRACE(methods);
        StudyReport report = sphereStudy();
        report.points.clear();
        report.axes[0].values.clear();
        for (int m = 0; m < methods; ++m) {
            report.axes[0].values.push_back("method " + std::to_string(m));
            for (std::size_t level = 0; level < 4; ++level) {
                const double ms = 1 + unit(random), error = std::pow(10, -4 * unit(random)), spread = unit(random);
                report.points.push_back(studyPoint(report.points.size(),
                                                   {report.axes[0].values.back(), report.axes[1].values[level]}, ms,
                                                   error, spread));
            }
        }
        expectTidy(drawingOf(report));
        expectTidy(drawingOf(report, {1200, 700, 20}));
    }
}

TEST(PlotFile, WritesAPictureOfTheThemesColors) {
    const PlotDrawing drawing = drawingOf(sphereStudy());
    for (const PlotTheme theme : {PlotTheme::Light, PlotTheme::Dark, PlotTheme::Projector}) {
        const test::TemporaryFolder folder;
        test::writeText(folder / "plot.png", plotPng(drawing, theme, 1.5));
        const test::Png picture = test::readPng(folder / "plot.png");
        ASSERT_EQ(picture.width, 1440);
        ASSERT_EQ(picture.height, 900);
        const auto pixel = [&](int x, int y) {
            return Color8(picture.at(x, y, 0), picture.at(x, y, 1), picture.at(x, y, 2));
        };
        EXPECT_EQ(pixel(0, 0), plotColors(theme).background);
        for (const PlotMarker& marker : drawing.markers) {
            if (!marker.filled) continue;
            const int x = static_cast<int>(marker.at.x * 1.5), y = static_cast<int>(marker.at.y * 1.5);
            EXPECT_EQ(pixel(x, y), colorOf(plotColors(theme), marker.ink)) << x << ' ' << y;
        }
    }
}

TEST(PlotFile, WritesAnSvgOfTheDrawingsSize) {
    const std::string svg = plotSvg(drawingOf(sphereStudy()), PlotTheme::Light);
    EXPECT_TRUE(svg.starts_with("<?xml"));
    EXPECT_NE(svg.find("viewBox=\"0 0 960 600\""), std::string::npos);
    EXPECT_TRUE(svg.ends_with("</svg>\n"));
}

// WCAG 2.1, "relative luminance" and "contrast ratio".
TEST(PlotFile, TextStandsOutFromTheBackground) {
    const auto luminance = [](Color8 color) {
        const auto linear = [](int value) {
            const double c = value / 255.0;
            return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
        };
        return 0.2126 * linear(color.r) + 0.7152 * linear(color.g) + 0.0722 * linear(color.b);
    };
    for (const PlotTheme theme : {PlotTheme::Light, PlotTheme::Dark, PlotTheme::Projector}) {
        const PlotColors& colors = plotColors(theme);
        std::vector<Color8> inks{colors.text, colors.secondary, colors.failed, colors.equal};
        inks.insert(inks.end(), colors.series.begin(), colors.series.end());
        for (const Color8 ink : inks) {
            const double a = luminance(ink), b = luminance(colors.background);
            EXPECT_GE((std::max(a, b) + 0.05) / (std::min(a, b) + 0.05), theme == PlotTheme::Projector ? 7 : 4.5);
        }
    }
}

}  // namespace
}  // namespace pipeline
