// A student's functions in the pipeline, and what is said about them.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "pipeline/compare/own/own_blocks.h"
#include "pipeline/defects/own_judge.h"
#include "pipeline/formats/built_in_scenes.h"
#include "pipeline/formats/scene_reader.h"
#include "pipeline/inspect/own_calls.h"
#include "pipeline/run/frame_data.h"
#include "pipeline/run/runner.h"
#include "pipeline/scene/settings_table.h"
#include "tests/support/hashes.h"
#include "tests/support/scenes.h"

namespace {

using namespace pipeline;

// A built-in scene in 96 columns, with settings: "key=value key=value".
Scene sceneOf(std::string_view name, std::string_view settings) {
    for (const BuiltInScene& of : builtInScenes()) {
        if (of.name != name) continue;
        Scene scene = readScene(of.file).value();
        const double share = 96.0 / scene.settings.width;
        scene.settings.height = int(scene.settings.height * share), scene.settings.width = 96;
        scene.camera.pixelsPerUnit *= share;
        scene.settings.shadowSize = 64;
        std::istringstream words{std::string(settings)};
        for (std::string word; words >> word;) scene = withSetting(std::move(scene), word).value();
        return scene;
    }
    ADD_FAILURE() << name << " does not come with the program";
    return {};
}

struct Case {
    std::string_view scene, settings;
};
// Together they call every function.
constexpr Case kCases[]{
    {"pyramid", "object.0.rz=30 shading=phong"},
    {"two_pyramids", "precision=double depth_format=float shading=gouraud"},
    {"near_plane", ""},
    {"z_buffer_phong", "model=blinn-phong normal_weight=given"},
    {"point_light_shadow", "precision=double"},
    {"translucent", "shading=phong"},
};

OwnFrame callsIn(const Scene& scene, OwnFunction function) {
    return ownFrame(scene, function, std::make_shared<const OwnRecord>(), {});
}

std::vector<std::string> hashesOf(const Frame& frame) {
    std::vector<std::string> hashes;
    for (const AnyBuffer& buffer : frame.buffers())
        hashes.push_back(std::string(buffer.info->name) + ' ' + test::hashOf(buffer));
    return hashes;
}

// The frame with a function in the place of one of the pipeline's; null: none.
FramePtr frameWith(const Scene& scene, std::shared_ptr<const Own> own) {
    FrameRequest request{BufferSet().set(), StageId::Shading, 1, {}};
    request.own = std::move(own);
    return runFrame(std::make_shared<const Scene>(scene), request, nullptr);
}

std::shared_ptr<const Own> ownOf(OwnFunction function, double factor = 1) {
    return std::make_shared<const Own>(
        Own{function, [function, factor](OwnPlace, std::size_t, std::span<const double> in, std::span<double> out) {
                const OwnContract& contract = ownContract(function);
                const OwnValue right = valueOf(contract, contract.right, in);
                for (std::size_t i = 0; i < out.size(); ++i) out[i] = factor * right.at[i];
            }});
}

TEST(OwnFunctions, TheRightOnesKeepTheBitsOfEveryBuffer) {
    for (const Case& of : kCases) {
        Scene scene = sceneOf(of.scene, of.settings);
        scene.settings.leaveOut = false;  // as many buffers on both sides
        const std::vector<std::string> right = hashesOf(*frameWith(scene, nullptr));
        for (std::size_t i = 0; i < kOwnCount; ++i) {
            const OwnContract& contract = ownContract(OwnFunction(i));
            if (!contract.picture) continue;
            EXPECT_EQ(hashesOf(*frameWith(scene, ownOf(contract.id))), right) << contract.name << " in " << of.scene;
        }
    }
}

TEST(OwnFunctions, EachIsCalledInOneOfTheScenes) {
    std::array<std::size_t, kOwnCount> calls{};
    for (const Case& of : kCases)
        for (std::size_t i = 0; i < kOwnCount; ++i)
            calls[i] += callsIn(sceneOf(of.scene, of.settings), OwnFunction(i)).unknown.size();
    for (std::size_t i = 0; i < kOwnCount; ++i) EXPECT_GT(calls[i], 0U) << ownContract(OwnFunction(i)).name;
}

// A result that is right but for a rounding is not the right one to the last bit, so it is taken over: if the function were
// handed other arguments than the pipeline computes with, the picture would be another one.
TEST(OwnFunctions, TheArgumentsAreThoseThatThePipelineComputesWith) {
    for (const Case& of : kCases) {
        Scene scene = sceneOf(of.scene, of.settings);
        scene.settings.precision = Precision::Double;
        const FramePtr right = frameWith(scene, nullptr);
        const auto& expected = dataOf<double>(*right)->shading->color;
        for (std::size_t i = 0; i < kOwnCount; ++i) {
            const OwnContract& contract = ownContract(OwnFunction(i));
            const bool isWhole = contract.returns == OwnKind::Truth || contract.returns == OwnKind::Bytes ||
                                 contract.id == OwnFunction::Setpixel || contract.id == OwnFunction::ShadowFactor;
            if (!contract.picture || isWhole) continue;
            // 2^-40 of a pixel, a depth or a term: sums of a picture move by less than one of 255 but where a border, of a
            // polygon or a shadow, runs through a sample.
            const FramePtr mine = frameWith(scene, ownOf(contract.id, 1 + 0x1p-40));
            const auto& color = dataOf<double>(*mine)->shading->color;
            std::size_t apart = 0;
            for (std::size_t p = 0; p < color.pixels.size(); ++p)
                for (int c = 0; c < 3; ++c) apart += std::abs(int(color.pixels[p][c]) - int(expected.pixels[p][c])) > 1;
            EXPECT_LE(apart, color.pixels.size() / 100) << contract.name << " in " << of.scene;
        }
    }
}

TEST(OwnFunctions, AWrongOneChangesWhatFollows) {
    const Scene scene = sceneOf("pyramid", "object.0.rz=30 shading=phong");
    const FramePtr right = frameWith(scene, nullptr);
    for (const OwnFunction function : {OwnFunction::Place, OwnFunction::CalcNormal, OwnFunction::DepthAt,
                                       OwnFunction::Lambert, OwnFunction::FrameBuffer, OwnFunction::IMax}) {
        const FramePtr mine = frameWith(scene, ownOf(function, 0.5));
        EXPECT_NE(hashesOf(*mine), hashesOf(*right)) << ownContract(function).name;
    }
}

// With an edge left out a triangle covers more.
TEST(OwnFunctions, WrongCoverageIsDrawn) {
    const Scene scene = sceneOf("pyramid", "");
    const OwnContract& contract = ownContract(OwnFunction::IsInside);
    const OwnFrame right = callsIn(scene, contract.id);
    const auto record = std::make_shared<OwnRecord>();
    for (const OwnElement& one : right.unknown)
        record->add(one, valueOf(contract, contract.mistakes[0].formula, one.in));
    const OwnFrame wrong = ownFrame(scene, contract.id, record, {});
    EXPECT_TRUE(wrong.unknown.empty());
    const auto covered = [](const OwnFrame& of) {
        const auto& id = dataOf<double>(*of.frame)->zBuffer->triangle->pixels;
        return id.size() - std::size_t(std::ranges::count(id, kNoTriangle));
    };
    EXPECT_GT(covered(wrong), covered(right));
}

// Read from tests/unit/defects/own_answers.txt, whose results no code of the program has made.
struct Answers {
    const OwnContract* contract = nullptr;
    std::vector<std::string> mistakes;
    std::vector<OwnElement> elements;
    std::array<OwnResults, 4> results;  // of the right answer and the three wrong ones
};

std::vector<double> numbersIn(const std::string& text) {
    std::vector<double> numbers;
    std::istringstream words(text);
    for (std::string word; words >> word;) numbers.push_back(std::strtod(word.c_str(), nullptr));
    return numbers;
}

std::vector<Answers> readAnswers() {
    std::vector<Answers> all;
    std::ifstream file(OWN_ANSWERS);
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with('#')) continue;
        std::istringstream header(line);
        std::string name, mistake;
        int rows = 0;
        header >> name >> rows;
        Answers answers;
        answers.contract = &ownContract(*findOwn(name));
        while (header >> mistake) answers.mistakes.push_back(mistake);
        for (int row = 0; row < rows; ++row) {
            std::getline(file, line);
            std::istringstream parts(line);
            std::string part;
            std::getline(parts, part, '|');
            OwnElement element;
            element.in = numbersIn(part);
            element.right = valueOf(*answers.contract, answers.contract->right, element.in);
            answers.elements.push_back(element);
            for (OwnResults& results : answers.results) {
                std::getline(parts, part, '|');
                OwnValue value;
                std::ranges::copy(numbersIn(part), value.at.begin());
                results.push_back(value);
            }
        }
        all.push_back(std::move(answers));
    }
    return all;
}

