// The lectures' algorithms beside the steps: which line a step is at, and the values there.
#include "pipeline/steps/algorithm.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

#include "pipeline/inspect/pixel_report.h"
#include "pipeline/steps/steps.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

Moment momentAt(const Steps& steps, std::string_view place) { return steps.momentOf(*parsePlace(place)); }

const AlgorithmValue* valueOf(const AlgorithmState& state, std::string_view name) {
    const Visit& visit = state.walk.visits[*state.visit];
    const auto value = std::ranges::find(visit.values, name, &AlgorithmValue::name);
    return value == visit.values.end() ? nullptr : &*value;
}

Scene unculledPyramid() {
    Scene scene = test::pyramid();
    scene.settings.cull = CullMode::None;
    return scene;
}

// The depth of one polygon alone at a pixel: of a frame in which the others are not.
double depthAlone(const std::vector<std::uint32_t>& polygon, glm::ivec2 pixel) {
    Scene scene = unculledPyramid();
    scene.objects[0].mesh = test::mesh(scene.objects[0].mesh->positions, {polygon});
    return test::frameOf(scene)->buffer({BufferId::ZView})->value(std::size_t(pixel.x), std::size_t(pixel.y));
}

TEST(Algorithm, SetpixelComparesADepthWithWhatAnotherPolygonHasStored) {
    const Steps steps(test::frameOf(unculledPyramid()));
    const auto state = *steps.algorithmAt(momentAt(steps, "z-buffer/polygon=1/row=270/x=250/line=5"));
    EXPECT_EQ(state.walk.algorithm.lines[4].text, "if(z < zbuffer(x, y)) then");
    EXPECT_EQ(valueOf(state, "z")->numbers[0], depthAlone({1, 2, 4}, {250, 270}));
    EXPECT_EQ(valueOf(state, "zbuffer(x, y)")->numbers[0], depthAlone({0, 1, 4}, {250, 270}));
    EXPECT_EQ(state.walk.visits[*state.visit].taken, true);
    const AlgorithmRow row = rowsOf(state)[4];
    EXPECT_EQ(row.named, "z = 671.9340 < zbuffer(250, 270) = 742.3430");  // their first seven digits
    EXPECT_EQ(row.status, LineStatus::Now);
    EXPECT_EQ(rowsOf(state)[5].status, LineStatus::Next);
}

TEST(Algorithm, ABranchThatIsNotTakenPassesNoneOfItsLines) {
    const Steps steps(test::frameOf(unculledPyramid()));
    // The base, polygon 4, is drawn last and lies behind the faces that are turned to the eye.
    const Moment test = momentAt(steps, "z-buffer/polygon=4/row=290/x=247/line=5");
    const auto state = *steps.algorithmAt(test);
    EXPECT_EQ(state.walk.visits[*state.visit].taken, false);
    EXPECT_EQ(rowsOf(state)[5].status, LineStatus::NotTaken);
    EXPECT_EQ(steps.next(test, StepLevel::Line), (Moment{StageId::ZBuffer, test.done + 1}));
}

// Lines are about to write: buffers change at the end of the step, and only there.
TEST(Algorithm, BuffersAtALineAreThoseBeforeItsStepAndTheEndOfTheStepIsNext) {
    const Steps steps(test::frameOf(unculledPyramid()));
    const Moment writes = momentAt(steps, "z-buffer/polygon=1/row=270/x=250/line=6");
    const auto zAt = [&](Moment moment) { return steps.frameAt(moment)->buffer({BufferId::ZView})->value(250, 270); };
    const double before = depthAlone({0, 1, 4}, {250, 270}), after = depthAlone({1, 2, 4}, {250, 270});
    EXPECT_EQ(zAt(writes), before);
    const Moment end = *steps.next(writes, StepLevel::Line);
    EXPECT_EQ(end.line, 0);
    EXPECT_EQ(zAt(end), after);
    EXPECT_TRUE(steps.algorithmAt(end)->over);
    EXPECT_EQ(steps.algorithmAt(end)->visit, steps.algorithmAt(writes)->visit);
    EXPECT_EQ(steps.pixelOf(writes), glm::ivec2(250, 270));
    EXPECT_EQ(steps.words(writes, StepLevel::Line), "line 6, polygon 1, row 270, x 250");
}

