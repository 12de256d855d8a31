// A model that is opened by itself: what of it the first picture shows, and why where it shows nothing.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "pipeline/core/angles.h"
#include "pipeline/formats/model_scene.h"
#include "pipeline/formats/toml/toml_scene.h"
#include "pipeline/formats/toml/toml_writer.h"
#include "pipeline/plan/scene_remarks.h"
#include "pipeline/run/frame_remarks.h"
#include "pipeline/scene/framing.h"
#include "pipeline/scene/settings_table.h"
#include "pipeline/stages/cull.h"
#include "pipeline/stages/transform.h"
#include "tests/support/gltf_files.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

using test::filesOf, test::fileOf, test::Parts, test::squareParts;

Scene sceneOf(const std::string& text, const std::string& name, const FileLoader& load = filesOf({})) {
    const Result<Scene> scene = readModelScene({text, name}, load);
    EXPECT_TRUE(scene) << (scene ? "" : format(scene.errors()));
    return scene ? *scene : Scene();
}
FramePtr frameOf(const Scene& scene) {
    FrameRequest request;
    request.wanted = setOf({BufferId::Color, BufferId::PolygonId, BufferId::PolygonsVerdict});
    request.threads = 1;
    return runFrame(std::make_shared<const Scene>(scene), request, nullptr);
}
Scene with(Scene scene, const std::vector<std::string>& assignments) {
    for (const std::string& assignment : assignments) {
        auto changed = withSetting(std::move(scene), assignment);
        EXPECT_TRUE(changed) << (changed ? "" : format(changed.errors()));
        scene = std::move(changed).value();
    }
    return scene;
}
std::string textOf(const std::optional<Remark>& remark) {
    return remark ? (remark->about.empty() ? "" : remark->about + ": ") + remark->text : "";
}

// The largest of red, green and blue anywhere.
Vec3d brightest(const Frame& frame) {
    const AnyBuffer color = *frame.buffer({BufferId::Color});
    Vec3d most(0);
    for (std::size_t i = 0; i < color.count(); ++i) most[int(i % 3)] = std::max(most[int(i % 3)], color.flat(i));
    return most;
}

// The box of the pixels where something is drawn: first and last column, first and last row.
std::array<std::size_t, 4> drawnBox(const Frame& frame) {
    const AnyBuffer ids = *frame.buffer({BufferId::PolygonId});
    std::array<std::size_t, 4> box{ids.columns(), 0, ids.rows(), 0};
    for (std::size_t y = 0; y < ids.rows(); ++y)
        for (std::size_t x = 0; x < ids.columns(); ++x)
            if (ids.value(x, y) >= 0)
                box = {std::min(box[0], x), std::max(box[1], x), std::min(box[2], y), std::max(box[3], y)};
    return box;
}

std::string withMaterial(const std::string& material) {
    Parts parts = squareParts();
    parts["meshes"] = R"([{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}])";
    parts["materials"] = "[" + material + "]";
    return fileOf(parts);
}

// glTF 2.0, section 3.4: the front of an asset faces +z, which is -y here.
TEST(FirstPicture, TheFrontOfAGltfFileIsSeen) {
    const Scene scene = sceneOf(fileOf(squareParts()), "m.gltf");
    const FramePtr frame = frameOf(scene);
    const AnyBuffer verdicts = *frame->buffer({BufferId::PolygonsVerdict});
    for (std::size_t i = 0; i < verdicts.count(); ++i) EXPECT_EQ(verdicts.flat(i), double(Verdict::Kept));
    EXPECT_GT(brightest(*frame).x, 0);
    EXPECT_EQ(textOf(whyNothingIsSeen(*frame)), "");
}

// Triangles that face along each axis, alone: whichever it is, the camera sees its front.
TEST(FirstPicture, AnOpenMeshIsSeenFromItsFront) {
    const char* const vertices[]{"v 0 0 0\nv 0 1 0\nv 0 0 1\n", "v 0 0 0\nv 0 0 1\nv 1 0 0\n",
                                 "v 0 0 0\nv 1 0 0\nv 0 1 0\n"};
    for (const char* triangle : vertices)
        for (const char* order : {"f 1 2 3\n", "f 1 3 2\n"}) {
            const FramePtr frame = frameOf(sceneOf(std::string(triangle) + order, "m.obj"));
            EXPECT_EQ(frame->buffer({BufferId::PolygonsVerdict})->flat(0), double(Verdict::Kept)) << triangle << order;
            EXPECT_GT(brightest(*frame).x, 0) << triangle << order;
        }
}

