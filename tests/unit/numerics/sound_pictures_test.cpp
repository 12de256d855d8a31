// Pictures that are wrong without a look of it: each is said, and a contract counts only where it could fail.
#include <gtest/gtest.h>

#include <algorithm>

#include "pipeline/contracts/contract.h"
#include "pipeline/formats/toml/toml_scene.h"
#include "pipeline/plan/scene_remarks.h"
#include "pipeline/run/frame_remarks.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

Scene tomlScene(std::string_view toml) {
    const auto read =
        readTomlScene({toml, "scene.toml"}, [](std::string_view) -> Result<NamedFile> { return Error(); });
    EXPECT_TRUE(read) << format(read.errors());
    return read ? *read : Scene();
}

std::string firstAbout(const std::vector<Remark>& remarks, std::string_view about) {
    const auto found = std::ranges::find(remarks, about, &Remark::about);
    return found == remarks.end() ? "" : found->text;
}
bool mentions(const std::string& text, std::string_view part) { return text.find(part) != text.npos; }

constexpr std::string_view kFarLight = R"(
width=320
height=240
shading="phong"
[camera]
kind="look-at"
eye=[3,-4,5]
fov=45
[[light]]
kind="point"
position=[1000,500,2000]
intensity=100
[[object]]
shape="plane"
scale=[4,4,1]
[[object]]
shape="box"
translation=[0,0,1]
)";

// The light is (1000, 500, 2000) − (0, 0, 0.75) away, 2290.6; a face of 1024 texels sees twice that: 4.47 units a texel,
// over a scene of √(4² + 4² + 1.5²) = 5.85. A light at a tenth has 13 texels there, one at a hundredth 131.
TEST(SoundPictures, AShadowBufferTooCoarseForTheSceneIsSaid) {
    Scene scene = tomlScene(kFarLight);
    const std::string said = firstAbout(sceneRemarks(scene), "shadow.size");
    EXPECT_TRUE(mentions(said, "light 0 is 4.5 world units wide at the scene, which is 5.9 large")) << said;
    scene.lights[0].position *= 0.1;
    EXPECT_FALSE(firstAbout(sceneRemarks(scene), "shadow.size").empty());
    scene.lights[0].position *= 0.1;
    EXPECT_EQ(firstAbout(sceneRemarks(scene), "shadow.size"), "");
    scene.lights[0].position *= 100;
    scene.lights[0].kind = LightKind::AtInfinity;
    EXPECT_EQ(firstAbout(sceneRemarks(scene), "shadow.size"), "") << "its view is fitted to the scene";
}

constexpr std::string_view kNeedle = R"(
width=160
height=120
shading="phong"
cull="none"
[camera]
kind="look-at"
eye=[1.3369999998761812, -2.5289999997110892, 3.0112962797325205]
target=[0.137, 0.271, 0.419]
fov=45
[[light]]
position=[0.2999999999690453, -0.6999999999277723, 0.6480740699331301]
intensity=100
shadow=false
[[object]]
vertices=[[0.8008561469626528, 1.2605933590417795, 1.1805773105078095], [-1.037433913073463, 0.4727547618834441, 1.1805773105078095], [-0.2102033605283226, 0.827282071037289, 1.1805772343500784], [-0.5268561469626528, -0.7185933590417796, -0.34257731050780943], [1.3114339130734631, 0.06924523811655592, -0.34257731050780943]]
polygons=[[0,1,2],[0,2,4],[2,1,3],[2,3,4]]
[object.material]
diffuse=1
)";

// The needle is 10⁻⁷ as high as it is long; the other polygons are as wide as long.
TEST(SoundPictures, ASliverThatTurnsNormalsInFloatIsSaid) {
    Scene scene = tomlScene(kNeedle);
    const std::string name = scene.objects[0].name;
    EXPECT_TRUE(mentions(firstAbout(sceneRemarks(scene), name), "1 polygon of"))
        << firstAbout(sceneRemarks(scene), name);
    EXPECT_TRUE(mentions(firstAbout(sceneRemarks(scene), name), "precision=double"));
    const ContractInput input = contractInput(*test::frameOf(scene, contractBuffers()));
    const ContractResult winding = checkContract(*findContract("normal-by-winding"), input);
    EXPECT_EQ(winding.undecided, 1u) << "no value at the needle could break it";
    EXPECT_EQ(winding.checked + winding.undecided, 4u);
    EXPECT_TRUE(mentions(contractsText({&winding, 1}, input), "rounding decides at 1 more"));
    scene.settings.precision = Precision::Double;
    EXPECT_EQ(firstAbout(sceneRemarks(scene), name), "");
    const FramePtr exact = test::frameOf(scene, contractBuffers());
    EXPECT_EQ(checkContract(*findContract("normal-by-winding"), contractInput(*exact)).undecided, 0u);
}

