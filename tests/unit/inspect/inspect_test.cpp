// What `inspect` and the inspector say about a pixel.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "pipeline/inspect/equation_text.h"
#include "pipeline/inspect/pixel_report.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

std::string lines(const Frame& frame, glm::ivec2 pixel, int channel) {
    std::string text = "\n";
    for (const EquationLine& line : equation(frame.scene(), inspectPixel(frame, pixel), channel))
        text += toText(line.formula) + (line.remark.empty() ? "" : " | " + line.remark) + "\n";
    return text;
}

// Its fragments, the culled polygons there and what stands before a light are looked for among all triangles.
TEST(Inspect, WhatIsStoppedIsLeftUnfinished) {
    const FramePtr frame = test::frameOf(test::pyramid());
    std::stop_source stop;
    EXPECT_TRUE(inspectPixel(*frame, {268, 281}, stop.get_token()).covered);
    stop.request_stop();
    const PixelReport report = inspectPixel(*frame, {268, 281}, stop.get_token());
    EXPECT_FALSE(report.covered);
    EXPECT_TRUE(report.fragments.empty());
    EXPECT_TRUE(report.culled.empty());
}

// The numbers are derived in tests/reference/lecture1_pyramid_test.cpp.
TEST(Equation, OfThePyramidsRightFace) {
    EXPECT_EQ(lines(*test::frameOf(test::pyramid()), {268, 281}, 2), R"(
I_b = k_b I_a + S_0 I_0 [ k_b (N·L) + k_s (R·V)^n ] | Flat: evaluated once, at the mean of the vertices (335, 125, 50)
= 0.9·50 + 1·100 [ 0.9·0.7746 + 0.4·0.3974^8 ]
= 45.000 + 69.714 + 0.025 = 114.739
FB_b = round(255·I_b/I_max) = round(255·114.739/175) = 167
N·L = (0, 0.894, 0.447)·(0.577, 0.577, 0.577) = 0.7746 | 39.2°
R = 2 (N·L) N − L = (−0.577, 0.808, 0.115)
R·V = (−0.577, 0.808, 0.115)·(0.386, 0.678, 0.626) = 0.3974 | 66.6°
)");
}

// 400 to the left of where the lecture has it: x = 335 − 400, written with the minus sign of the lines above.
TEST(Equation, SaysWhereWithATrueMinusSign) {
    Scene scene = test::pyramid();
    scene.objects[0].transform.translation.x -= 400;
    const FramePtr frame = test::frameOf(scene);
    const AnyBuffer ids = *frame->buffer({BufferId::PolygonId});
    for (std::size_t i = 0; i < ids.count(); ++i) {
        if (ids.flat(i) != 2) continue;
        const glm::ivec2 pixel(int(i % ids.columns()), int(i / ids.columns()));
        const std::string text =
            equationText(equation(frame->scene(), inspectPixel(*frame, pixel), 2), EquationFormat::Text);
        EXPECT_NE(text.find("the mean of the vertices (−65, 125, 50)"), std::string::npos) << text;
        return;
    }
    FAIL() << "polygon 2 is not seen";
}

// As a page sets it: aligned at the first equals sign, words in \text, one line break between lines.
TEST(Equation, AsLatexAndMarkdown) {
    const FramePtr frame = test::frameOf(test::pyramid());
    const auto lines = equation(frame->scene(), inspectPixel(*frame, {268, 281}), 2);
    const std::string latex = equationText(lines, EquationFormat::Latex);
    EXPECT_TRUE(latex.starts_with("% \\usepackage{amsmath, cancel}\n\\begin{align*}\nI_{\\text{b}} &= ")) << latex;
    EXPECT_TRUE(latex.ends_with("\n\\end{align*}\n"));
    EXPECT_NE(latex.find("\n&= 45.000 + 69.714 + 0.025 = 114.739 \\\\\n"), std::string::npos) << latex;
    EXPECT_NE(latex.find("&\\text{Flat: evaluated once, at the mean of the vertices (335, 125, 50)} \\\\"),
              std::string::npos);
    EXPECT_NE(latex.find("0.7746\\quad \\text{39.2$^{\\circ}$}"), std::string::npos) << latex;
    const std::string markdown = equationText(lines, EquationFormat::Markdown);
    EXPECT_TRUE(markdown.starts_with("$$\n\\begin{aligned}\n"));
    EXPECT_TRUE(markdown.ends_with("\n\\end{aligned}\n$$\n"));
    EXPECT_EQ(equationText({}, EquationFormat::Latex), "");
}

