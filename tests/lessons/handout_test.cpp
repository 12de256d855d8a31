#include "lessons/pages/handout.h"

#include "lessons/library.h"
#include "lessons/pages/handout_figure.h"
#include "lessons/questions/hidden.h"
#include "tests/lessons/html_of.h"
#include "tests/lessons/pyramid_scene.h"
#include "tests/support/files.h"

namespace lessons {
namespace {

std::size_t count(std::string_view text, std::string_view part) {
    std::size_t found = 0;
    for (auto at = text.find(part); at != text.npos; at = text.find(part, at + part.size())) ++found;
    return found;
}
bool has(std::string_view text, std::string_view part) { return count(text, part) > 0; }

TEST(ProseHtml, IsWhatTheWindowShowsOfMarkdown) {
    EXPECT_EQ(htmlOf("*one* **two**"), "<p><em>one</em> <strong>two</strong></p>\n");
    EXPECT_TRUE(has(htmlOf("- a\n- b\n"), "<li>a</li>"));
    EXPECT_EQ(htmlOf("***N***·***L***"), "<p><b class=\"vector N\">N</b>·<b class=\"vector L\">L</b></p>\n");
    EXPECT_EQ(htmlOf("*k_b* (R·V)^n, ρ_0 and FB_b"),
              "<p><em>k<sub>b</sub></em> (R·V)<sup>n</sup>, ρ<sub>0</sub> and FB<sub>b</sub></p>\n");
    EXPECT_EQ(htmlOf("(***R***·***V***)^n"),
              "<p>(<b class=\"vector R\">R</b>·<b class=\"vector V\">V</b>)<sup>n</sup></p>\n");
}

// A name in code is no formula, and a lesson brings no elements of its own.
TEST(ProseHtml, LeavesCodeAloneAndShowsHtmlAsItWasTyped) {
    EXPECT_EQ(htmlOf("`shadow_buffer.0`"), "<p><code>shadow_buffer.0</code></p>\n");
    EXPECT_FALSE(has(htmlOf("<script>alert(1)</script> a<b"), "<script"));
    EXPECT_TRUE(has(htmlOf("a < b & c"), "a &lt; b &amp; c"));
    EXPECT_FALSE(has(htmlOf("[x](javascript:alert(1)_a)"), "<sub>")) << "what stands in an attribute is no formula";
}

class HandoutOfThePyramid : public testing::Test {
protected:
    void SetUp() override {
        const auto lesson = findLesson("pyramid");
        ASSERT_TRUE(lesson);
        m_lesson = *lesson;
        const auto handout = makeHandout(m_lesson);
        ASSERT_TRUE(handout) << format(handout.errors());
        m_handout = *handout;
    }
    Lesson m_lesson;
    Handout m_handout;
};

// The pictures and tables of one half.
std::pair<std::size_t, std::size_t> figuresOf(const Half& half, const Hidden& hidden) {
    std::pair<std::size_t, std::size_t> found;
    for (const pipeline::BufferName& buffer : shownBuffers(half.state))
        if (!hidden.hides(buffer))
            ++(pipeline::bufferInfo(buffer.id).domain == pipeline::Domain::Pixel ? found.first : found.second);
    return found;
}

TEST_F(HandoutOfThePyramid, HasEveryPageWithItsPicturesAndQuestion) {
    std::size_t tables = 0, afterwards = 0;
    for (const Page& page : m_lesson.pages) {
        EXPECT_TRUE(has(m_handout.pages, page.heading)) << page.heading;
        tables += figuresOf(page.first, hiddenOn(page, false)).second;
        if (page.then) afterwards += figuresOf(*page.then, {}).first;
    }
    EXPECT_EQ(count(m_handout.pages, "<img src=\"data:image/png;base64,"), 7u)
        << "pages 1 and 4 to 9: nothing is drawn yet on the second, the third has a table";
    EXPECT_EQ(count(m_handout.pages, "<table"), tables) << "what polygons have is no picture";
    EXPECT_EQ(count(m_handout.pages, "class=question"), m_lesson.pages.size());
    EXPECT_EQ(count(m_handout.answers, "class=answer") + count(m_handout.answers, "<pre><code>function"),
              m_lesson.pages.size())
        << "the last asks for lines";
    EXPECT_EQ(count(m_handout.answers, "<img src=\"data:image/png;base64,"), afterwards) << "of the second halves";
    EXPECT_FALSE(has(m_handout.pages, "<script"));
    EXPECT_FALSE(has(m_handout.pages, "http")) << "it needs nothing from elsewhere";
}

// The lecture's numbers, as lesson_data_test.cpp derives them: 310, 0.66896, 35.376°, 0.81537. What asks for them has
// none of them before the hints, neither in texts nor in tables nor in the words for pictures.
TEST_F(HandoutOfThePyramid, AsksWithoutTheAnswersAndKeepsThemApart) {
    const std::string asked = m_handout.pages.substr(0, m_handout.pages.find("<h2>Hints</h2>"));
    EXPECT_TRUE(has(asked, "(335, 75, 150)"));
    const std::string second = asked.substr(asked.find("<h2>2 "), asked.find("<h2>3 ") - asked.find("<h2>2 "));
    for (const char* answer : {">310", " 310"}) EXPECT_FALSE(has(second, answer)) << answer;
    for (const char* answer : {"0.669", "35.4", "35.37", "0.8154", "back-facing", "kept"})
        EXPECT_FALSE(has(asked, answer)) << answer;
    EXPECT_TRUE(has(m_handout.answers, "<p class=answer>310</p>"));
    EXPECT_TRUE(has(m_handout.answers, "<p class=answer>A: <em>Left</em>; E: <em>Base</em></p>"));
    EXPECT_TRUE(has(asked, "(75,75,150)           vertex 4")) << "the files are on paper too";
    EXPECT_TRUE(has(m_handout.answers, "<li><p>Its whole part is 310.</p>\n</li>")) << "the way of working";
    EXPECT_TRUE(has(m_handout.answers, "<td>169</td><td>rows counted from the bottom</td>")) << "the wrong answers";
    EXPECT_TRUE(has(m_handout.answers, "<p class=remark>2 points</p>"));
    EXPECT_TRUE(has(m_handout.answers, "is 0.8154 on <em>Front</em>")) << "the second halves";
    EXPECT_EQ(count(asked, "class=box"), 12u) << "five polygons, and four and three options to tick";
}

// A screen reader hears what the picture shows, not that there is one.
TEST_F(HandoutOfThePyramid, SaysInWordsWhatItsPicturesShow) {
    EXPECT_FALSE(has(m_handout.pages, "Picture of"));
    EXPECT_TRUE(has(m_handout.pages, "Nothing is drawn yet.")) << "page 5";
    EXPECT_TRUE(has(m_handout.answers, "At the ring, pixel 250, 270, the value is 671.93"));
}

// 0.9·50 + 100·0.9·0.7746 + 40·0.3974^8 = 114.739, and 255·114.739/175 = 167: the blue of pixel 268, 281.
TEST_F(HandoutOfThePyramid, HasTheEquationOfThePickedPixelAfterTheAnswer) {
    EXPECT_FALSE(has(m_handout.pages, "(the ring)")) << "it has the numbers that are asked for";
    EXPECT_EQ(count(m_handout.answers, "Pixel 268, 281 (the ring), blue:"), 1u);  // page 7
    EXPECT_TRUE(has(m_handout.answers, "114.739</p>"));
    EXPECT_TRUE(has(m_handout.answers, "= 167"));
    EXPECT_TRUE(has(m_handout.answers, "0.3974<sup>8</sup>"));
}

TEST_F(HandoutOfThePyramid, IsTwoFilesOrNone) {
    const test::TemporaryFolder folder;
    const auto written = writeHandout(m_handout, "pyramid", folder / "out");
    ASSERT_TRUE(written) << format(written.errors());
    EXPECT_EQ(*written, (std::vector<std::string>{"pyramid.html", "pyramid-answers.html"}));
    EXPECT_EQ(test::readText(folder / "out" / "pyramid.html"), m_handout.pages);
    EXPECT_EQ(test::readText(folder / "out" / "pyramid-answers.html"), m_handout.answers);
    std::filesystem::create_directories(folder / "no" / "pyramid-answers.html");  // where a file is to be
    EXPECT_FALSE(writeHandout(m_handout, "pyramid", folder / "no"));
    EXPECT_FALSE(std::filesystem::exists(folder / "no" / "pyramid.html"));
}

// Where a mark in a picture is asked for, no page before it shows that view: highlight 7 rings a point of the highlight.
TEST(Handout, AsksForMarksBeforeOtherPagesShowTheirPlace) {
    const auto lesson = findLesson("highlight");
    ASSERT_TRUE(lesson);
    const auto handout = makeHandout(*lesson);
    ASSERT_TRUE(handout);
    std::vector<std::string> order;
    for (std::size_t at = 0; (at = handout->pages.find("<section>\n<h2>", at)) != std::string::npos; ++at)
        order.push_back(handout->pages.substr(at + 14, handout->pages.find("</h2>", at) - at - 14));
    ASSERT_FALSE(order.empty());
    EXPECT_EQ(order.front(), "4 Where it will be");
    EXPECT_EQ(order.back(), "Hints");
    EXPECT_TRUE(order[1].starts_with("Again: ")) << "what returns, and then the others in their order: " << order[1];
    const std::size_t first = handout->pages.find("<div class=first>"),
                      end = handout->pages.find("</div>\n<section>", first);
    ASSERT_NE(end, std::string::npos);
    EXPECT_EQ(count(std::string_view(handout->pages).substr(first, end - first), "<section>"), 1u);
}

TEST(Handout, SaysThatAWrongPredictionCostsNothing) {
    const auto lesson =
        parseLesson("title: T\nlecture: L\nsummary: S\nscene: pyramid\n# One\nText.\nprediction: Q?\nanswer: 1\n",
                    "lesson.md", [](std::string_view) -> pipeline::Result<pipeline::Scene> { return pyramidScene(); });
    const auto handout = makeHandout(lesson.value());
    ASSERT_TRUE(handout);
    EXPECT_TRUE(has(handout->pages, "Prediction: 1 point, a wrong answer costs nothing"));
}

TEST(Handout, IsNotMadeWhenItIsStopped) {
    std::stop_source source;
    int pages = 0;
    const auto handout = makeHandout(*findLesson("pyramid"), source.get_token(), [&](std::size_t) {
        if (++pages == 3) source.request_stop();
    });
    ASSERT_FALSE(handout);
    EXPECT_EQ(format(handout.errors()), "stopped\n");
    EXPECT_EQ(pages, 3);
}

// The pyramid covers columns 225 to 312 and rows 244 to 310 at most; 640 · 480 is 4 : 3.
TEST(HandoutFigure, ShowsThePartThatIsDrawnInThePicturesProportions) {
    const pipeline::FramePtr frame = frameOf(pyramidScene(), pipeline::setOf({pipeline::BufferId::Color}));
    const pipeline::BufferName color{pipeline::BufferId::Color};
    const pipeline::Tile part = partToShow(*frame, std::span(&color, 1), {});
    const glm::ivec2 size = part.max - part.min;
    EXPECT_NEAR(double(size.x) / size.y, 640.0 / 480, 0.02);
    EXPECT_LT(size.x, 320);
    const auto buffer = frame->buffer(color);
    for (std::size_t y = 0; y < 480; ++y)
        for (std::size_t x = 0; x < 640; ++x) {
            const bool inside =
                int(x) >= part.min.x && int(x) < part.max.x && int(y) >= part.min.y && int(y) < part.max.y;
            if (!inside) {
                EXPECT_EQ(buffer->value(x, y, 2), 0) << x << ", " << y;
            }
        }
    const pipeline::Tile withCorner = partToShow(*frame, std::span(&color, 1), glm::ivec2(639, 479));
    EXPECT_EQ(withCorner.min, glm::ivec2(0));
    EXPECT_EQ(withCorner.max, glm::ivec2(640, 480));
}

TEST(HandoutFigure, HasTheRangeAndTheChannelOfItsView) {
    const pipeline::FramePtr frame =
        frameOf(pyramidScene(), pipeline::setOf({pipeline::BufferId::ZView, pipeline::BufferId::Intensity}));
    const pipeline::Tile whole{{0, 0}, {640, 480}};
    BufferShown look;
    const auto figure = [&](pipeline::BufferId id) { return figureHtml(*frame, {id}, whole, {}, look); };
    const std::string fitted = figure(pipeline::BufferId::ZView), all = figure(pipeline::BufferId::Intensity);
    look.range = {600, 1000};
    const std::string ranged = figure(pipeline::BufferId::ZView);
    EXPECT_TRUE(has(ranged, "600 <span")) << ranged.substr(ranged.find("<figcaption>"));
    EXPECT_TRUE(has(ranged, "</span> 1000")) << ranged.substr(ranged.find("<figcaption>"));
    EXPECT_NE(ranged.substr(0, ranged.find("<figcaption>")), fitted.substr(0, fitted.find("<figcaption>")));
    look.channel = ShownChannel::Third;
    look.range = {0, 175};
    EXPECT_NE(figure(pipeline::BufferId::Intensity), all);
}

TEST(HandoutFigure, IsATableOfWhatHasNoPixelsAndAReasonWhereThereIsNothing) {
    pipeline::FrameRequest request;
    request.wanted = pipeline::setOf({pipeline::BufferId::PolygonsVerdict, pipeline::BufferId::VerticesWorld});
    const pipeline::FramePtr frame = frameOf(pyramidScene(), request);
    const pipeline::Tile whole{{0, 0}, {640, 480}};
    const std::string verdicts = figureHtml(*frame, {pipeline::BufferId::PolygonsVerdict}, whole, {});
    EXPECT_TRUE(has(verdicts, "<tr><td>0</td><td>back-facing</td></tr>")) << verdicts;  // Left
    const std::string places = figureHtml(*frame, {pipeline::BufferId::VerticesWorld}, whole, {});
    EXPECT_TRUE(has(places, "<td>4</td><td class=number>335</td><td class=number>75</td><td class=number>150</td>"));
    const std::string none = figureHtml(*frame, {pipeline::BufferId::ShadowBuffer, 0}, whole, {});
    EXPECT_TRUE(has(none, "convex")) << none;
}

}  // namespace
}  // namespace lessons
