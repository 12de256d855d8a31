// What must hold of the stages' output holds, in every scene that comes with the program; and each contract notices when it
// does not.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "pipeline/contracts/contract.h"
#include "pipeline/export/json/contracts_json.h"
#include "pipeline/formats/built_in_scenes.h"
#include "pipeline/formats/scene_reader.h"
#include "tests/support/scenes.h"
#include "tests/support/sweep.h"

namespace pipeline {
namespace {

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

std::string violations(const FramePtr& frame) {
    const ContractInput input = contractInput(*frame);
    std::string text;
    for (const ContractResult& result : checkContracts(input))
        if (!result.holds()) text += result.name() + ": " + contractWorst(result, input) + "\n";
    return text;
}

class BuiltIn : public testing::TestWithParam<BuiltInScene> {};

TEST_P(BuiltIn, HoldsAllContractsInFloatAndDouble) {
    Scene scene = readScene(GetParam().file).value();
    if (!test::longRun()) scene.settings.width /= 4, scene.settings.height /= 4;
    for (const Precision precision : {Precision::Float, Precision::Double}) {
        scene.settings.precision = precision;
        EXPECT_EQ(violations(test::frameOf(scene, contractBuffers())), "") << int(precision);
    }
}

INSTANTIATE_TEST_SUITE_P(Contracts, BuiltIn, testing::ValuesIn(builtInScenes()),
                         [](const auto& scene) { return scene.param.name; });

// Of scenes that nobody chose: planes that cut, tiny and huge objects, lights inside, all models and shadings.
TEST(Contracts, HoldInRandomScenes) {
    for (const std::size_t seed : test::sweep(500)) {
        Scene scene = test::smallScene(unsigned(seed));
        scene.settings.forms = {};
        EXPECT_EQ(violations(test::frameOf(scene, contractBuffers())), "") << "seed " << seed;
    }
}

// Numbers of whoever made them.
ContractBuffer numbersOf(const BufferName& name, std::vector<std::size_t> shape, std::vector<double> values,
                         double rounding) {
    const auto kept = std::make_shared<const std::vector<double>>(std::move(values));
    return {{name, &bufferInfo(name.id), std::move(shape), std::span<const double>(*kept), kept}, rounding};
}

TEST(Contracts, CountAndPlaceWhatAForeignRendererGives) {
    Scene scene = test::pyramid();
    scene.settings.width = 2, scene.settings.height = 2;
    const Topology topology = makeTopology(meshesOf(scene));
    // (0.48, 0.6, 0.64) has length 1; the third is 0.5 long; nothing was drawn in the last.
    ContractInput input{scene, topology, {}};
    input.buffers.push_back(
        numbersOf({BufferId::Normal}, {2, 2, 3}, {0, 0, 1, 0.48, 0.6, 0.64, 0.3, 0.4, 0, 0, 0, 0}, 0x1p-53));
    const ContractResult result = checkContract(*findContract("unit-normals"), input);
    EXPECT_EQ(result.why, "");
    EXPECT_EQ(result.checked, 3u);
    EXPECT_EQ(result.hold, 2u);
    ASSERT_TRUE(result.worst);
    EXPECT_EQ(result.worst->element, 2u);
    EXPECT_DOUBLE_EQ(result.worst->finding.value, 0.5);
    EXPECT_DOUBLE_EQ(result.worst->finding.error, 0.5);
    EXPECT_EQ(contractPlace(result, input, 2), "pixel 0, 1");
    EXPECT_EQ(result.violators, (std::vector<bool>{false, false, true, false}));
    // What the contract reads beside is not there.
    EXPECT_EQ(checkContract(*findContract("n-dot-l"), input, 0).why, "n_dot_l.0 is not there.");
}

// A direction in 8 bits, x = 2 b / 255 − 1, is off by up to 1/255 in each component, so that its length is by √3/255 at
// most: with this rounding told the contract holds, and without it it does not.
TEST(Contracts, AllowWhatTheFileRounds) {
    Scene scene = test::pyramid();
    scene.settings.width = 60, scene.settings.height = 1;
    const Topology topology = makeTopology(meshesOf(scene));
    std::vector<double> coded;
    for (int i = 0; i < 60; ++i) {
        const double angle = 0.1 * i;
        for (const double x : {std::cos(angle) * 0.6, std::sin(angle) * 0.6, 0.8})
            coded.push_back(2 * std::round((x + 1) / 2 * 255) / 255 - 1);
    }
    ContractInput input{scene, topology, {}};
    input.buffers.push_back(numbersOf({BufferId::Normal}, {1, 60, 3}, coded, 1.0 / 255));
    EXPECT_TRUE(checkContract(*findContract("unit-normals"), input).holds());
    input.buffers[0].rounding = 0x1p-24;
    EXPECT_FALSE(checkContract(*findContract("unit-normals"), input).holds());
}

// Two scenes in which every contract has something to say: lit from a point, with a polygon outside the picture.
std::vector<Scene> tellingScenes() {
    Scene scene = test::spheres();
    scene.settings.width = 80, scene.settings.height = 60;
    scene.settings.model = Model::BlinnPhong;
    scene.objects[0].material.highlight = Highlight::Phong;
    scene.objects[0].material.specular = scene.objects[2].material.specular = Vec3d(0.4);
    scene.objects[2].transform.translation = {-400, 900, 30};
    scene.objects[2].material.exponent = 5;
    scene.lights[1].castsShadow = true;
    scene.settings.depthFormat = DepthFormat::Float;
    return {scene};
}

// A number that the contract must refuse in place of x.
double spoiled(std::string_view contract, double x) {
    static const std::map<std::string_view, double> kInstead{{"outside", 5},
                                                             {"shadow-depths", -1},
                                                             {"depth-range", 1e6},
                                                             {"depth-of-polygon", 1e6},
                                                             {"range-n-dot-l", 2},
                                                             {"range-r-dot-v", -2},
                                                             {"range-n-dot-h", 1.01},
                                                             {"shadow-factor", 1.5},
                                                             {"object-of-polygon", 7},
                                                             {"diffuse-positive", -1},
                                                             {"specular-positive", -1},
                                                             {"specular-where-lit", 3},
                                                             {"range-of-weights", -0.01},
                                                             {"depth-writes", 1000}};
    const auto instead = kInstead.find(contract);
    if (contract == "winding") return x == 0 ? 1 : 0;  // kept and back-facing exchanged
    return instead != kInstead.end() ? instead->second : 1.01 * x + 0.02;
}

// One element of the buffer that a contract is about is made wrong: that contract says so, counts it once and points there.
TEST(Contracts, AreEachViolatedByASpoiledBuffer) {
    std::set<std::string_view> told;
    for (const Scene& scene : tellingScenes()) {
        const FramePtr frame = test::frameOf(scene, contractBuffers());
        const ContractInput whole = contractInput(*frame);
        for (const ContractResult& before : checkContracts(whole)) {
            const Contract& contract = *before.contract;
            if (!before.why.empty()) continue;
            ASSERT_TRUE(before.holds()) << before.name();
            // What is seen must be kept: there the verdict is spoiled, of the polygon that is seen.
            const bool ofVerdict = contract.id == "seen-is-kept";
            std::size_t element = before.worst->element;
            ContractInput input = whole;
            for (ContractBuffer& buffer : input.buffers) {
                const bool first = buffer.numbers.name.id == contract.reads.ids[ofVerdict ? 1 : 0];
                if (!first || (contract.perLight() && buffer.numbers.name.light != before.light)) continue;
                std::vector<double> values(buffer.numbers.count());
                for (std::size_t i = 0; i < values.size(); ++i) values[i] = buffer.numbers.flat(i);
                if (ofVerdict) {
                    const auto ids = frame->buffer({BufferId::PolygonId});
                    values[std::size_t(ids->flat(element))] = 1;  // back-facing
                } else {
                    const auto channels = std::size_t(buffer.numbers.channels());
                    for (std::size_t c = 0; c < channels; ++c)
                        values[channels * element + c] = spoiled(contract.id, values[channels * element + c]);
                }
                buffer = numbersOf(buffer.numbers.name, buffer.numbers.shape, values, buffer.rounding);
            }
            const ContractResult after = checkContract(contract, input, before.light);
            EXPECT_LT(after.hold, after.checked) << before.name();
            ASSERT_TRUE(after.worst) << before.name();
            ASSERT_FALSE(after.violators.empty()) << before.name();
            EXPECT_TRUE(after.violators[element]) << before.name();
            if (!ofVerdict) {
                EXPECT_EQ(after.worst->element, element) << before.name();
                EXPECT_EQ(after.hold, after.checked - 1) << before.name();
            }
            told.insert(contract.id);
        }
    }
    for (const Contract& contract : contractTable()) EXPECT_TRUE(told.contains(contract.id)) << contract.id;
}

TEST(Contracts, NoneHoldsForNaN) {
    const FramePtr frame = test::frameOf(tellingScenes()[0], contractBuffers());
    const ContractInput whole = contractInput(*frame);
    for (const ContractResult& before : checkContracts(whole)) {
        if (!before.why.empty() || bufferInfo(before.contract->reads.ids[0]).element != Element::Real) continue;
        ContractInput input = whole;
        for (ContractBuffer& buffer : input.buffers)
            if (buffer.numbers.name == BufferName{before.contract->reads.ids[0], buffer.numbers.name.light})
                buffer = numbersOf(buffer.numbers.name, buffer.numbers.shape,
                                   std::vector<double>(buffer.numbers.count(), kNotANumber), buffer.rounding);
        const ContractResult after = checkContract(*before.contract, input, before.light);
        EXPECT_GT(after.checked, 0u) << before.name();
        EXPECT_EQ(after.hold, 0u) << before.name();
        EXPECT_FALSE(toJson(std::span(&after, 1), input, true).dump().empty());
    }
}

// 512 × 512 pixels are four looks; whoever says no at the third has had two of them done.
TEST(Contracts, StopBetweenLooks) {
    Scene scene = test::pyramid();
    scene.settings.width = scene.settings.height = 512;
    const Topology topology = makeTopology(meshesOf(scene));
    ContractInput input{scene, topology, {}, std::vector<bool>(512 * 512, true)};
    std::vector<double> normals(512 * 512 * 3, 0);
    for (std::size_t i = 2; i < normals.size(); i += 3) normals[i] = 1;
    input.buffers.push_back(numbersOf({BufferId::Normal}, {512, 512, 3}, normals, 0x1p-53));
    int looks = 0;
    const ContractResult result = checkContract(*findContract("unit-normals"), input, -1, [&] { return ++looks < 3; });
    EXPECT_EQ(result.checked, std::size_t(2 * 65536));
    EXPECT_TRUE(checkContracts(input, [] { return false; }).empty());
}

TEST(Contracts, AreDescribedInFull) {
    std::set<std::string_view> ids;
    StageId stage = StageId::Transform;
    for (const Contract& contract : contractTable()) {
        EXPECT_TRUE(ids.insert(contract.id).second) << contract.id;
        EXPECT_GE(contract.stage, stage) << contract.id;
        stage = contract.stage;
        for (const std::string_view text :
             {contract.claim, contract.formula, contract.bound, contract.source, contract.range})
            EXPECT_FALSE(text.empty()) << contract.id;
        EXPECT_EQ(bufferInfo(contract.reads.ids[0]).stage, contract.stage) << contract.id;
    }
}

// A naive form breaks what its formula promises, and nothing else does in this scene.
TEST(Contracts, TellOfANaiveForm) {
    Scene scene = tellingScenes()[0];
    scene.settings.forms.unit = UnitForm::Estimate;  // 1 / √x from the bits, within 3.4 %
    const std::string text = violations(test::frameOf(scene, contractBuffers()));
    EXPECT_NE(text.find("unit-normals"), std::string::npos) << text;
    EXPECT_NE(text.find("unit-light.0"), std::string::npos) << text;
    EXPECT_EQ(text.find("sum-of-terms"), std::string::npos) << text;
}

}  // namespace
}  // namespace pipeline