// What was computed is written as a person has chosen, typeset and copied alike; k, I and n are the scene's.
TEST(Equation, IsWrittenAsChosenButForWhatTheSceneSays) {
    const FramePtr frame = test::frameOf(test::pyramid());
    const auto inForm = [&](const NumberText& chosen) {
        return equation(frame->scene(), inspectPixel(*frame, {268, 281}), 2, chosen);
    };
    const auto scientific = inForm([](double value) -> std::optional<std::string> {
        const int power = value == 0 ? 0 : int(std::floor(std::log10(std::abs(value))));
        return fmt::format("{:.2f}e{}", value / std::pow(10, power), power);
    });
    EXPECT_EQ(toText(scientific[1].formula), "= 0.9·50 + 1·100 [ 0.9·7.75·10^−1 + 0.4·(3.97·10^−1)^8 ]");
    EXPECT_EQ(toText(scientific[2].formula), "= 4.50·10^1 + 6.97·10^1 + 2.49·10^−2 = 1.15·10^2");
    EXPECT_EQ(toLatex(scientific[2].formula),
              "= 4.50\\cdot 10^{1} + 6.97\\cdot 10^{1} + 2.49\\cdot 10^{-2} = "
              "1.15\\cdot 10^{2}");
    EXPECT_NE(toLatex(scientific[1].formula).find("{( 3.97\\cdot 10^{-1} )}^{8}"), std::string::npos);
    // 45 = 0x1.68p+5
    const auto bits = inForm([](double value) -> std::optional<std::string> { return fmt::format("{:a}", value); });
    EXPECT_NE(toText(bits[1].formula).find("0.4·(0x1.96"), std::string::npos) << toText(bits[1].formula);
    EXPECT_TRUE(toText(bits[2].formula).starts_with("= 0x1.68p+5 + ")) << toText(bits[2].formula);
    EXPECT_TRUE(toLatex(bits[2].formula).starts_with("= \\texttt{0x1.68p+5} + ")) << toLatex(bits[2].formula);
    EXPECT_EQ(latexWords("was 4.50·10^1, 2.49·10^−2"), "was 4.50$\\cdot 10^{1}$, 2.49$\\cdot 10^{-2}$");
}

TEST(Equation, WordsForLatexKeepWhatPlainTextHas) {
    EXPECT_EQ(latexWords("light 0, 50 % {a_b}"), "light 0, 50 \\% \\{a\\_b\\}");
    EXPECT_EQ(latexWords("N·L ≤ 0"), "N$\\cdot$L $\\le$ 0");
}