TEST(Algorithm, ALineOfAPlaceIsFoundAgainAndOneThatTheStepDoesNotPassIsNotThere) {
    const Steps steps(test::frameOf(unculledPyramid()));
    const char* const place = "z-buffer/polygon=1/row=270/x=250/line=6";
    EXPECT_EQ(text(steps.placeOf(momentAt(steps, place))), place);
    EXPECT_TRUE(steps.comesTo(*parsePlace(place)));
    EXPECT_FALSE(steps.comesTo(*parsePlace("z-buffer/polygon=4/row=290/x=247/line=6")));
    EXPECT_FALSE(parsePlace("z-buffer/line=5"));
    EXPECT_FALSE(parsePlace("z-buffer/polygon=1/line=0"));
    EXPECT_FALSE(parsePlace("z-buffer/polygon=1/line=5/x=3"));
}

TEST(Algorithm, AFormatWhoseNearIsLargerComparesTheOtherWayRound) {
    Scene scene = unculledPyramid();
    scene.settings.depthFormat = DepthFormat::Reversed;
    const Steps steps(test::frameOf(scene));
    const auto state = *steps.algorithmAt(momentAt(steps, "z-buffer/polygon=1/row=270/x=250/line=5"));
    EXPECT_EQ(state.walk.algorithm.lines[0].text, "zbuffer(x, y) = 0 for all x, y");
    EXPECT_EQ(state.walk.algorithm.lines[4].text, "if(z > zbuffer(x, y)) then");
    EXPECT_GT(valueOf(state, "z")->numbers[0], valueOf(state, "zbuffer(x, y)")->numbers[0]);
}

// z-flip keeps the farther fragment and clears to 0: the nearer face, of which any depth is above 0, is stored first, and what
// is nearer than that is refused. Every sentence is true of its numbers, and says whose error it is.
TEST(Algorithm, WithAPlantedDefectTheComparisonThatWasMadeIsPrinted) {
    Scene scene = unculledPyramid();
    scene.settings.defect = Defect::ZFlip;
    const Steps steps(test::frameOf(scene));
    const auto row = [&](const char* place) { return rowsOf(*steps.algorithmAt(momentAt(steps, place)))[4]; };
    const AlgorithmRow first = row("z-buffer/polygon=0/row=270/x=250/line=5");
    EXPECT_EQ(first.valuesText, "742.3430 > 0.000000 (the error)");
    EXPECT_EQ(first.remark, "taken");
    const AlgorithmRow second = row("z-buffer/polygon=1/row=270/x=250/line=5");
    EXPECT_EQ(second.valuesText, "671.9340 > 742.3430 (the error)");
    EXPECT_EQ(second.remark, "not taken");
    const auto fragments = inspectPixel(*steps.frame(), {250, 270}).fragments;
    ASSERT_GE(fragments.size(), 2u);
    EXPECT_EQ(comparisonText(fragments[0]).whole(), "742.3430 > 0.000000 (the error)");
    EXPECT_EQ(comparisonText(fragments[1]).whole(), "671.9340 < 742.3430 (the error)");
}

// The signed area of a face that is turned away is below 0, and a right comparison says so without a word about errors.
TEST(Algorithm, AWrongSignOfCullingIsSaidOfTheAreaThatItDecidesAgainst) {
    Scene scene = test::pyramid();
    for (const Defect defect : {Defect::None, Defect::CullSign}) {
        scene.settings.defect = defect;
        const Steps steps(test::frameOf(scene));
        const AlgorithmRow row = rowsOf(*steps.algorithmAt(momentAt(steps, "cull/polygon=1/line=4")))[3];
        ASSERT_GT(row.values.front().numbers.front(), 0) << "Front is seen";
        const bool isPlanted = defect == Defect::CullSign;
        EXPECT_EQ(row.taken, isPlanted);
        EXPECT_EQ(row.valuesText.find(isPlanted ? " > 0 (the error)" : " < 0") != std::string::npos, true)
            << row.valuesText;
    }
}

TEST(Algorithm, OfAStageThatIsLeftOutTheLinesStandGreyWithThePlansReason) {
    Scene painted = test::pyramid();
    painted.settings.visibility = Visibility::Painter, painted.settings.split = false;
    const FramePtr frame = test::frameOf(painted, setOf({BufferId::Color}));
    const auto algorithm = algorithmOf(*frame, StageId::ZBuffer, ElementKind::Piece);
    ASSERT_TRUE(algorithm);
    EXPECT_EQ(algorithm->row->name, "painter");
    const AlgorithmState state{{*algorithm, {}, {}}, {}, false};
    EXPECT_EQ(state.leftOut(), std::vector<std::string>{"Line 2 is left out. Off in this scene: split = off."});
}

