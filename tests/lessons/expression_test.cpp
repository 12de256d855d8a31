#include "lessons/expression/expression.h"

#include "lessons/expression/changed_frames.h"
#include "lessons/expression/held_frame.h"
#include "pipeline/plan/frame_bytes.h"

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
    static std::string valueOf(std::string_view text) { return valueOf(text, {s_scene}, {.frame = *s_frame}); }
    static std::string valueOf(std::string_view text, const Scope& scope, const Context& context) {
        const auto expression = parseExpression(text, {"f", 1, 1}, scope);
        if (!expression) return format(expression.errors());
        const auto value = evaluate(*expression, context);
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
    EXPECT_EQ(valueOf(std::string(2000, '(')).substr(0, 27), "f:1:52: found more than 50 ");
    EXPECT_EQ(valueOf(std::string(2000, '-')).substr(0, 27), "f:1:52: found more than 50 ");
    std::string chain = "1";
    for (int i = 0; i < 500; ++i) chain += "+1";
    EXPECT_EQ(valueOf(chain), "501");
    for (int i = 0; i < 900; ++i) chain += "+1";
    EXPECT_NE(valueOf(chain).find("more than 500 operators"), std::string::npos);
}

TEST_F(Expressions, SayWhenAResultIsNoFiniteNumber) {
    EXPECT_EQ(valueOf("1 / 0"), "f:1:1: 1 / 0 is +∞, expected a finite number\n");
    EXPECT_EQ(valueOf("buffer(z_view, 0, 0)"), "f:1:1: buffer(z_view, 0, 0) is +∞, expected a finite number\n");
    EXPECT_EQ(valueOf("1 + buffer(vertices.world, 4)"),
              "f:1:5: found a vector, expected a number: one of its channels (.x), or length(…)\n");
    EXPECT_EQ(valueOf("1 + verdict(4)"), "f:1:5: found words, expected a number\n");
    EXPECT_EQ(valueOf("pixel(0, 0).polygon"),
              "f:1:1: nothing is drawn at this pixel, expected a pixel that a polygon covers\n");
}

TEST_F(Expressions, CompareAndChoose) {
    EXPECT_EQ(valueOf("1 < 2 and not 2 < 1 or 1 > 2"), "true");
    EXPECT_EQ(valueOf("1 = 1 && 1 == 1 && !(1 != 1)"), "true");
    EXPECT_EQ(valueOf("1 > 2 or 2 ≤ 1 or 1 ≠ 1"), "false");
    EXPECT_EQ(valueOf("if(1 < 2, 10, 20) + if(1 > 2, 1, 2)"), "12");
    EXPECT_EQ(valueOf("verdict(4) = back-facing"), "true");
    EXPECT_EQ(valueOf("verdict(4) != \"back-facing\" or setting(shading) = flat"), "true");
    EXPECT_EQ(valueOf("[1, 2] = [1, 2] and [1, 2] != [1, 3]"), "true");
    // What is not asked for need not have a value: nothing is drawn at 0, 0.
    EXPECT_EQ(valueOf("if(1 > 2, pixel(0, 0).polygon, 7)"), "7");
    EXPECT_EQ(valueOf("1 > 2 and pixel(0, 0).polygon = 1"), "false");
    EXPECT_EQ(valueOf("1 < 2 < 3"), "f:1:7: found \"< 3\", expected an operator or the end\n");
    EXPECT_EQ(valueOf("1 and 2 < 3"), "f:1:1: found a number, expected a comparison such as n_dot_l.0 > 0.5\n");
    EXPECT_EQ(valueOf("setting(shading) = phon"), "f:1:20: no choice \"phon\"; the nearest is \"phong\"\n");
    EXPECT_EQ(valueOf("verdict(4) < kept"), "f:1:1: found words, expected a number, or one of = !=\n");
    EXPECT_EQ(valueOf("if(1 < 2, 1, [1, 2])"),
              "f:1:14: found something of another kind than before the comma, expected the same kind for both\n");
}