// A square of 10⁻¹⁰⁰ before an eye as near: float rounds all places to 0.
TEST(SoundPictures, UnderflowIsSaidAndNotThatTheSceneIsBehindTheEye) {
    Scene scene;
    scene.settings.width = scene.settings.height = 9;
    scene.settings.cull = CullMode::None;
    scene.camera.kind = CameraKind::LookAt;
    scene.camera.eye = {0, 0, 5e-100}, scene.camera.up = {0, 1, 0};
    scene.objects.push_back(
        {"square",
         test::mesh({{-1e-100, -1e-100, 0}, {1e-100, -1e-100, 0}, {1e-100, 1e-100, 0}}, {{0, 1, 2}}),
         {},
         {}});
    scene.lights.push_back({LightKind::AtInfinity, {0, 0, 1}, 100, Vec3d(1), true});
    const auto said = whyNothingIsSeen(*test::frameOf(scene, setOf({BufferId::Color, BufferId::PolygonsVerdict})));
    ASSERT_TRUE(said);
    EXPECT_EQ(said->about, "precision");
    EXPECT_TRUE(said->text.starts_with("Underflow")) << said->text;
    scene.settings.precision = Precision::Double;
    EXPECT_FALSE(whyNothingIsSeen(*test::frameOf(scene, setOf({BufferId::Color, BufferId::PolygonsVerdict}))));
}

std::string brokenContracts(const Scene& scene) {
    const ContractInput input = contractInput(*test::frameOf(scene, contractBuffers()));
    std::string text;
    for (const ContractResult& result : checkContracts(input))
        if (!result.holds()) text += result.name() + ": " + contractWorst(result, input) + "\n";
    return text;
}

// Gouraud shading, where a weight of −6·10⁻⁸ meets a term of 32 000.
constexpr std::string_view kNegative = R"(
width=96
height=72
precision="float"
shading="gouraud"
model="phong"
shadow.size=64
normal_weight="given"
cull="none"
depth_format="reversed"
visibility="painter"
interpolation="affine"
local_viewer=false
numerics.subpixel_bits=1
[camera]
kind="look-at"
eye=[-2.285271670245144, -4.844471957602824, 4.713007077555521]
target=[-0.6863174960899356, 0.6388105850136481, -0.856850199178598]
up=[0.129767013283691, -0.024743298610520936, -0.6417196430773395]
fov=35
[ambient]
intensity=0.00046250512875581996
[[light]]
kind="point"
position=[84.6932122854092, 0.135875457164099, -451.9158074626857]
intensity=1.0410418456442245
[[light]]
kind="at-infinity"
position=[316.7661169386598, 7.843707984548669, 199.4739246769491]
intensity=7833.907999937706
[[light]]
kind="point"
position=[-4.947103424496678, 5.209032890219127, -314.2941562249079]
intensity=39227.244937480034
[[object]]
shape="torus"
tessellation=9
scale=[0.6050487586666287, 1.2296096244874644, 1.5390356947869261]
rotation=[7.346240575130736, 128.8411059890782, 38.65919508040821]
translation=[0.7402347113384411, -1.9938529178508606, -1.4814267218597545]
[object.material]
diffuse=[0.826, 0.766, 0.337]
ks=0.4440181137211291
n=1000
)";
// A teapot whose knob has vertices all polygons around which have no area.
constexpr std::string_view kNoArea = R"(
width=96
height=72
precision="float"
shading="gouraud"
model="cook-torrance"
shadow.size=16
normal_weight="mean"
cull="back"
depth_format="linear"
visibility="z-buffer"
interpolation="affine"
local_viewer=true
numerics.subpixel_bits=4
[camera]
kind="look-at"
eye=[162899.70749174533, -151262.40810247872, 155580.02200056892]
target=[-24051.267390670408, 31066.564255867295, 9382.295104933703]
up=[-0.7955456837799035, -0.3651407356472316, -0.9553557779573523]
fov=90
[ambient]
intensity=0.03753624734771174
[[light]]
kind="area"
position=[20922022.096721683, -257812.97495111034, 40682560.28819581]
intensity=0.0006266332033757223
samples=2
width=51464.29810790725
height=51464.29810790725
[[object]]
shape="teapot"
tessellation=1
scale=[7.299322267331493, 98504.7261552554, -48845.99481680211]
rotation=[-113.07374427790162, 177.31562838338346, 129.58075036630436]
translation=[-78042.5284970187, -34440.899422057926, 45594.158312474225]
[object.material]
diffuse=[0.711, 0.936, 0.422]
ks=0.830035693274327
n=100000.0
alpha=0.28415936669394815
)";

TEST(SoundPictures, ContractsAskForNoMoreThanRoundingLeaves) {
    const Scene negative = tomlScene(kNegative), noArea = tomlScene(kNoArea);
    EXPECT_EQ(brokenContracts(negative), "");
    EXPECT_EQ(brokenContracts(noArea), "");
    // Of Phong shading the term is a product of what is not below 0, and has no bound.
    Scene phong = negative;
    phong.settings.shading = Shading::Phong;
    const ContractInput input = contractInput(*test::frameOf(phong, contractBuffers()));
    EXPECT_EQ(checkContract(*findContract("diffuse-positive"), input, 0).worst->finding.bound, 0);
}

}  // namespace
}  // namespace pipeline