// metallicFactor left out is 1: k_d = 0 and k_a = base colour (the manual's table). The picture is at least the base
// colour under ambient light, here red.
TEST(FirstPicture, AMetalIsNotBlack) {
    const Scene scene =
        sceneOf(withMaterial(R"({"pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 1]}})"), "m.gltf");
    EXPECT_EQ(scene.settings.model, Model::BlinnPhong);
    const Vec3d color = brightest(*frameOf(scene));
    EXPECT_GE(color.x, std::round(255 * *scene.ambient.intensity));  // k_a = 1 times I_a, and 1 is white
    EXPECT_EQ(color.y, 0);
    EXPECT_TRUE(std::ranges::any_of(scene.remarks, [](const Remark& r) { return r.about.starts_with("model="); }));
    // A dielectric keeps lecture 1's model, and nothing is said.
    const Scene plain = sceneOf(withMaterial(R"({"pbrMetallicRoughness": {"metallicFactor": 0}})"), "m.gltf");
    EXPECT_EQ(plain.settings.model, Model::Phong);
    EXPECT_FALSE(std::ranges::any_of(plain.remarks, [](const Remark& r) { return r.about.starts_with("model="); }));
}

// Seen from behind a double-sided square is there as well.
TEST(FirstPicture, ADoubleSidedMaterialIsNotCulled) {
    const Scene scene = sceneOf(withMaterial(R"({"doubleSided": true})"), "m.gltf");
    EXPECT_EQ(scene.settings.cull, CullMode::None);
    EXPECT_EQ(sceneOf(withMaterial("{}"), "m.gltf").settings.cull, CullMode::Back);
    EXPECT_EQ(textOf(whyNothingIsSeen(*frameOf(with(scene, {"camera.theta=135"})))), "");
}

TEST(FirstPicture, WhatGivesOffLightIsNotBlack) {
    const Scene scene = sceneOf(withMaterial(R"({"emissiveFactor": [0, 0.5, 0],
        "pbrMetallicRoughness": {"baseColorFactor": [0, 0, 0, 1], "metallicFactor": 0}})"),
                                "m.gltf");
    EXPECT_EQ(scene.settings.model, Model::OpenGl);
    EXPECT_GE(brightest(*frameOf(scene)).y, 127);  // 255 / 2
}

TEST(FirstPicture, AnMtlWithKaAloneIsNotBlack) {
    const Scene scene = sceneOf("mtllib m.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "m.obj",
                                filesOf({{"m.mtl", "newmtl a\nKa 0 0 1\nKd 0 0 0\n"}}));
    EXPECT_EQ(scene.settings.model, Model::BlinnPhong);
    EXPECT_GE(brightest(*frameOf(scene)).z, std::round(255 * *scene.ambient.intensity));
}