TEST_F(Expressions, CalculateWithVectors) {
    EXPECT_EQ(valueOf("2 * [1, 2, 3] - [1, 1, 1] / 2"), "(1.5, 3.5, 5.5)");
    EXPECT_EQ(valueOf("[1, 2, 3].z + [4, 5].y"), "8");
    EXPECT_EQ(valueOf("dot([1, 2, 3], [4, 5, 6])"), "32");
    EXPECT_EQ(valueOf("cross([1, 0, 0], [0, 1, 0])"), "(0, 0, 1)");
    EXPECT_EQ(valueOf("length([3, 4])"), "5");
    EXPECT_EQ(valueOf("unit([0, 0, 2])"), "(0, 0, 1)");
    // R = 2(N·L)N − L is the program's reflection vector, to float's last place.
    EXPECT_EQ(valueOf("length(2 * dot(buffer(normal, 268, 281), buffer(light_vector.0, 268, 281)) * "
                      "buffer(normal, 268, 281) - buffer(light_vector.0, 268, 281) - "
                      "buffer(reflection_vector.0, 268, 281)) < 1e-6"),
              "true");
    EXPECT_EQ(valueOf("buffer(vertices.world, 4).y"), "75");
    EXPECT_EQ(valueOf("[1, 2] + [1, 2, 3]"), "f:1:10: found a vector of 3 numbers, expected one of 2\n");
    EXPECT_EQ(valueOf("cross([1, 2], [3, 4])"), "f:1:7: found a vector of 2 numbers, expected one of 3\n");
    EXPECT_EQ(valueOf("[1, 2].z"), "f:1:8: no channel \"z\": the vector has 2 numbers\n");
    EXPECT_EQ(valueOf("[1]"), "f:1:1: found a vector of one number, expected 2 to 4 numbers\n");
}

TEST_F(Expressions, HaveAnglesInDegreesAndWholeRests) {
    EXPECT_EQ(valueOf("tan(45) + asin(1) + atan2(1, -1)"), "226");
    EXPECT_EQ(valueOf("exp(log(5))"), "5");
    EXPECT_EQ(valueOf("mod(7, 3) + mod(-1, 4)"), "4");
    EXPECT_EQ(valueOf("cos(pi * 180 / pi)"), "\u22121");
}

// The pyramid has n = 8 and flat shading; with another setting the numbers are those of another frame.
TEST_F(Expressions, LookIntoTheSameSceneWithSettingsChanged) {
    EXPECT_EQ(valueOf("with(material.0.n=1; setting(material.0.n)) + setting(material.0.n)"), "9");
    pipeline::Scene whole = s_scene;
    whole.settings.cull = pipeline::CullMode::None;
    const auto frame = frameOf(whole, pipeline::setOf({pipeline::BufferId::Overdraw}));
    const auto overdraw = *frame->buffer({pipeline::BufferId::Overdraw});
    double more = 0;
    for (std::size_t i = 0; i < overdraw.count(); ++i) more += overdraw.flat(i) > 1;
    ASSERT_GT(more, 0);
    EXPECT_EQ(valueOf("with(cull=none; count(overdraw > 1))"), toText({{more}, {}}));
    EXPECT_EQ(valueOf("count(overdraw > 1)"), "0");
    // The lamp counts where N·L is above 0.
    EXPECT_EQ(valueOf("differing(intensity; light.0.intensity=50) = pixels(n_dot_l > 0)"), "true");
    EXPECT_EQ(valueOf("pixels(n_dot_l > 0) > 0"), "true");
    EXPECT_EQ(valueOf("differing(depth; light.0.intensity=50)"), "0");
    EXPECT_EQ(valueOf("with(shadng=flat; 1)"), "f:1:6: no setting \"shadng\"; the nearest is \"shading\"\n");
    EXPECT_EQ(valueOf("with(width=320, height=240; buffer(depth, 320, 0))"),
              "f:1:43: found 320, expected x from 0 to 319\n");
}