// Below the box every point is in the shadow of the box (polygons 6 to 11, after the ground's): of its top, face 1, which
// is nearest to the light straight above; of its bottom, face 0, where the shadow buffer leaves out what faces the light,
// and of the top again where it leaves out what faces away. A constant bias of 0 in a coarse buffer shadows what
// nothing stands before.
TEST(Equation, NamesThePolygonThatCastsTheShadow) {
    Scene scene = test::boxOverGround();
    const auto notes = [](const Scene& of) {
        const FramePtr frame = test::frameOf(of);
        std::map<std::string, int> counts;
        for (int y = 0; y < of.settings.height; ++y)
            for (int x = 0; x < of.settings.width; ++x)
                for (const Evaluation& e : inspectPixel(*frame, {x, y}).evaluations)
                    if (e.lights[0].shadow == 0 && e.lights[0].nDotL > 0) ++counts[e.lights[0].note];
        return counts;
    };
    const auto countOf = [](const std::map<std::string, int>& counts, const char* from, const char* to) {
        int found = 0;
        for (const auto& [note, count] : counts)
            if (note.starts_with(from) && note.find(to) != std::string::npos) found += count;
        return found;
    };
    for (const auto& [cull, polygon] :
         {std::pair{ShadowCull::None, 7}, {ShadowCull::Front, 6}, {ShadowCull::Back, 7}}) {
        scene.settings.shadowCull = cull;
        const std::string from = fmt::format(
            "In the shadow of polygon {} of box, before light 0: only the ambient term counts (z' ", polygon);
        EXPECT_GT(countOf(notes(scene), from.c_str(), " > Z'["), 50) << int(cull);
    }
    scene.settings.shadowCull = ShadowCull::None;
    scene.lights[0].position = {1, -0.5, 1};
    scene.settings.shadowSize = 64;
    scene.settings.shadowBias = ShadowBias::Constant;
    EXPECT_GT(countOf(notes(scene), "The shadow buffer of light 0 is wrong here: no polygon stands before it (z' ",
                      "): acne."),
              50);
}

// Back faces the eye and turns away from the light: N·L = -0.0429, so the bracket counts as 0.
TEST(Equation, StrikesWhatAClampRemoves) {
    const FramePtr frame = test::frameOf(test::pyramid());
    const AnyBuffer ids = *frame->buffer({BufferId::PolygonId});
    glm::ivec2 back{-1};
    for (std::size_t y = 0; y < 480 && back.x < 0; ++y)
        for (std::size_t x = 0; x < 640; ++x)
            if (ids.value(x, y) == 3) back = {int(x), int(y)};
    ASSERT_GE(back.x, 0);
    const std::string text = lines(*frame, back, 0);
    EXPECT_NE(text.find("[ 0.2·~−0.0429~ 0 + 0.4·"), std::string::npos) << text;
    EXPECT_NE(text.find("= 10.000 + 0.000 + 0.000 = 10.000"), std::string::npos) << text;
    EXPECT_NE(text.find("N·L is not above 0, so light 0 adds nothing here."), std::string::npos) << text;
}

TEST(Equation, OfGouraudWeighsThreeVertices) {
    Scene scene = test::pyramid();
    scene.settings.shading = Shading::Gouraud;
    const FramePtr frame = test::frameOf(scene);
    const PixelReport report = inspectPixel(*frame, {268, 281});
    ASSERT_EQ(report.evaluations.size(), 3u);
    double weights = 0, sum = 0;
    for (const Evaluation& e : report.evaluations) weights += e.weight, sum += e.weight * e.intensity.b;
    EXPECT_NEAR(weights, 1, 1e-6);
    EXPECT_NEAR(sum, report.intensity.b, 1e-4);
    EXPECT_NE(lines(*frame, {268, 281}, 2).find("I_b = λ_0 I_2 + λ_1 I_3 + λ_2 I_4"), std::string::npos);
}

TEST(PixelReport, TellsWhatCullingDroppedAtThePixel) {
    const PixelReport report = inspectPixel(*test::frameOf(test::pyramid()), {268, 281});
    ASSERT_EQ(report.culled.size(), 1u);  // Base lies behind Right
    EXPECT_EQ(report.culled[0].polygon, 4);
    EXPECT_EQ(report.culled[0].letter, 'B');
    EXPECT_EQ(report.culled[0].reason.substr(0, 32), "back-facing, signed area −1991");
}

TEST(PixelReport, OfTheBackgroundIsEmpty) {
    const FramePtr frame = test::frameOf(test::pyramid());
    const PixelReport report = inspectPixel(*frame, {0, 0});
    EXPECT_FALSE(report.covered);
    EXPECT_TRUE(report.fragments.empty());
    EXPECT_TRUE(equation(frame->scene(), report, 0).empty());
    EXPECT_NE(toText(*frame, report).find("background"), std::string::npos);
}