// The camera is to show all of it: a sphere of the model's half diagonal R fills four fifths of the smaller side s. What
// is drawn lies within, and the box's corners, on that sphere, come near to it.
TEST(FirstPicture, AllOfAModelIsSeenAtEverySize) {
    std::string box;
    for (int i = 0; i < 8; ++i) box += fmt::format("v {} {} {}\n", i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    box += "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
    for (const auto& [width, height] :
         {std::pair{640, 480}, {320, 240}, {160, 120}, {1280, 960}, {900, 90}, {90, 900}}) {
        const Scene scene =
            with(sceneOf(box, "m.obj"), {fmt::format("width={}", width), fmt::format("height={}", height)});
        const auto [left, right, top, bottom] = drawnBox(*frameOf(scene));
        const double side = std::min(width, height);
        const double most = double(std::max(right - left, bottom - top) + 1);
        EXPECT_GT(left, 0u);
        EXPECT_GT(top, 0u);
        EXPECT_LT(right, std::size_t(width) - 1);
        EXPECT_LT(bottom, std::size_t(height) - 1);
        EXPECT_LE(most, 0.8 * side + 1) << width << " x " << height;
        EXPECT_GT(most, 0.5 * side) << width << " x " << height;
    }
    // A camera that was moved stays, and so does that of any other scene.
    const Scene moved = with(sceneOf(box, "m.obj"), {"camera.distance=100", "width=100"});
    EXPECT_EQ(moved.camera.screenDistance, 100);
    EXPECT_EQ(with(test::pyramid(), {"width=100", "height=100"}).camera, test::pyramid().camera);
}

// A square in the file's plane z = 0 from (1, 2) to (2, 4). With y up it stands upright, its middle (1.5, 3, 0) in the
// world's origin: (x, y, z) of the file is at (x - 1.5, -z, y - 3).
TEST(FirstPicture, UpTurnsAWholeFileAboutItsMiddle) {
    const std::string two = "o a\nv 1 2 0\nv 2 2 0\nv 2 4 0\nf 1 2 3\no b\nv 1 4 0\nf 1 3 4\n";
    const Scene lying = with(sceneOf(two, "m.obj"), {"up=z"});
    ASSERT_EQ(lying.objects.size(), 2u);
    const auto placeOf = [](const Scene& scene, std::size_t object, std::size_t vertex) {
        return toWorld(makeObjectMatrix(scene.objects[object].transform),
                       scene.objects[object].mesh->positions[vertex]);
    };
    EXPECT_EQ(placeOf(lying, 0, 0), Vec3d(-0.5, -1, 0));
    const Scene standing = with(lying, {"up=y"});
    EXPECT_EQ(placeOf(standing, 0, 0), Vec3d(-0.5, 0, -1));
    EXPECT_EQ(placeOf(standing, 0, 2), Vec3d(0.5, 0, 1));
    EXPECT_EQ(placeOf(standing, 1, 0), Vec3d(-0.5, 0, -1));
    EXPECT_EQ(standing.camera.theta, -45);  // what faced up faces the viewer now
    EXPECT_EQ(with(standing, {"up=z"}), lying);
    // Of no other scene: there every object has its own.
    EXPECT_FALSE(withSetting(test::pyramid(), "up=y"));
    const Scene own = with(test::pyramid(), {"object.0.up=y"});
    EXPECT_EQ(own.objects[0].transform.up, UpAxis::Y);
    EXPECT_EQ(own.objects[0].transform.translation, test::pyramid().objects[0].transform.translation);
}

// glTF 2.0, 3.9.5: the back of a double-sided surface is lit by the reversed normal. The square faces the file's -z.
TEST(FirstPicture, TheBackOfADoubleSidedSurfaceIsLit) {
    Parts parts = squareParts();
    parts["meshes"] = R"([{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}])";
    parts["materials"] = R"([{"doubleSided": true,
                             "pbrMetallicRoughness": {"metallicFactor": 0, "baseColorFactor": [0.8, 0.8, 0.8, 1]}}])";
    const Scene front = sceneOf(fileOf(parts), "m.gltf");
    const auto from = [&](double theta) {
        Scene scene = front;
        scene.camera.theta = theta;
        scene.lights[0].position = {500 * cosDegrees(theta), 500 * sinDegrees(theta), 0};
        return brightest(*frameOf(scene)).x;
    };
    EXPECT_GT(from(-90), 100);
    EXPECT_NEAR(from(90), from(-90), 1) << "the light turns with the eye";
}

TEST(FirstPicture, OpenMeshesAloneAreLitFromBothSides) {
    EXPECT_TRUE(sceneOf(withMaterial(R"({"doubleSided": true})"), "m.gltf").settings.twoSided);
    EXPECT_FALSE(sceneOf(withMaterial("{}"), "m.gltf").settings.twoSided);
}

TEST(FirstPicture, AModelThatASceneNamesLiesAsItIsWritten) {
    const std::string body = "v -1 0 -1\nv 1 0 -1\nv 0 0 1\nv 0 3 0\nf 1 2 3\nf 1 4 2\nf 2 4 3\nf 3 4 1\n";
    // But for glTF, and where the scene says so.
    const FileLoader files = filesOf({{"m.obj", body}, {"m.gltf", fileOf(squareParts())}});
    const auto named = [&](const std::string& object) {
        const Result<Scene> scene = readTomlScene({"[[object]]\n" + object, "s.toml"}, files);
        EXPECT_TRUE(scene) << (scene ? "" : format(scene.errors()));
        return scene ? scene->objects.at(0).transform.up : UpAxis::Z;
    };
    EXPECT_EQ(named("model = \"m.obj\"\n"), UpAxis::Z);
    EXPECT_EQ(named("model = \"m.obj\"\nup = \"y\"\n"), UpAxis::Y);
    EXPECT_EQ(named("model = \"m.gltf\"\n"), UpAxis::Y);
    EXPECT_EQ(named("model = \"m.gltf\"\nup = \"z\"\n"), UpAxis::Z);
}