TEST_F(Expressions, RememberTheFramesOfChangedSettings) {
    ChangedFrames frames;
    EXPECT_EQ(valueOf("with(cull=none; count(overdraw > 1)) = with(cull = none; count(overdraw > 1))", {s_scene},
                      {.frame = *s_frame, .changed = &frames}),
              "true");
    const std::vector<std::string> changes{"cull=none"};
    const auto wanted = pipeline::setOf({pipeline::BufferId::Overdraw});
    const auto first = frames.frame(*s_frame, changes, wanted, {}),
               second = frames.frame(*s_frame, changes, wanted, {});
    ASSERT_TRUE(first && second);
    EXPECT_EQ(*first, *second);
}

// A page may ask for any number of frames of any size: what is kept goes before a new one would make it too much.
TEST_F(Expressions, FramesOfChangedSettingsHaveABudgetOfBytes) {
    ChangedFrames frames;
    const auto wanted = pipeline::setOf({pipeline::BufferId::Normal, pipeline::BufferId::Position});
    std::vector<std::weak_ptr<const pipeline::Frame>> made;
    double all = 0;
    for (int theta = 0; theta < 12; ++theta) {
        const std::vector<std::string> changes{"width=2000", "height=1500", "camera.theta=" + std::to_string(theta)};
        auto frame = frames.frame(*s_frame, changes, wanted, {});
        ASSERT_TRUE(frame) << format(frame.errors());
        EXPECT_EQ(*frames.frame(*s_frame, changes, wanted, {}), *frame) << "the last one is kept";
        made.push_back(*frame);
        double kept = 0;
        for (const auto& one : made)
            if (const auto there = one.lock()) kept += frameBytes(there->scene(), there->wanted());
        EXPECT_LE(kept, kMostKeptBytes);
        all += frameBytes((*frame)->scene(), (*frame)->wanted());
    }
    EXPECT_GT(all, kMostKeptBytes) << "too few frames to tell";
}

// Those that are looked at through one another are there at once. Of 9000 × 9000 pixels with normal and position, at
// least 4 + 4 + 3 + 12 + 12 bytes each, one frame takes 2.6 GiB and two more than 4.
TEST_F(Expressions, FramesWithinOneAnotherAreRefusedWhereTheyTakeTooMuch) {
    ChangedFrames frames;
    pipeline::Scene large = s_scene;
    large.settings.width = large.settings.height = 4000;
    const std::vector<std::string> changes{"width=4000", "height=4000"};
    const auto wanted = pipeline::setOf({pipeline::BufferId::Normal, pipeline::BufferId::Position});
    const double bytes = frameBytes(large, wanted);
    ASSERT_LT(bytes, pipeline::kMemoryLimit);
    {
        const auto outer = frameOf(s_scene, pipeline::BufferSet());
        std::vector<std::unique_ptr<HeldFrame>> held;
        while (double(held.size()) * frameBytes(s_scene, {}) < pipeline::kMemoryLimit - bytes)
            held.push_back(std::make_unique<HeldFrame>(*outer));
        const auto refused = frames.frame(*s_frame, changes, wanted, {});
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.errors()[0].expected, "at most 4 GiB");
        EXPECT_TRUE(refused.errors()[0].found.starts_with("frames of with() within one another take"));
        while (!held.empty()) held.pop_back();
    }
    EXPECT_EQ(valueOf("with(width=300; with(height=200; setting(width) + setting(height)))"), "500");
}

TEST_F(Expressions, FindWhereAnExtremeIs) {
    EXPECT_EQ(valueOf("buffer(n_dot_l.0, at_largest(n_dot_l.0).x, at_largest(n_dot_l.0).y) = largest(n_dot_l.0)"),
              "true");
    EXPECT_EQ(valueOf("buffer(intensity, at_largest(intensity, b).x, at_largest(intensity, b).y, b) = "
                      "largest(intensity, b)"),
              "true");
}

