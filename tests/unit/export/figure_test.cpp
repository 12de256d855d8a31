#include "pipeline/export/figure/figure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "tests/support/scenes.h"

namespace pipeline {
namespace {

// The lecture's pyramid in flat shading: 640 × 480.
Figure depthFigure() {
    const FramePtr frame = test::frameOf(test::pyramid(), setOf({BufferId::ZView, BufferId::PolygonId}));
    return figureOf(*frame, *frame->buffer({BufferId::ZView}));
}

std::uint32_t bigEndian(const std::string& bytes, std::size_t at) {
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < 4; ++i) number = number << 8 | static_cast<unsigned char>(bytes[at + i]);
    return number;
}

TEST(Figure, ItsRangeIsOfWhatWasDrawn) {
    const Figure figure = depthFigure();
    double least = INFINITY, most = 0;
    for (std::size_t y = 0; y < figure.buffer.rows(); ++y)
        for (std::size_t x = 0; x < figure.buffer.columns(); ++x)
            if (figure.seen->value(x, y) >= 0)
                least = std::min(least, figure.buffer.value(x, y)), most = std::max(most, figure.buffer.value(x, y));
    EXPECT_EQ(std::min(figure.range.first, figure.range.last), least);
    EXPECT_EQ(std::max(figure.range.first, figure.range.last), most);
}

// 84 mm are 84 / 25.4 · 72 = 238.11 pt and, at 300 dots per inch, 992.1 dots, of which a file has whole ones: 993.
TEST(Figure, ItsSizeIsInMillimetresInEveryFormat) {
    const Figure figure = depthFigure();
    const FigureSize size = sizeOf(figure);
    EXPECT_DOUBLE_EQ(size.width, 84);
    const auto svg = figureFile(figure, FigureFormat::Svg);
    ASSERT_TRUE(svg);
    EXPECT_NE(svg->find("width=\"84mm\""), std::string::npos);
    EXPECT_NE(svg->find("image-rendering:pixelated"), std::string::npos);
    const auto pdf = figureFile(figure, FigureFormat::Pdf);
    ASSERT_TRUE(pdf);
    EXPECT_TRUE(pdf->starts_with("%PDF-"));
    EXPECT_NE(pdf->find("[ 0 0 238.11"), std::string::npos);
    const auto png = figureFile(figure, FigureFormat::Png);
    ASSERT_TRUE(png);
    EXPECT_EQ(bigEndian(*png, 16), 993u);
    EXPECT_EQ(bigEndian(*png, 20), std::uint32_t(std::ceil(size.height / 25.4 * 300)));
    // 300 dots per inch are 300 / 0.0254 = 11811 per metre, in the chunk after the header of 8 + 25 bytes.
    EXPECT_EQ(png->substr(37, 4), "pHYs");
    EXPECT_EQ(bigEndian(*png, 41), 11811u);
}

TEST(Figure, TheSameFigureHasTheSameBytes) {
    const Figure figure = depthFigure();
    for (const FigureFormat format : {FigureFormat::Svg, FigureFormat::Pdf, FigureFormat::Png})
        EXPECT_TRUE(*figureFile(figure, format) == *figureFile(figure, format)) << int(format);
}

TEST(Figure, APartHasTheShapeOfItsPixels) {
    Figure figure = depthFigure();
    figure.hasBar = false, figure.caption.clear();
    figure.part = Figure::Part{{100, 100}, {299, 199}};  // 200 × 100
    const FigureSize size = sizeOf(figure);
    // An edge of 0.6 em at each side: 2 · 0.6 · 8 pt.
    const double edges = 2 * 0.6 * 8 * 25.4 / 72;
    EXPECT_NEAR(size.height - edges, (size.width - edges) / 2, 1e-9);
}

std::size_t occurrences(const std::string& text, std::string_view of) {
    std::size_t count = 0;
    for (std::size_t at = text.find(of); at != text.npos; at = text.find(of, at + 1)) ++count;
    return count;
}

// A part of 10 × 10 pixels has 9 lines from left to right and 9 from top to bottom between them, one of 5 × 4 has 4 and 3.
TEST(Figure, AGridHasALineBetweenTwoPixels) {
    Figure figure = depthFigure();
    figure.hasBar = false, figure.hasGrid = true;
    figure.part = Figure::Part{{260, 270}, {269, 279}};
    const auto many = figureFile(figure, FigureFormat::Svg);
    figure.part = Figure::Part{{260, 270}, {264, 273}};
    const auto few = figureFile(figure, FigureFormat::Svg);
    ASSERT_TRUE(many && few);
    EXPECT_EQ(occurrences(*many, " L ") - occurrences(*few, " L "), 18u - 7u);
}

// Of the pyramid's five polygons two are culled: the base and a side (lecture 1).
TEST(Figure, ItsEdgesAreOfThePolygonsThatGoOn) {
    const FramePtr frame = test::frameOf(test::pyramid(), outlineBuffers());
    const auto screen = frame->buffer({BufferId::VerticesScreen});
    const std::vector<Figure::Outline> all = polygonOutlines(*frame, {});
    ASSERT_EQ(all.size(), 3u);
    for (const Figure::Outline& outline : all) {
        ASSERT_EQ(outline.size(), 3u);
        for (const glm::dvec2& corner : outline) {
            bool isVertex = false;
            for (std::size_t v = 0; v < screen->rows(); ++v)
                isVertex = isVertex || (screen->value(0, v, 0) == corner.x && screen->value(0, v, 1) == corner.y);
            EXPECT_TRUE(isVertex);
        }
    }
    // The pyramid is in the middle of the picture.
    EXPECT_TRUE(polygonOutlines(*frame, Figure::Part{{0, 0}, {9, 9}}).empty());
    Figure figure =
        figureOf(*frame, *test::frameOf(test::pyramid(), setOf({BufferId::ZView}))->buffer({BufferId::ZView}));
    const std::size_t before = figureFile(figure, FigureFormat::Svg)->size();
    figure.outlines = all;
    EXPECT_GT(figureFile(figure, FigureFormat::Svg)->size(), before);
    figure.outlines.resize(kMostOutlines + 1);
    const auto refused = figureFile(figure, FigureFormat::Svg);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.errors().front().found.find("100001 polygons"), std::string::npos);
}