// The report replays the stages: what it says is what the frame holds, at every pixel and for every shading.
TEST(PixelReport, HasNoStoredDepthWhereThePainterStoresNone) {
    Scene scene = test::pyramid();
    scene.settings.visibility = Visibility::Painter, scene.settings.depthFormat = DepthFormat::Reversed;
    const FramePtr frame = test::frameOf(scene);
    const PixelReport report = inspectPixel(*frame, {268, 281});
    ASSERT_TRUE(report.covered);
    EXPECT_EQ(report.depth, report.zView);
    EXPECT_EQ(toText(*frame, report).find("\n  depth "), std::string::npos);
}

TEST(PixelReport, CallsNothingLitByALightThatAddsNothing) {
    Scene scene = test::pyramid();
    for (const double intensity : {100.0, 0.0}) {
        scene.lights[0].intensity = intensity;
        const PixelReport report = inspectPixel(*test::frameOf(scene, setOf({BufferId::Color})), {268, 281});
        ASSERT_FALSE(report.fragments.empty());
        EXPECT_EQ(report.fragments.back().shadows,
                  std::vector<std::string>{intensity > 0 ? "light 0: lit, without a shadow buffer"
                                                         : "light 0: not looked for: the light adds nothing"});
        EXPECT_EQ(report.shadowPlaces,
                  std::vector<std::string>{intensity > 0 ? "lit" : "not looked for: the light adds nothing"});
    }
}

// 1.1 · 0.2 is 0.22000000000000003 in double.
TEST(PixelReport, AProductOfSettingsIsWrittenWithoutItsRounding) {
    Scene scene = test::pyramid();
    scene.lights[0].intensity = 1.1, scene.lights[0].color = Vec3d(0.2);
    const FramePtr frame = test::frameOf(scene);
    const std::string text = toText(*frame, inspectPixel(*frame, {268, 281}));
    EXPECT_NE(text.find("1·0.22 ["), std::string::npos) << text;
    EXPECT_EQ(text.find("0.2200000"), std::string::npos) << text;
}

// A light behind the pyramid: N·L is below 0 on every face that the viewer sees. That is no shadow, and S is no clamp.
TEST(PixelReport, ASurfaceThatFacesAwayFromALightIsTurnedAway) {
    for (const LightKind kind : {LightKind::AtInfinity, LightKind::Point, LightKind::Area}) {
        Scene scene = test::pyramid();
        scene.lights[0].kind = kind;
        scene.lights[0].position = {-4000, -4000, -4000};
        const FramePtr frame = test::frameOf(scene);
        const PixelReport report = inspectPixel(*frame, {268, 281});
        ASSERT_TRUE(report.covered);
        EXPECT_EQ(report.shadowPlaces, std::vector<std::string>{"turned away"});
        EXPECT_EQ(toText(*frame, report).find("umbra"), std::string::npos);
    }
}

TEST(PixelReport, AgreesWithTheFramesBuffers) {
    for (unsigned seed = 0; seed < 12; ++seed) {
        const Scene scene = test::randomScene(seed);
        const FramePtr frame = test::frameOf(scene);
        const AnyBuffer ids = *frame->buffer({BufferId::PolygonId}), depth = *frame->buffer({BufferId::Depth});
        const AnyBuffer intensity = *frame->buffer({BufferId::Intensity}), came = *frame->buffer({BufferId::Overdraw});
        for (int y = 0; y < scene.settings.height; y += 9) {
            for (int x = 0; x < scene.settings.width; x += 9) {
                const PixelReport r = inspectPixel(*frame, {x, y});
                const auto column = std::size_t(x), row = std::size_t(y);
                ASSERT_EQ(r.polygon, ids.value(column, row));
                ASSERT_EQ(double(r.fragments.size()), came.value(column, row));
                if (!r.covered) continue;
                // The report has what is stored; the buffer rounds it to float where it is exported so.
                const bool rounded = std::string_view(depth.dtype()) == "float32";
                ASSERT_EQ(rounded ? double(float(r.depth)) : r.depth, depth.value(column, row));
                Vec3d sum = r.emission + r.ambient;
                for (std::size_t k = 0; k < r.diffuse.size(); ++k) sum += r.diffuse[k] + r.specular[k];
                for (int c = 0; c < 3; ++c) {
                    ASSERT_EQ(r.composed[c], intensity.value(column, row, c));
                    ASSERT_NEAR(sum[c], r.intensity[c], 1e-4 * (1 + std::abs(sum[c]))) << seed << ' ' << x << ' ' << y;
                }
            }
        }
    }
}