// The base is the square (200, 0, 0), (200, 150, 0), (470, 150, 0), (470, 0, 0): edges (0, 150, 0) and (270, 150, 0), then
// (270, 150, 0) and (270, 0, 0). Each product is (0, 0, −270 · 150), so that the sum is (0, 0, −81000).
TEST(Algorithm, TheSumOfCalcNormalGrowsByTheProductOfEachTriangle) {
    const Steps steps(test::frameOf(unculledPyramid()));
    const auto at = [&](const char* place) { return *steps.algorithmAt(momentAt(steps, place)); };
    const auto vector = [](const AlgorithmState& state, const char* name) { return valueOf(state, name)->numbers; };
    using V = std::vector<double>;
    EXPECT_EQ(vector(at("normals/polygon=4/line=4"), "a"), (V{0, 150, 0}));
    EXPECT_EQ(vector(at("normals/polygon=4/line=5/time=2"), "b"), (V{270, 0, 0}));
    for (const char* place : {"normals/polygon=4/line=6", "normals/polygon=4/line=6/time=2"})
        EXPECT_EQ(vector(at(place), "c"), (V{0, 0, -40500})) << place;
    EXPECT_EQ(vector(at("normals/polygon=4/line=7"), "n"), (V{0, 0, -40500}));
    const AlgorithmState sum = at("normals/polygon=4/line=7/time=2");
    EXPECT_EQ(vector(sum, "n"), (V{0, 0, -81000}));
    EXPECT_EQ(rowsOf(sum)[6].valuesText, "0.00, 0.00, −81000.00");
    EXPECT_EQ(vector(at("normals/polygon=4/line=9"), "n"), (V{0, 0, -1}));
}

// Of the face Front, v0 to v2 = (470, 0, 0), (470, 150, 0), (335, 75, 150), each form has the same area vector:
// (0, 150, 0) × (−135, 75, 150) = (22500, 0, 20250).
TEST(Algorithm, CalcNormalShowsTheProductInEveryForm) {
    for (const auto& [form, line] : {std::pair(PolygonNormalForm::Newell, "7"),
                                     {PolygonNormalForm::ThreeCorners, "4"},
                                     {PolygonNormalForm::FromOrigin, "5/time=3"}}) {
        Scene scene = unculledPyramid();
        scene.settings.forms.polygonNormal = form;
        const Steps steps(test::frameOf(scene));
        const auto state = *steps.algorithmAt(momentAt(steps, std::string("normals/polygon=1/line=") + line));
        const AlgorithmValue& value = state.walk.visits[*state.visit].values.front();
        EXPECT_EQ(value.numbers, (std::vector<double>{22500, 0, 20250})) << line;
    }
}

// Every row of the table, with the settings that choose its lines, has 5 to 15 of them.
TEST(Algorithm, EveryStageAndEveryAlternativeHasATextOfAFewLines) {
    using Change = void (*)(Scene&);
    constexpr std::array<std::array<Change, 3>, 5> kChoices{{
        {[](Scene& s) { s.settings.visibility = Visibility::ZBuffer; },
         [](Scene& s) { s.settings.visibility = Visibility::Painter; },
         [](Scene& s) { s.settings.visibility = Visibility::None; }},
        {[](Scene& s) { s.settings.shading = Shading::Flat; }, [](Scene& s) { s.settings.shading = Shading::Gouraud; },
         [](Scene& s) { s.settings.shading = Shading::Phong; }},
        {[](Scene& s) { s.settings.interpolation = Interpolation::Perspective; },
         [](Scene& s) { s.settings.interpolation = Interpolation::Affine; },
         [](Scene& s) { s.settings.interpolation = Interpolation::Scanline; }},
        {[](Scene& s) { s.settings.model = Model::Phong; }, [](Scene& s) { s.settings.model = Model::BlinnPhong; },
         [](Scene& s) { s.settings.model = Model::OpenGl; }},
        {[](Scene&) {}, [](Scene& s) { s.settings.cull = CullMode::None; },
         [](Scene& s) { s.settings.depthFormat = DepthFormat::Reversed; }},
    }};
    std::set<std::string_view> titles;
    const auto take = [&](const Scene& scene, int combination) {
        const FramePtr frame = test::frameOf(scene, setOf({BufferId::Color}));
        for (const StageId stage : kStages)
            for (const ElementKind kind :
                 {ElementKind::Vertex, ElementKind::Polygon, ElementKind::Piece, ElementKind::PolygonTerms,
                  ElementKind::VertexTerms, ElementKind::Layers, ElementKind::Samples}) {
                const auto algorithm = algorithmOf(*frame, stage, kind);
                if (!algorithm) continue;
                EXPECT_GE(algorithm->lines.size(), 5u) << algorithm->row->title;
                EXPECT_LE(algorithm->lines.size(), 15u) << algorithm->row->title << " " << combination;
                titles.insert(algorithm->row->title);
            }
    };
    for (int combination = 0; combination < 243; ++combination) {
        Scene scene = test::pyramid();
        scene.settings.width = scene.settings.height = 16;
        for (int i = 0, rest = combination; i < 5; ++i, rest /= 3)
            kChoices[std::size_t(i)][std::size_t(rest % 3)](scene);
        take(scene, combination);
    }
    for (const Shading shading : {Shading::Flat, Shading::Phong}) {
        Scene scene = test::pyramid();
        scene.settings.width = scene.settings.height = 16;
        scene.settings.model = Model::CookTorrance, scene.settings.shading = shading;
        take(scene, 243);
    }
    // Every model has lines of its own; those of others wait for the next one.
    const auto ofOthers = std::ranges::count_if(
        algorithmTable(), [](const AlgorithmText& text) { return text.when.find("other") != text.when.npos; });
    EXPECT_EQ(ofOthers, 2);
    EXPECT_EQ(titles.size() + std::size_t(ofOthers), algorithmTable().size());
}

