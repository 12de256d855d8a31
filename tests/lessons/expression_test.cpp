#include "lessons/expression.h"

#include "tests/lessons/pyramid_scene.h"

namespace lessons {
namespace {

class Expressions : public testing::Test {
protected:
    static void SetUpTestSuite() {
        s_scene = pyramidScene();
        pipeline::FrameRequest request;
        request.wanted.set();
        // Asked for by name it would run, and the plan would have no reason to leave it out.
        request.wanted.reset(index(pipeline::BufferId::ShadowBuffer));
        s_frame = frameOf(s_scene, request);
    }
    static void TearDownTestSuite() { s_frame.reset(); }

    // The value as text, or the errors.
    static std::string valueOf(std::string_view text) {
        const auto expression = parseExpression(text, {"f", 1, 1}, s_scene);
        if (!expression) return format(expression.errors());
        const auto value = evaluate(*expression, *s_frame);
        return value ? toText(*value) : format(value.errors());
    }

    static inline pipeline::Scene s_scene;
    static inline pipeline::FramePtr s_frame;
};

TEST_F(Expressions, FollowTheUsualPrecedence) {
    EXPECT_EQ(valueOf("1 + 2 * 3 - 4 / 2"), "5");
    EXPECT_EQ(valueOf("(1 + 2) * 3"), "9");
    EXPECT_EQ(valueOf("2^3^2"), "512");
    EXPECT_EQ(valueOf("-2^2"), "\u22124");
    EXPECT_EQ(valueOf("2 - -3"), "5");
    EXPECT_EQ(valueOf("floor(-0.5) + ceil(0.5) + round(2.5) + abs(-1)"), "4");
    EXPECT_EQ(valueOf("min(1, 2) + max(1, 2) + sqrt(9)"), "6");
    EXPECT_EQ(valueOf("sin(90) + cos(180)"), "0");  // degrees
    EXPECT_EQ(valueOf("acos(0)"), "90");
    EXPECT_EQ(valueOf("log(1)"), "0");
}

// Derived from the lecture's two files by hand; see tests/reference for the derivations.
TEST_F(Expressions, ReadTheResultsOfTheProgram) {
    EXPECT_EQ(valueOf("buffer(vertices.world, 4)"), "(335, 75, 150)");
    EXPECT_EQ(valueOf("buffer(vertices.world, 4, x)"), "335");
    EXPECT_EQ(valueOf("buffer(n_dot_l.0, 268, 281)"), "0.7746");  // (2 + 1) / sqrt(15)
    EXPECT_EQ(valueOf("buffer(color, 268, 281)"), "(37, 93, 167)");
    EXPECT_EQ(valueOf("buffer(color, 268, 281, b)"), "167");
    EXPECT_EQ(valueOf("count(polygons.verdict = back-facing)"), "2");
    EXPECT_EQ(valueOf("count(polygons.verdict != kept)"), "2");
    EXPECT_EQ(valueOf("verdict(4)"), "back-facing");
    EXPECT_EQ(valueOf("pixel(268, 281).polygon"), "2");
    EXPECT_EQ(valueOf("pixel(268, 281).i_max"), "175");  // 0.9·50 + 100·(0.9 + 0.4)
    EXPECT_EQ(valueOf("fragment(268, 281, 0).polygon"), "2");
    EXPECT_EQ(valueOf("setting(material.0.n)"), "8");
    EXPECT_EQ(valueOf("largest(polygon_id)"), "3");
    EXPECT_EQ(valueOf("smallest(polygon_id)"), "\u22121");
    EXPECT_EQ(valueOf("setting(shading)"), "flat");
    EXPECT_EQ(valueOf("setting(leave_out)"), "on");
    EXPECT_EQ(valueOf("why(shadow-buffer)"), "The only object is convex: it cannot shadow itself.");
}

TEST_F(Expressions, SayWhereSomethingIsUnknownAndWhatIsNearest) {
    EXPECT_EQ(valueOf("1 + bufer(depth, 0, 0)"), "f:1:5: no function \"bufer\"; the nearest is \"buffer\"\n");
    EXPECT_EQ(valueOf("buffer(dept, 0, 0)"), "f:1:8: no buffer \"dept\"; the nearest is \"depth\"\n");
    EXPECT_EQ(valueOf("buffer(n_dot_l.3, 0, 0)"), "f:1:8: no buffer \"n_dot_l.3\": this scene has 1 light\n");
    EXPECT_EQ(valueOf("count(polygons.verdict = backfacing)"),
              "f:1:26: no verdict \"backfacing\"; the nearest is \"back-facing\"\n");
    EXPECT_EQ(valueOf("setting(material.0.m)"),
              "f:1:9: no setting \"material.0.m\"; the nearest is \"material.0.n\"\n");
    EXPECT_EQ(valueOf("why(zbuffer)"), "f:1:5: no stage \"zbuffer\"; the nearest is \"z-buffer\"\n");
    EXPECT_EQ(valueOf("pixel(1, 2).poligon"), "f:1:13: pixel has no \"poligon\"; the nearest is \"polygon\"\n");
    EXPECT_EQ(valueOf("buffer(depth, 0, 0, g)"), "f:1:21: no channel \"g\": depth has one value a place\n");
}

TEST_F(Expressions, RefusePlacesOutsideThePictureAndTheMeshes) {
    EXPECT_EQ(valueOf("buffer(depth, 640, 0)"), "f:1:15: found 640, expected x from 0 to 639\n");
    EXPECT_EQ(valueOf("buffer(depth, 0, 480)"), "f:1:18: found 480, expected y from 0 to 479\n");
    EXPECT_EQ(valueOf("pixel(0.5, 0).depth"), "f:1:7: found 0.5, expected x from 0 to 639\n");
    EXPECT_EQ(valueOf("buffer(vertices.world, 5)"), "f:1:24: found 5, expected a vertex from 0 to 4\n");
    EXPECT_EQ(valueOf("signed_area(5)"), "f:1:13: found 5, expected a polygon from 0 to 4\n");
    // Computed places are checked when they are computed.
    EXPECT_EQ(valueOf("buffer(depth, 639 + 1, 0)"),
              "f:1:1: found the place 640, expected a whole number from 0 to 639\n");
}

TEST_F(Expressions, RefuseTextThatIsNoFormula) {
    EXPECT_EQ(valueOf(""), "f:1:1: found the end, expected a number, a function or '('\n");
    EXPECT_EQ(valueOf("1 +"), "f:1:4: found the end, expected a number, a function or '('\n");
    EXPECT_EQ(valueOf("(1"), "f:1:3: found the end, expected ')'\n");
    EXPECT_EQ(valueOf("1 2"), "f:1:3: found \"2\", expected an operator or the end\n");
    EXPECT_EQ(valueOf("1e999"), "f:1:1: found \"1e999\", expected a number, a function or '('\n");
    EXPECT_EQ(valueOf("μ"), "f:1:1: found \"μ\", expected a number, a function or '('\n");
    EXPECT_EQ(valueOf(std::string(10000, '(')).substr(0, 27), "f:1:51: found more than 50 ");
    EXPECT_EQ(valueOf(std::string(10000, '-')).substr(0, 27), "f:1:51: found more than 50 ");
    std::string chain = "1";
    for (int i = 0; i < 500; ++i) chain += "+1";
    EXPECT_EQ(valueOf(chain), "501");
    for (int i = 0; i < 100'000; ++i) chain += "+1";
    EXPECT_NE(valueOf(chain).find("more than 500 operators"), std::string::npos);
}

TEST_F(Expressions, SayWhenAResultIsNoFiniteNumber) {
    EXPECT_EQ(valueOf("1 / 0"), "f:1:1: 1 / 0 is +∞, expected a finite number\n");
    EXPECT_EQ(valueOf("buffer(z_view, 0, 0)"), "f:1:1: buffer(z_view, 0, 0) is +∞, expected a finite number\n");
    EXPECT_EQ(valueOf("1 + buffer(vertices.world, 4)"), "f:1:5: found a vector, expected one number\n");
    EXPECT_EQ(valueOf("1 + verdict(4)"), "f:1:5: found words, expected one number\n");
    EXPECT_EQ(valueOf("pixel(0, 0).polygon"),
              "f:1:1: nothing is drawn at this pixel, expected a pixel that a polygon covers\n");
}

TEST_F(Expressions, NameTheBuffersThatTheyRead) {
    const auto expression = parseExpression("buffer(depth, 0, 0) + count(overdraw > 1)", {}, s_scene);
    ASSERT_TRUE(expression);
    EXPECT_EQ(buffersOf(*expression), pipeline::setOf({pipeline::BufferId::Depth, pipeline::BufferId::Overdraw}));
}

}  // namespace
}  // namespace lessons