// Computed where they are shown, in the arithmetic of the frame: bit for bit what the buffers hold.
TEST(PixelReport, ItsTermsAreThoseOfTheBuffers) {
    using enum BufferId;
    std::size_t compared = 0;
    for (unsigned seed = 0; seed < 40; ++seed) {
        Scene scene = test::randomScene(seed);
        scene.settings.precision = seed % 2 == 0 ? Precision::Float : Precision::Double;
        scene.settings.arithmetic = Arithmetic::Exact;
        if (scene.settings.visibility == Visibility::None) continue;
        const FramePtr frame = test::frameOf(scene, setOf({Ambient, Emission, Diffuse, Specular}));
        const glm::ivec2 size(scene.settings.width, scene.settings.height);
        for (int y = 0; y < size.y; y += 7)
            for (int x = 0; x < size.x; x += 7) {
                const PixelReport r = inspectPixel(*frame, {x, y});
                if (!r.covered) continue;
                const auto expectIs = [&](BufferName name, Vec3d term) {
                    for (int c = 0; c < 3; ++c)
                        ASSERT_EQ(frame->buffer(name)->value(std::size_t(x), std::size_t(y), c), term[c])
                            << name.text() << " of seed " << seed << " at " << x << ", " << y;
                };
                expectIs({Ambient}, r.ambient), expectIs({Emission}, r.emission);
                for (std::size_t k = 0; k < r.diffuse.size(); ++k)
                    expectIs({Diffuse, int(k)}, r.diffuse[k]), expectIs({Specular, int(k)}, r.specular[k]);
                if (HasFatalFailure()) return;
                ++compared;
            }
    }
    EXPECT_GT(compared, 500u);
}

// The record of comparisons explains the z-buffer: every "won" is nearer than what was stored, and the last one stays.
TEST(PixelReport, ItsFragmentsExplainTheWinner) {
    Scene scene = test::randomScene(7);
    scene.settings.depthFormat = DepthFormat::Linear;
    const FramePtr frame = test::frameOf(scene);
    for (int y = 0; y < scene.settings.height; y += 5) {
        for (int x = 0; x < scene.settings.width; x += 5) {
            const PixelReport r = inspectPixel(*frame, {x, y});
            double stored = std::numeric_limits<double>::infinity();
            int winner = -1;
            for (const FragmentReport& f : r.fragments) {
                ASSERT_EQ(f.stored, stored);
                ASSERT_EQ(f.verdict == FragmentVerdict::NotNearer, !(f.depth < stored));
                if (f.depth < stored) stored = f.depth, winner = f.polygon;
            }
            ASSERT_EQ(winner, r.polygon);
        }
    }
}