TEST(OwnJudge, AgreesWithTheRightAnswersOfAnotherLanguage) {
    const std::vector<Answers> all = readAnswers();
    EXPECT_EQ(all.size(), kOwnCount);
    for (const Answers& of : all)
        EXPECT_EQ(judgeOwn(*of.contract, of.elements, of.results[0]).wrong, 0U) << of.contract->name;
}

TEST(OwnJudge, NamesEachOfThe108WrongAnswersAlone) {
    for (const Answers& of : readAnswers()) {
        ASSERT_EQ(of.mistakes.size(), 3U);
        for (std::size_t k = 0; k < 3; ++k) {
            const OwnVerdict verdict = judgeOwn(*of.contract, of.elements, of.results[k + 1]);
            EXPECT_GT(verdict.wrong, 0U) << of.contract->name << ' ' << of.mistakes[k];
            ASSERT_EQ(verdict.names.size(), 1U) << of.contract->name << ' ' << of.mistakes[k];
            EXPECT_EQ(verdict.names[0]->id, of.mistakes[k]) << of.contract->name;
        }
    }
}

// N·L = 1/2 and −1/2: k_d I N·L = 50, and 0 on the far side.
const OwnContract& lambert() { return ownContract(OwnFunction::Lambert); }
std::vector<OwnElement> twoSides() {
    std::vector<OwnElement> elements;
    for (const double side : {1.0, -1.0})
        elements.push_back({OwnPlace::Unknown, 0, {1, 1, 1, 100, 100, 100, 0, 0, side, 0.6, 0, 0.5}, {}});
    elements[0].right = Vec3d(50);
    return elements;
}