TEST(FirstPicture, UpStandsInTheWrittenScene) {
    const Scene scene = sceneOf(fileOf(squareParts()), "m.gltf");
    const auto text = toTomlScene(scene);
    ASSERT_TRUE(text);
    EXPECT_NE(text->find("[[object]]\nname = \"square\"\nvertices"), text->npos);
    EXPECT_NE(text->find("up = \"y\"\n"), text->npos);
    const Result<Scene> again = readTomlScene({*text, "s.toml"}, filesOf({}));
    ASSERT_TRUE(again) << format(again.errors());
    EXPECT_EQ(again->objects[0].transform, scene.objects[0].transform);
    const FramePtr a = frameOf(scene), b = frameOf(*again);
    const AnyBuffer first = *a->buffer({BufferId::Color}), second = *b->buffer({BufferId::Color});
    for (std::size_t i = 0; i < first.count(); ++i) ASSERT_EQ(first.flat(i), second.flat(i));
}

// Upright first, then the scale: along the world's z the mesh's y is scaled.
TEST(FirstPicture, UpComesBeforeTheOtherTransforms) {
    ObjectTransform transform{{2, 3, 5}, {0, 0, 90}, {10, 20, 30}};
    transform.up = UpAxis::Y;
    // (1, 2, 3) upright is (1, -3, 2), scaled (2, -9, 10), turned about z (9, 2, 10), moved (19, 22, 40).
    EXPECT_EQ(toWorld(makeObjectMatrix(transform), {1, 2, 3}), Vec3d(19, 22, 40));
    transform.scale.x = -2;
    EXPECT_TRUE(makeObjectMatrix(transform).mirrors);
    EXPECT_LT(glm::determinant(makeObjectMatrix(transform).linear), 0);
}

// In Lecture 1's model I_max is white; in the others 1 is, and the example's light of 100 is far above it.
TEST(FirstPicture, APictureThatIsAlmostAllWhiteSaysWhichIntensityIsTooLarge) {
    const auto about = [](const Scene& scene) {
        const auto remarks = frameRemarks(*frameOf(scene));
        const auto white = std::ranges::find_if(
            remarks, [](const Remark& r) { return r.text.find("are white.") != std::string::npos; });
        return white == remarks.end() ? "" : white->about;
    };
    EXPECT_EQ(about(test::pyramid()), "");
    EXPECT_EQ(about(with(test::pyramid(), {"model=blinn-phong"})), "light.0.intensity");
    EXPECT_EQ(about(with(test::pyramid(), {"model=blinn-phong", "light.0.intensity=0.6", "ambient.intensity=0.3"})),
              "");
}

// A scene with a triangle in z = 0 that faces up, seen by the example's camera.
Scene triangle() {
    Scene scene = test::pyramid();
    scene.objects[0].transform = {};
    scene.objects[0].mesh = test::mesh({{0, 0, 0}, {100, 0, 0}, {0, 100, 0}}, {{0, 1, 2}});
    return scene;
}