// Whatever the model: the evaluation that the report shows sums to what the frame holds, also where
// OpenGL clamps a colour, and the equation speaks of the vector that the model uses.
TEST(PixelReport, OfEveryModelSumsUp) {
    for (Model model : {Model::Phong, Model::BlinnPhong, Model::OpenGl, Model::CookTorrance}) {
        for (double intensity : {0.4, 3.0}) {
            Scene scene = test::pyramid();
            scene.settings.model = model, scene.settings.precision = Precision::Double;
            scene.lights[0].intensity = intensity, scene.ambient.intensity = 0.5;
            scene.lights[0].gl.ambient = Vec3d(0.1);
            scene.objects[0].material.emission = Vec3d(0.125);
            const FramePtr frame = test::frameOf(scene);
            const PixelReport report = inspectPixel(*frame, {268, 281});
            ASSERT_TRUE(report.covered);
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(report.evaluations[0].intensity[c], report.intensity[c], 1e-14) << int(model);
            std::string symbols;
            for (const EquationLine& line : equation(frame->scene(), report, 0)) symbols += toText(line.formula) + '\n';
            EXPECT_EQ(symbols.find("H") != std::string::npos, model != Model::Phong) << symbols;
            EXPECT_EQ(symbols.find("k_e") != std::string::npos, model == Model::OpenGl) << symbols;
        }
    }
}

// Behind N·L <= 0 OpenGL's light still adds its ambient part, attenuated like the others.
TEST(PixelReport, ALightBehindASurfaceAddsItsAmbientPartInOpenGl) {
    Scene scene = test::pyramid();
    scene.settings.model = Model::OpenGl;
    scene.lights[0].position = -scene.lights[0].position;
    for (const double ambient : {0.0, 0.1}) {
        scene.lights[0].gl.ambient = Vec3d(ambient);
        const std::string note = inspectPixel(*test::frameOf(scene), {268, 281}).evaluations[0].lights[0].note;
        EXPECT_EQ(note, fmt::format("N·L is not above 0, so light 0 adds {} here.",
                                    ambient == 0 ? "nothing" : "only its ambient part"));
    }
}

// A square in the far plane, whose reversed depth is 0, that of the cleared buffer: nothing was there, and it is drawn.
TEST(PixelReport, WhatIsAsFarAsTheClearedBufferEqualsIt) {
    Scene scene;
    scene.settings.width = scene.settings.height = 16;
    scene.settings.depthFormat = DepthFormat::Reversed;
    scene.camera.kind = CameraKind::LookAt;
    scene.camera.eye = {0, 0, 8}, scene.camera.target = {0, 0, 0}, scene.camera.up = {0, 1, 0};
    scene.camera.near = 1, scene.camera.far = 8;
    scene.objects.push_back(
        {"wall", test::mesh({{-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0}}, {{0, 1, 2, 3}}), {}, {}});
    const PixelReport r = inspectPixel(*test::frameOf(scene), {8, 8});
    ASSERT_EQ(r.fragments.size(), 1u);
    EXPECT_EQ(r.fragments[0].verdict, FragmentVerdict::WonStays);
    EXPECT_EQ(r.fragments[0].depth, 0);
    EXPECT_EQ(r.fragments[0].relation, "=");
}

// H and N·H stand once, in the first channel that has a highlight; a pixel without equations has no headings.
TEST(PixelReport, TheTextShowsTheVectorsThatAnyChannelReads) {
    Scene scene = test::pyramid();
    scene.settings.model = Model::BlinnPhong;
    for (const Vec3d specular : {Vec3d(0.5), Vec3d(0, 0.5, 0), Vec3d(0)}) {
        scene.objects[0].material.specular = specular;
        const FramePtr frame = test::frameOf(scene);
        const std::string text = toText(*frame, inspectPixel(*frame, {268, 281}));
        const std::size_t row = text.find("N·H = ");
        EXPECT_EQ(row != std::string::npos, specular != Vec3d(0)) << text;
        EXPECT_EQ(row == std::string::npos ? row : text.find("N·H = ", row + 1), std::string::npos) << "once";
        EXPECT_NE(text.find("\nblue\n"), std::string::npos);
    }
    scene.settings.visibility = Visibility::None;
    const FramePtr outlines = test::frameOf(scene);
    EXPECT_EQ(toText(*outlines, inspectPixel(*outlines, {268, 281})).find("\nred\n"), std::string::npos);
}

}  // namespace
}  // namespace pipeline