TEST_F(Expressions, KnowWhatWasPickedWhereSomethingMayBe) {
    const Pick pick{.x = 268, .y = 281};
    const Scope scope{s_scene, nullptr, true};
    EXPECT_EQ(valueOf("pixel(pick.x, pick.y).polygon", scope, {.frame = *s_frame, .pick = &pick}), "2");
    EXPECT_EQ(valueOf("pick.vertex", scope, {.frame = *s_frame, .pick = &pick}),
              "f:1:1: nothing of this kind was picked\n");
    EXPECT_EQ(valueOf("pick.x"),
              "f:1:1: found \"pick\" where nothing is picked, expected it in a question that asks for a click\n");
    EXPECT_EQ(valueOf("pick.polgon", scope, {.frame = *s_frame}),
              "f:1:1: no pick.… \"polgon\"; the nearest is \"polygon\"\n");
}

TEST_F(Expressions, TakeNamesForOtherExpressions) {
    Names names;
    names.emplace("n", *parseExpression("buffer(normal, 268, 281)", {}, {s_scene}));
    const Scope scope{s_scene, &names};
    EXPECT_EQ(valueOf("n.x", scope, {.frame = *s_frame}), valueOf("buffer(normal, 268, 281, x)"));
    EXPECT_TRUE(parseExpression("n.y", {}, scope)->buffers[index(pipeline::BufferId::Normal)]);
    EXPECT_EQ(valueOf("m", scope, {.frame = *s_frame}).substr(0, 30), "f:1:1: no function or name \"m\"");
    EXPECT_NE(whyNoName("x"), "");
    EXPECT_NE(whyNoName("depth"), "");
    EXPECT_NE(whyNoName("n_dot_l"), "");
    EXPECT_NE(whyNoName("sqrt"), "");
    EXPECT_NE(whyNoName("2b"), "");
    EXPECT_EQ(whyNoName("half"), "");
    // A name of names of names: each is twice the one before, and it has to end.
    for (int i = 0; i < 40; ++i) {
        const std::string before = i == 0 ? "1" : "a" + std::to_string(i - 1);
        const auto doubled = parseExpression(before + " + " + before, {"f", 1, 1}, {s_scene, &names});
        if (!doubled) {
            EXPECT_NE(format(doubled.errors()).find("more than 500 operators"), std::string::npos);
            return;
        }
        names.insert_or_assign("a" + std::to_string(i), *doubled);
    }
    FAIL() << "2 to the 40th operators were kept";
}

// The same text means the same in a lesson's answer and at all pixels.
TEST_F(Expressions, CountWhatConditionsCount) {
    EXPECT_EQ(valueOf("pixels(n_dot_l.0 > 0.5 and x > 260)"), valueOf("pixels(n_dot_l > 0.5 && !(x <= 260))"));
    EXPECT_EQ(valueOf("count(polygon_id = 2)"), valueOf("pixels(polygon_id == 2)"));
    EXPECT_EQ(valueOf("count(vertices.world.z > 0)"), "1");  // the apex alone stands above the ground
    EXPECT_EQ(valueOf("count(n_dot_l.0 > largest(n_dot_l.0) - 1e-9) > 0"), "true");
    EXPECT_EQ(valueOf("count(1 > 0)"), "f:1:7: found no buffer, expected a comparison such as overdraw > 1\n");
    EXPECT_EQ(valueOf("count(depth < vertices.world.x)"),
              "f:1:15: depth and vertices.world have different elements, expected buffers of the same elements, as of "
              "pixels\n");
    EXPECT_EQ(valueOf("depth + 1").substr(0, 47), "f:1:1: found the buffer \"depth\" without a place");
}

TEST_F(Expressions, RefuseVeryLongTexts) {
    EXPECT_EQ(valueOf("1" + std::string(5000, ' ')),
              "f:1:1: found more than 4096 characters, expected a shorter formula\n");
}

TEST_F(Expressions, NameTheBuffersThatTheyRead) {
    const auto expression = parseExpression("buffer(depth, 0, 0) + count(overdraw > 1)", {}, {s_scene});
    ASSERT_TRUE(expression);
    EXPECT_EQ(expression->buffers, pipeline::setOf({pipeline::BufferId::Depth, pipeline::BufferId::Overdraw}));
}

}  // namespace
}  // namespace lessons