TEST(OwnJudge, CountsWhatDiffersAndGivesTheFirst) {
    const OwnVerdict verdict = judgeOwn(lambert(), twoSides(), {OwnValue(Vec3d(50)), OwnValue(Vec3d(-50))});
    EXPECT_EQ(verdict.wrong, 1U);
    EXPECT_EQ(verdict.first, 1U);
    ASSERT_EQ(verdict.names.size(), 1U);
    EXPECT_EQ(verdict.names[0]->id, "no-max");
}

TEST(OwnJudge, NamesNothingThatItDoesNotExplain) {
    const OwnVerdict verdict = judgeOwn(lambert(), twoSides(), {OwnValue(Vec3d(10)), OwnValue(Vec3d(20))});
    EXPECT_EQ(verdict.wrong, 2U);
    EXPECT_TRUE(verdict.names.empty());
}

TEST(OwnJudge, NamesAllThatExplainEquallyWell) {
    // On the lit side alone an absolute value cannot be told from a term without max, and both are right there. Without k_d
    // (0.5 here) the term is 100 · 0.5.
    std::vector<OwnElement> elements{{OwnPlace::Unknown, 0, {1, 1, 1, 100, 100, 100, 0, 0, -1, 0.6, 0, 0.5}, Vec3d(0)}};
    EXPECT_EQ(judgeOwn(lambert(), elements, {OwnValue(Vec3d(50))}).names[0]->id, "abs");
    // Two panes of one depth and opacity: no order can be told from another.
    const OwnContract& layers = ownContract(OwnFunction::BlendLayers);
    OwnElement two{OwnPlace::Unknown, 0, {2, 3, 5, 2, 0.5, 0.5, 2, 100, 0, 0, 0, 100, 0, 0, 0, 0}, {}};
    two.right = valueOf(layers, layers.right, two.in);  // the farther one, (0, 100, 0), first: (50, 25, 0)
    EXPECT_EQ(two.right.at, (std::array<double, 3>{50, 25, 0}));
    const OwnVerdict verdict = judgeOwn(layers, {two}, {OwnValue(Vec3d(25, 50, 0))});
    EXPECT_EQ(verdict.names.size(), 2U);  // in the order of the file, and from the nearest
}

TEST(OwnJudge, AResultThatIsNoNumberDiffers) {
    EXPECT_EQ(judgeOwn(lambert(), twoSides(), {std::nullopt, OwnValue(Vec3d(0))}).first, 0U);
}

TEST(OwnBlocks, HandOverEveryNumberAndReadResultsBack) {
    const OwnContract& contract = ownContract(OwnFunction::VertexNormal);
    const std::vector<OwnElement> elements{{OwnPlace::Vertex, 0, {2, 1, 0, 0, 0, 0.1, 0}, {}}};
    EXPECT_EQ(foreign::callsText(contract, elements), "vertexNormal 1 0\n2 1 0 0 0 0.1 0\n");
    const auto results = foreign::readResults(contract, 2, "vertexNormal 2 3\n1 2 3\n4 nan 6\n");
    ASSERT_TRUE(results);
    EXPECT_EQ((*results)[0]->at, (std::array<double, 3>{1, 2, 3}));
    EXPECT_FALSE((*results)[1]);
}

TEST(OwnBlocks, RefuseWhatIsNotTheBlockThatWasAskedFor) {
    const OwnContract& contract = ownContract(OwnFunction::VertexNormal);
    for (const char* text : {"", "vertexNormal", "normals 1 3 0 0 1", "vertexNormal 2 3 0 0 1", "vertexNormal 1 2 0 0",
                             "vertexNormal 1 3 0 0", "vertexNormal 1 3 0 0 x", "vertexNormal 1 3 0 0 1 1",
                             "vertexNormal 1e30 3 0 0 1", "vertexNormal -1 3"})
        EXPECT_FALSE(foreign::readResults(contract, 1, text)) << text;
}

}  // namespace