TEST(Figure, WithoutRoomForThePictureItIsRefused) {
    Figure figure = depthFigure();
    figure.width = kLeastFigure, figure.letters = kMostLetters;
    const auto file = figureFile(figure, FigureFormat::Svg);
    ASSERT_FALSE(file);
    EXPECT_NE(file.errors().front().found.find("no room"), std::string::npos);
}

TEST(Figure, ACaptionFromAStrangerIsWrittenWhateverItHolds) {
    Figure figure = depthFigure();
    const double before = sizeOf(figure).height;
    figure.caption = "\xff\xfe <svg> \x1b[2J " + std::string(5000, 'x') + "\n\n\u202e end";
    EXPECT_GT(sizeOf(figure).height, before);
    const auto svg = figureFile(figure, FigureFormat::Svg);
    ASSERT_TRUE(svg);
    EXPECT_EQ(svg->find('\x1b'), std::string::npos);
    EXPECT_EQ(svg->find("<svg", 100), std::string::npos);
}

TEST(Figure, TheMarkedPixelStandsInTheCaption) {
    Figure figure = depthFigure();
    figure.pixel = glm::ivec2(268, 281);
    // The lecture's example: its depth there is 671.45 (tests/reference/lecture_example_test.cpp).
    const std::string caption = captionOf(figure, test::pyramid(), "Depth");
    EXPECT_NE(caption.find("at 268, 281: 671.45 world units."), std::string::npos) << caption;
}

}  // namespace
}  // namespace pipeline