TEST(NothingSeen, SaysWhyAndWhatToSet) {
    struct Case {
        std::vector<std::string> set;
        std::string why;
        std::vector<std::string> mend;  // what the remark says to set
    };
    const Case cases[] = {
        {{}, "", {}},
        {{"camera.phi=120"},
         "cull: The only polygon faces away from the eye, and back faces are left out. Set cull=none, or look from the "
         "other side: camera.theta=-135 camera.phi=60.",
         {"cull=none"}},
        {{"camera.phi=120"},
         "cull: The only polygon faces away from the eye, and back faces are left out. Set cull=none, or look from the "
         "other side: camera.theta=-135 camera.phi=60.",
         {"camera.theta=-135", "camera.phi=60"}},
        {{"material.0.alpha=0"},
         "material.0.alpha: Every object is wholly transparent (α = 0): set material.0.alpha=1, and so for each "
         "object.",
         {"material.0.alpha=1"}},
        {{"camera.near=2000"},
         "camera.near: The only polygon is before the near plane. Set camera.near=0, which chooses it from the scene.",
         {"camera.near=0"}},
        {{"camera.far=100"},
         "camera.far: The only polygon is behind the far plane. Set camera.far=0, which chooses it from the scene.",
         {"camera.far=0"}},
        {{"light.0.intensity=0", "ambient.intensity=0"},
         "ambient.intensity: Everything that is drawn is black. No light has an intensity that the materials reflect: "
         "set "
         "light.0.intensity, or ambient.intensity.",
         {"ambient.intensity=10"}},
        {{"light.0.z=-500", "ambient.intensity=0"},
         "ambient.intensity: Everything that is drawn is black. No light reaches a surface that is seen, and there is "
         "no "
         "ambient light: set ambient.intensity, or move the light.",
         {"ambient.intensity=10"}},
        {{"material.0.kr=0", "material.0.kg=0", "material.0.kb=0", "material.0.ks=0", "material.0.kar=1"},
         "model: Everything that is drawn is black. The materials reflect ambient light by k_a, which Phong's model "
         "does "
         "not read: it takes k_d, which is 0. Set model=blinn-phong.",
         {"model=blinn-phong"}},
        {{"material.0.kr=0", "material.0.kg=0", "material.0.kb=0", "material.0.ks=0", "material.0.ker=1"},
         "model: Everything that is drawn is black. The materials give off light, which this illumination model does "
         "not "
         "read: set model=opengl.",
         {"model=opengl"}},
    };
    for (const Case& one : cases) {
        const Scene scene = with(triangle(), one.set);
        EXPECT_EQ(textOf(whyNothingIsSeen(*frameOf(scene))), one.why);
        if (one.mend.empty()) continue;
        // What it says to do shows something.
        EXPECT_EQ(textOf(whyNothingIsSeen(*frameOf(with(scene, one.mend)))), "") << one.why;
    }
}

TEST(NothingSeen, OutsideThePictureAndBehindTheEye) {
    Scene aside = triangle();
    aside.objects[0].transform.translation = {-10000, 10000, 0};  // left of an eye in direction (1, 1)
    EXPECT_TRUE(textOf(whyNothingIsSeen(*frameOf(aside)))
                    .starts_with("camera.distance: The only polygon is outside the picture."));
    Scene behind = triangle();
    behind.objects[0].transform.translation = {10000, 10000, 10000};
    EXPECT_TRUE(
        textOf(whyNothingIsSeen(*frameOf(behind))).starts_with("camera.near: The only polygon is behind the eye."));
    Scene small = triangle();
    small.objects[0].transform.scale = Vec3d(1e-3);  // 0.02 pixels: 0.1 units · d / ρ, d = 200, ρ = 1000
    EXPECT_TRUE(textOf(whyNothingIsSeen(*frameOf(small)))
                    .starts_with("camera.distance: The only polygon is in view, and so small"));
    Scene empty = triangle();
    empty.objects.clear();
    EXPECT_EQ(textOf(whyNothingIsSeen(*frameOf(empty))), "object: The scene has no polygons.");
}

// Translucent surfaces are laid over the opaque ones after the z-buffer: they are seen.
TEST(NothingSeen, TranslucentSurfacesAreSeen) {
    EXPECT_EQ(textOf(whyNothingIsSeen(*frameOf(with(triangle(), {"material.0.alpha=0.5"})))), "");
}

// The scene's remarks have said it where it is certain before anything is drawn: once is enough.
TEST(NothingSeen, FrameRemarksSayItOnce) {
    const auto aboutBlack = [](const Scene& scene) {
        return std::ranges::count_if(frameRemarks(*frameOf(scene)), [](const Remark& remark) {
            return remark.text.find("black") != std::string::npos;
        });
    };
    EXPECT_EQ(aboutBlack(with(triangle(), {"light.0.intensity=0", "ambient.intensity=0"})), 1);
    EXPECT_EQ(aboutBlack(with(triangle(), {"light.0.z=-500", "ambient.intensity=0"})), 1);
    EXPECT_EQ(aboutBlack(triangle()), 0);
}

}  // namespace
}  // namespace pipeline
