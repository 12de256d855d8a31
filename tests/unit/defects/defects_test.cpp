// Planted defects: each shows where its row says, is wrong in everything alike, and leaves the right picture alone.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "pipeline/defects/defect_table.h"
#include "pipeline/formats/built_in_scenes.h"
#include "pipeline/formats/scene_reader.h"
#include "pipeline/inspect/compare.h"
#include "pipeline/inspect/pixel_report.h"
#include "pipeline/run/frame_data.h"
#include "pipeline/scene/settings_table.h"
#include "pipeline/steps/steps.h"
#include "tests/support/scenes.h"
#include "tests/support/sweep.h"

namespace {

using namespace pipeline;

// The scene of a row, with its settings. Nothing, and a failure, where it cannot be read.
std::optional<Scene> sceneOf(const DefectRow& row) {
    for (const BuiltInScene& of : builtInScenes()) {
        if (of.name != row.scene) continue;
        Result<Scene> scene = readScene(of.file);
        for (std::string_view rest = row.settings; scene && !rest.empty();) {
            const std::size_t end = std::min(rest.find(' '), rest.size());
            scene = withSetting(std::move(scene).value(), rest.substr(0, end));
            rest.remove_prefix(std::min(end + 1, rest.size()));
        }
        if (scene) return std::move(scene).value();
        ADD_FAILURE() << row.idText() << ": " << format(scene.errors());
        return std::nullopt;
    }
    ADD_FAILURE() << row.scene << " does not come with the program";
    return std::nullopt;
}

// In a picture a quarter as large, for what does not ask how much of it differs.
Scene small(Scene scene) {
    scene.camera.pixelsPerUnit *= 120.0 / scene.settings.height;
    scene.settings.width = 160, scene.settings.height = 120;
    scene.settings.shadowSize = std::min(scene.settings.shadowSize, 256);
    return scene;
}

FramePtr frameOf(Scene scene) {
    scene.settings.precision = Precision::Double;
    scene.settings.leaveOut = false;
    return test::frameOf(scene);
}

// Where a polygon is seen in one of two frames, and how many of these pixels differ by 8 of 255 in a colour.
struct Difference {
    int covered = 0, differing = 0;
    double share() const { return covered == 0 ? 0 : double(differing) / covered; }
};
Difference differenceOf(const Frame& a, const Frame& b) {
    Difference found;
    const FrameData<double>&left = *dataOf<double>(a), &right = *dataOf<double>(b);
    for (std::size_t i = 0; i < left.shading->color.pixels.size(); ++i) {
        if (left.zBuffer->triangle->pixels[i] == kNoTriangle && right.zBuffer->triangle->pixels[i] == kNoTriangle)
            continue;
        ++found.covered;
        const Color8 x = left.shading->color.pixels[i], y = right.shading->color.pixels[i];
        found.differing += std::max({std::abs(x.r - y.r), std::abs(x.g - y.g), std::abs(x.b - y.b)}) >= 8;
    }
    return found;
}

// The first buffer, in the order of the stages, in which two frames of a scene differ.
std::optional<BufferId> firstDiffering(const Frame& a, const Frame& b) {
    for (const BufferName& name : allBuffers(a.scene().lights.size())) {
        if (!a.buffer(name) || !b.buffer(name)) continue;
        const StageDifference difference = stageDifference(a, b, name);
        if (!difference.why.empty() || difference.differing > 0) return name.id;
    }
    return std::nullopt;
}

TEST(Defects, EachHasItsOwnIdAndAWholeRow) {
    std::set<std::string_view> ids;
    ASSERT_EQ(defectTable().size() + 1, kDefectCount);
    for (const DefectRow& row : defectTable()) {
        EXPECT_TRUE(ids.insert(row.idText()).second) << row.idText();
        EXPECT_EQ(&defectInfo(row.id), &row);
        EXPECT_EQ(findDefect(row.idText()), row.id);
        for (const std::string_view text :
             {row.name, row.symptom, row.givesAway, row.wrong, row.fix, row.scene, row.source})
            EXPECT_FALSE(text.empty()) << row.idText();
        EXPECT_EQ(row.lesson.empty(), row.heading.empty()) << row.idText();
    }
    EXPECT_FALSE(findDefect("none"));
    EXPECT_FALSE(findDefect("y_down"));
}

void expectToShow(const DefectRow& row, const Scene& scene, const Frame& right) {
    const FramePtr wrong = frameOf(plant(scene, row.id));
    const Difference seen = differenceOf(right, *wrong);
    EXPECT_EQ(seen.share() < 0.005, row.hidden)
        << row.idText() << ": " << seen.differing << " of " << seen.covered << " pixels";
    const std::optional<BufferId> first = firstDiffering(right, *wrong);
    ASSERT_TRUE(first) << row.idText() << " changes nothing";
    EXPECT_EQ(bufferInfo(*first).name, bufferInfo(row.first).name) << row.idText();
    testing::Test::RecordProperty(std::string(row.idText()), std::to_string(100 * seen.share()));
}

// The rule: 8 of 255 in half a percent of the pixels that show something in the right picture or the wrong one. And the
// first buffer that differs is the row's.
TEST(Defects, EachShowsInItsSceneFirstInTheBufferOfItsRow) {
    std::map<std::pair<std::string_view, std::string_view>, std::vector<const DefectRow*>> scenes;
    for (const DefectRow& row : defectTable()) scenes[{row.scene, row.settings}].push_back(&row);
    for (const auto& [_, rows] : scenes) {
        const std::optional<Scene> scene = sceneOf(*rows.front());
        if (!scene) continue;
        const FramePtr right = frameOf(*scene);
        for (const DefectRow* row : rows) expectToShow(*row, *scene, *right);
    }
}

// Nothing is wrong before the stage in which the line stands that is to be mended; a file has no stage.
TEST(Defects, ShowFirstInTheStageToBlame) {
    for (const DefectRow& row : defectTable())
        EXPECT_EQ(row.stage.value_or(bufferInfo(row.first).stage), bufferInfo(row.first).stage) << row.idText();
}

// The stage that the row blames, given what the wrong frame's stages before it have left, leaves something else than the
// wrong frame has; every other stage, given the same, leaves what it has.
TEST(Defects, OneStageAloneDoesNotDoWhatItShould) {
    for (const DefectRow& row : defectTable()) {
        const std::optional<Scene> scene = sceneOf(row);
        if (!scene) continue;
        const FramePtr wrong = test::frameOf(small(plant(*scene, row.id)));
        for (const StageId stage : kStages) {
            BufferSet ofStage;
            for (const BufferInfo& info : bufferTable()) ofStage[index(info.id)] = info.stage == stage;
            const std::string difference = test::firstDifference(*runAlone(wrong, stage), *wrong, ofStage);
            EXPECT_EQ(difference.empty(), row.stage != stage)
                << row.idText() << ", " << stageInfo(stage).name << ": " << difference;
        }
    }
}

TEST(Defects, EachOtherWayOfMakingOneIsAnotherPicture) {
    for (const DefectRow& row : defectTable()) {
        std::optional<Scene> scene = sceneOf(row);
        if (!scene || row.wayCount() == 1) continue;
        if (row.id == Defect::ZAffine)
            scene->settings.depthFormat = DepthFormat::Float;  // z_view is divided by nothing
        for (int way = 1; way < row.wayCount(); ++way) {
            const FramePtr other = frameOf(small(plant(*scene, row.id, way)));
            EXPECT_NE(test::firstDifference(*other, *frameOf(small(*scene))), "") << row.idText() << " " << way;
            EXPECT_NE(test::firstDifference(*other, *frameOf(small(plant(*scene, row.id, way - 1)))), "")
                << row.idText() << " " << way;
        }
    }
}

// In both precisions, whatever the scene: strange ones hold huge, negative and vanishing numbers.
TEST(Defects, LeaveNoNaNAndNoInfinityInABuffer) {
    for (const std::size_t i : test::sweep(20 * (kDefectCount - 1))) {
        const DefectRow& row = defectTable()[i % (kDefectCount - 1)];
        const auto seed = unsigned(i);
        Scene scene = i % 2 == 0 ? test::strangeScene(seed) : test::smallScene(seed);
        scene.settings.width = 48, scene.settings.height = 32;
        scene.settings.precision = i % 4 < 2 ? Precision::Float : Precision::Double;
        const int way = int(i / (kDefectCount - 1)) % row.wayCount();
        std::string without = test::buffersWithoutNumbers(*test::frameOf(plant(scene, row.id, way)));
        EXPECT_EQ(without, "") << row.idText() << " way " << way << ", scene " << seed;
    }
}

TEST(Defects, WithOneNoRuleActsAndNoKernelDraws) {
    const FramePtr frame = test::frameOf(plant(test::pyramid(), Defect::YDown), {});
    bool isSaid = false;
    for (const PlanStep& step : frame->plan()) {
        EXPECT_FALSE(step.rule);
        for (const PlanPart& part : step.parts) {
            EXPECT_FALSE(part.rule) << part.name;
            isSaid = isSaid || part.why == kDefectIsPlanted;
        }
    }
    EXPECT_TRUE(isSaid);
    EXPECT_FALSE(dataOf<float>(*frame)->keys.shading.parts[Part::ShadedInVectors]);
    EXPECT_EQ(dataOf<float>(*frame)->zBuffer->seen, nullptr);
}

// The frame after another is what it would be alone, and planting one again runs nothing.
TEST(Defects, AFrameAfterAnotherEqualsOneFromNothing) {
    Scene scene = small(*sceneOf(defectInfo(Defect::YDown)));
    FramePtr before;
    for (const DefectRow& row : defectTable()) {
        const Scene wrong = plant(scene, row.id);
        before = test::frameOf(wrong, test::everyBuffer(), 0, before);
        EXPECT_EQ(test::firstDifference(*before, *test::frameOf(wrong)), "") << row.idText();
        const FramePtr again = test::frameOf(wrong, test::everyBuffer(), 0, before);
        for (const PlanStep& step : again->plan())
            EXPECT_NE(step.action, Action::Run) << row.idText() << ": " << step.why;
    }
    EXPECT_EQ(test::firstDifference(*test::frameOf(scene, test::everyBuffer(), 0, before), *test::frameOf(scene)), "");
}

TEST(Defects, SteppingThroughAWrongFrameEndsInIt) {
    for (const DefectRow& row : defectTable()) {
        const std::optional<Scene> scene = sceneOf(row);
        if (!scene) continue;
        const FramePtr frame = test::frameOf(small(plant(*scene, row.id)));
        const Steps steps(frame);
        for (const StageId stage : kStages) {
            const FramePtr at = steps.frameAt({stage, steps.total(stage)});
            BufferSet upTo;
            for (const BufferInfo& info : bufferTable()) upTo[index(info.id)] = info.stage <= stage;
            EXPECT_EQ(test::firstDifference(*at, *frame, upTo), "") << row.idText() << ", " << stageInfo(stage).name;
        }
    }
}

// The ledger's last winner is the polygon that is seen, and the equation's terms are those of the buffers.
TEST(Defects, TheInspectorTellsTheWrongFrame) {
    for (const DefectRow& row : defectTable()) {
        const std::optional<Scene> scene = sceneOf(row);
        if (!scene) continue;
        const FramePtr frame = test::frameOf(small(plant(*scene, row.id)));
        const FrameData<float>* data = dataOf<float>(*frame);
        if (!data) continue;
        for (int y = 7; y < 120; y += 17) {
            for (int x = 5; x < 160; x += 23) {
                const PixelReport report = inspectPixel(*frame, {x, y});
                const std::size_t at = data->shading->color.offset({x, y});
                EXPECT_EQ(report.color, data->shading->color.pixels[at]) << row.idText();
                int last = -1;
                for (const FragmentReport& fragment : report.fragments)
                    if (fragment.verdict == FragmentVerdict::WonStays) last = fragment.polygon;
                EXPECT_EQ(last, report.polygon) << row.idText() << " at " << x << ", " << y;
                if (!report.covered) continue;
                const auto& shading = *data->shading;
                EXPECT_EQ(Vec3<float>(report.ambient), shading.vectors[index(BufferId::Ambient)][0].pixels[at])
                    << row.idText() << " at " << x << ", " << y;
                for (std::size_t k = 0; k < report.diffuse.size(); ++k) {
                    EXPECT_EQ(Vec3<float>(report.diffuse[k]), shading.vectors[index(BufferId::Diffuse)][k].pixels[at])
                        << row.idText() << " at " << x << ", " << y;
                    EXPECT_EQ(Vec3<float>(report.specular[k]), shading.vectors[index(BufferId::Specular)][k].pixels[at])
                        << row.idText() << " at " << x << ", " << y;
                }
            }
        }
    }
}

// Computed by hand, of the lecture's pyramid: vertex 4 stands at (335, 75, 150) with x scaled by 1.8 before the
// translation by 200; with the translation scaled too it is 1.8 · 200 farther than 135.
TEST(Defects, TrsOrderScalesTheTranslation) {
    const FramePtr frame = test::frameOf(plant(test::pyramid(), Defect::TrsOrder));
    const Vec3<float> p = dataOf<float>(*frame)->transform->world[4];
    EXPECT_EQ(p, Vec3<float>(75 * 1.8F + 200 * 1.8F, 75, 150));
}

// L of a light at (500, 500, 500) in the direction (1, 1, 1) / √3: N·L = √3 · 500 times the right one.
TEST(Defects, ARawLightVectorIsAsLongAsItsLight) {
    const FramePtr right = test::frameOf(test::pyramid());
    const FramePtr wrong = test::frameOf(plant(test::pyramid(), Defect::LRaw));
    const double a = inspectPixel(*right, {268, 281}).evaluations[0].lights[0].nDotL;
    const double b = inspectPixel(*wrong, {268, 281}).evaluations[0].lights[0].nDotL;
    EXPECT_NEAR(b / a, 500 * std::sqrt(3.0), 1e-3);
}

}  // namespace