TEST(Algorithm, ATitleNamesTheModelThatItsLinesCompute) {
    const auto titleOf = [](Model model, Shading shading, ElementKind kind) {
        Scene scene = test::pyramid();
        scene.settings.model = model, scene.settings.shading = shading;
        return algorithmOf(*test::frameOf(scene, setOf({BufferId::Color})), StageId::Shading, kind)->row->title;
    };
    for (const auto& [model, name] : {std::pair(Model::BlinnPhong, "Blinn-Phong"), std::pair(Model::OpenGl, "OpenGL"),
                                      std::pair(Model::CookTorrance, "Cook-Torrance")}) {
        EXPECT_NE(titleOf(model, Shading::Phong, ElementKind::Polygon).find(name), std::string_view::npos) << name;
        EXPECT_NE(titleOf(model, Shading::Flat, ElementKind::PolygonTerms).find(name), std::string_view::npos) << name;
    }
}

// The step that lays translucent surfaces over the picture goes over every pixel; its lines show one with most of them.
TEST(Algorithm, LayersAreShownAtAPixelThatHasMostOfThem) {
    Scene scene = test::spheres();
    scene.settings.cull = CullMode::None;
    for (Object& object : scene.objects) object.material.alpha = 0.5;
    const Steps steps(test::frameOf(scene, setOf({BufferId::Layers})));
    const auto state = *steps.algorithmAt(momentAt(steps, "shading"));
    const AlgorithmValue* at = nullptr;
    for (const Visit& visit : state.walk.visits)
        for (const AlgorithmValue& value : visit.values)
            if (value.name == "x, y") at = &value;
    ASSERT_NE(at, nullptr);
    const auto layers = *test::frameOf(scene, setOf({BufferId::Layers}))->buffer({BufferId::Layers});
    double most = 0;
    for (int y = 0; y < scene.settings.height; ++y)
        for (int x = 0; x < scene.settings.width; ++x)
            most = std::max(most, layers.value(std::size_t(x), std::size_t(y)));
    EXPECT_GT(most, 2);
    EXPECT_EQ(layers.value(std::size_t(at->numbers[0]), std::size_t(at->numbers[1])), most);
}

TEST(Algorithm, IsWrittenAsTextWithTheLineMarkedAndAsLatex) {
    const Steps steps(test::frameOf(unculledPyramid()));
    const auto state = *steps.algorithmAt(momentAt(steps, "z-buffer/polygon=1/row=270/x=250/line=5"));
    const std::string plain = algorithmText(state, AlgorithmFormat::Text);
    EXPECT_NE(plain.find("\n>  5      if(z < zbuffer(x, y)) then   z = 671.9340"), std::string::npos) << plain;
    const std::string latex = algorithmText(state, AlgorithmFormat::Latex);
    EXPECT_NE(latex.find("\\begin{tabular}{rll}\n"), std::string::npos) << latex;
    EXPECT_NE(latex.find("$\\infty$"), std::string::npos) << latex;
}

}  // namespace
}  // namespace pipeline
