// What strange values come to: a defined value, nothing drawn, or an error; and what is said about them.
#include "pipeline/plan/scene_remarks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "pipeline/formats/scene_reader.h"
#include "pipeline/illumination/illumination.h"
#include "pipeline/scene/settings_table.h"
#include "tests/support/files.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

// A square of k_d = 1/2 in the plane z = 0, 10 wide, lit and seen from +z: N·L = N·V = R·V = 1 in the middle.
// I = k_d I_a + I_p k_d = 0.5·20 + 100·0.5 = 60.
Scene square() {
    Scene scene;
    scene.settings.width = scene.settings.height = 9;
    scene.settings.precision = Precision::Double;
    scene.settings.cull = CullMode::None;
    scene.camera.kind = CameraKind::LookAt;
    scene.camera.eye = {0, 0, 5}, scene.camera.up = {0, 1, 0};
    scene.objects.push_back({"square",
                             test::mesh({{-5, -5, 0}, {5, -5, 0}, {5, 5, 0}, {-5, 5, 0}}, {{0, 1, 2, 3}}),
                             {},
                             {Vec3d(0.5), Vec3d(0), 8, Vec3d(0.5)}});
    scene.lights.push_back({LightKind::AtInfinity, {0, 0, 1}, 100, Vec3d(1), true});
    scene.ambient.intensity = 20;
    return scene;
}

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Case {
    const char* name;
    void (*change)(Scene&);
    std::optional<double> value;  // the red intensity in the middle; none: nothing is drawn
    const char* about;            // of a remark; empty: none at all
    const char* error = "";       // in full; then nothing else counts
};

const Case kCases[] = {
    {"nothing strange", [](Scene&) {}, 60, ""},
    {"k_d above 1", [](Scene& s) { s.objects[0].material.diffuse = Vec3d(1.5); }, 180, "material.0.kr"},
    {"k_d below 0", [](Scene& s) { s.objects[0].material.diffuse = Vec3d(-0.5); }, -60, "material.0.kr"},
    {"k_d and k_s together above 1", [](Scene& s) { s.objects[0].material.specular = Vec3d(0.8); }, 140, ""},
    {"k_s above 1", [](Scene& s) { s.objects[0].material.specular = Vec3d(2); }, 260, "material.0.ksr"},
    {"k_d is no number",
     [](Scene& s) { s.objects[0].material.diffuse.x = kNaN; },
     {},
     "",
     "material.0.kr is nan, expected a value from -1000 to 1000\n"},
    {"k_d far above 1",
     [](Scene& s) { s.objects[0].material.diffuse.x = 1001; },
     {},
     "",
     "material.0.kr is 1001, expected a value from -1000 to 1000\n"},
    {"negative light", [](Scene& s) { s.lights[0].intensity = -50; }, -15, "light.0.intensity"},
    {"infinite light",
     [](Scene& s) { s.lights[0].intensity = kInfinity; },
     {},
     "",
     "light.0.intensity is inf, expected a value from -1e9 to 1e9\n"},
    {"negative ambient light", [](Scene& s) { s.ambient.intensity = -20; }, 40, "ambient.intensity"},
    {"colour of a light above 1", [](Scene& s) { s.lights[0].color = Vec3d(2); }, 110, "light.0.red"},
    {"negative colour of ambient light", [](Scene& s) { s.ambient.color.x = -1; }, 40, "ambient.red"},
    {"no light", [](Scene& s) { s.lights.clear(); }, 10, "light"},
    {"no object", [](Scene& s) { s.objects.clear(); }, {}, "object"},
    {"I_max is 0", [](Scene& s) { s.lights[0].intensity = 0, s.ambient.intensity = 0; }, 0, "ambient.intensity"},
    {"light at infinity without a direction",
     [](Scene& s) { s.lights[0].position = Vec3d(0); },
     {},
     "",
     "light 0 is at infinity in the direction (0, 0, 0), expected a direction that is not zero\n"},
    {"point light in the surface", [](Scene& s) { s.lights[0].kind = LightKind::Point, s.lights[0].position = {}; }, 10,
     ""},  // flat shading asks there: no direction, no term
    {"exponent 0", [](Scene& s) { s.objects[0].material.specular = Vec3d(0.5), s.objects[0].material.exponent = 0; },
     110, "material.0.n"},
    {"exponent 0 in the dark",
     [](Scene& s) {
         s.objects[0].material.specular = Vec3d(0.5), s.objects[0].material.exponent = 0;
         s.lights[0].position = {0, 0, -1};
     },
     10, "material.0.n"},
    {"exponent below 0",
     [](Scene& s) { s.objects[0].material.exponent = -1; },
     {},
     "",
     "material.0.n is -1, expected a value from 0 to 1000000\n"},

    {"alpha above 1", [](Scene& s) { s.objects[0].material.alpha = 2; }, 60, "material.0.alpha"},
    {"alpha below 0", [](Scene& s) { s.objects[0].material.alpha = -1; }, {}, "material.0.alpha"},

    {"flat in its own plane", [](Scene& s) { s.objects[0].transform.scale.z = 0; }, 60, "object.0.sz"},
    {"scale 0 across", [](Scene& s) { s.objects[0].transform.scale.x = 0; }, {}, "object.0.sx"},
    {"scale 0 along two axes",
     [](Scene& s) {
         s.objects[0].transform.scale = {0, 1, 0};
     },
     {},
     "object.0.sx"},
    {"scale 0", [](Scene& s) { s.objects[0].transform.scale = Vec3d(0); }, {}, "object.0.sx"},
    {"mirrored", [](Scene& s) { s.objects[0].transform.scale.y = -1; }, 60, "object.0.sy"},
    {"mirrored twice",
     [](Scene& s) {
         s.objects[0].transform.scale = {-1, -1, 1};
     },
     60, ""},

    {"eye in the target, looking along z",  // the axis least aligned with (1, 1, 0)
     [](Scene& s) {
         s.camera.eye = s.camera.target = {0, 0, -5}, s.camera.up = {1, 1, 0};
     },
     60, "camera.target_x"},
    {"eye in the target, looking along x", [](Scene& s) { s.camera.target = s.camera.eye; }, {}, "camera.target_x"},
    {"up along the view",
     [](Scene& s) {
         s.camera.up = {0, 0, -2};
     },
     60, "camera.up_x"},
    {"up is nothing", [](Scene& s) { s.camera.up = {}; }, 60, "camera.up_x"},
    {"rho is 0",  // looks along -z
     [](Scene& s) {
         s.camera.kind = CameraKind::Spherical, s.camera.rho = s.camera.phi = 0;
         s.objects[0].transform.translation.z = -3;
     },
     60, "camera.rho"},
    {"rho is 0, orthographic",
     [](Scene& s) {
         s.camera.kind = CameraKind::Spherical, s.camera.rho = s.camera.phi = 0;
         s.camera.projection = ProjectionKind::Orthographic;
         s.objects[0].transform.translation.z = -3;
     },
     60, "camera.rho"},
    {"rho below 0", [](Scene& s) { s.camera.rho = -1; }, {}, "", "camera.rho is -1, expected a value from 0 to 1e9\n"},
    {"near beyond far",
     [](Scene& s) { s.camera.near = 5, s.camera.far = 5; },
     {},
     "",
     "camera.near is 5, expected less than camera.far, which is 5\n"},

    {"OpenGL's attenuation divides by 0",  // 0.5·0.2 of the ambient light alone
     [](Scene& s) {
         s.settings.model = Model::OpenGl, s.ambient.intensity = 0.2;
         s.lights[0].kind = LightKind::Point, s.lights[0].position = {0, 0, 5};
         s.lights[0].gl.constant = 0;
     },
     0.1, "light.0.constant"},
    {"OpenGL's attenuation of an area light divides by 0",
     [](Scene& s) {
         s.settings.model = Model::OpenGl, s.ambient.intensity = 0.2;
         s.lights[0].kind = LightKind::Area, s.lights[0].position = {0, 0, 5};
         s.lights[0].gl.constant = 0;
     },
     0.1, "light.0.constant"},
    {"emission above 1, in OpenGL's model alone",  // clamped
     [](Scene& s) { s.settings.model = Model::OpenGl, s.objects[0].material.emission = Vec3d(2); }, 1,
     "material.0.ker"},
    {"negative light in OpenGL's model",  // 0.5·0.2 - 0.5, clamped
     [](Scene& s) { s.settings.model = Model::OpenGl, s.ambient.intensity = 0.2, s.lights[0].intensity = -1; }, 0,
     "light.0.intensity"},
};

class StrangeCase : public testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(All, StrangeCase, testing::ValuesIn(kCases), [](const auto& row) {
    std::string name = row.param.name;
    std::erase_if(name, [](char c) { return c == ',' || c == '\''; });
    std::ranges::replace(name, ' ', '_');
    return name;
});

TEST_P(StrangeCase, HasItsDefinedResult) {
    const Case& row = GetParam();
    Scene scene = square();
    row.change(scene);
    EXPECT_EQ(format(checkScene(scene)), row.error);
    if (*row.error) return;
    const FramePtr frame = test::frameOf(scene);
    const double id = frame->buffer({BufferId::ObjectId})->value(4, 4);
    ASSERT_EQ(id, row.value ? 0 : -1);
    if (row.value) {
        EXPECT_NEAR(frame->buffer({BufferId::Intensity})->value(4, 4, 0), *row.value, 1e-12);
        EXPECT_EQ(frame->buffer({BufferId::Color})->value(4, 4, 0) == 0, *row.value <= 0);
    }

    const std::vector<Remark> remarks = sceneRemarks(scene);
    if (!*row.about) {
        EXPECT_TRUE(remarks.empty()) << remarks[0].about << ": " << remarks[0].text;
    }
    const auto isAbout = [&](const Remark& remark) { return remark.about == row.about; };
    EXPECT_TRUE(!*row.about || std::ranges::any_of(remarks, isAbout)) << row.about;
    // A key that is one of this scene's settings, or a part that it does not have.
    for (const Remark& remark : remarks)
        EXPECT_TRUE(findSetting(scene, remark.about) || remark.about == "light" || remark.about == "object")
            << remark.about;
}

TEST(SceneRemarks, SayWhatIsStrangeAndWhatIsDone) {
    Scene scene = square();
    scene.objects[0].material.diffuse.y = 1.4;
    scene.objects[0].transform.scale.x = -1;
    const std::vector<Remark> expected{
        {"object.0.sx", "\"square\" is mirrored: its outside stays outside."},
        {"material.0.kg",
         "k_d of the material of \"square\" is 1.4, above 1: it gives more light than it receives. Computed as "
         "written."}};
    EXPECT_EQ(sceneRemarks(scene), expected);
}

// k_d above 1 and n = 0 of a back material, which two-sided lighting alone reads.
TEST(SceneRemarks, OfABackMaterialNameItAndAreMadeWhereItIsRead) {
    Scene scene = square();
    scene.objects[0].backMaterial = Material{Vec3d(1.5), Vec3d(0.5), 0};
    for (const bool openGl : {false, true})
        for (const bool twoSided : {false, true}) {
            scene.settings.model = openGl ? Model::OpenGl : Model::Phong, scene.settings.twoSided = twoSided;
            std::vector<std::string> keys;
            for (const Remark& remark : sceneRemarks(scene)) keys.push_back(remark.about);
            const std::vector<std::string> both{"back_material.0.kr", "back_material.0.n"};
            EXPECT_EQ(keys, twoSided ? both : std::vector<std::string>{});
        }
}

std::vector<std::string> said(const Scene& scene) {
    std::vector<std::string> texts;
    for (const Remark& remark : sceneRemarks(scene))
        if (remark.about != "up") texts.push_back(remark.text);
    return texts;
}

// Phong's model has no emission: the lamp is black beside what the light shows.
TEST(SceneRemarks, ALampThatTheModelDoesNotReadIsNamed) {
    Scene scene = square();
    scene.objects[0].material.emission = {1, 0.9, 0.6};
    EXPECT_EQ(said(scene), std::vector<std::string>{"The material of \"square\" gives off light, which Phong's model "
                                                    "does not read; OpenGL's model does."});
    scene.settings.model = Model::OpenGl;
    EXPECT_TRUE(said(scene).empty());
}

// What draws nothing gives no intensity: I_max is 0, as in the frame.
TEST(SceneRemarks, TransparentObjectsMakeNothingBright) {
    Scene scene = square();
    scene.objects[0].material.alpha = 0;
    const std::vector<Remark> remarks = sceneRemarks(scene);
    ASSERT_EQ(remarks.size(), 1u);
    EXPECT_TRUE(remarks[0].text.starts_with("I_max is 0")) << remarks[0].text;
    scene.objects.push_back(square().objects[0]);
    EXPECT_TRUE(sceneRemarks(scene).empty());
    EXPECT_EQ(maximumIntensity(scene), 60) << "0.5 (20 + 100)";
}

TEST(SceneRemarks, PolygonsThatAreNoPlaneConvexOnes) {
    Scene scene = square();
    // Bent along the diagonal; an L; three vertices on a line.
    const auto bent = test::mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0.5}, {0, 1, 0}}, {{0, 1, 2, 3}});
    const auto concave =
        test::mesh({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}}, {{0, 1, 2, 3, 4, 5}});
    const auto flat = test::mesh({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 1, 2}, {2, 1, 0}});
    for (const auto& mesh : {bent, concave, flat}) scene.objects.push_back({"strange", mesh, {}, {}});
    std::vector<std::string> starts;
    for (const Remark& remark : sceneRemarks(scene)) {
        EXPECT_EQ(remark.about, "strange");
        starts.push_back(remark.text.substr(0, remark.text.find('.')));
    }
    EXPECT_EQ(starts,
              (std::vector<std::string>{"1 polygon of \"strange\" is not planar", "1 polygon of \"strange\" is concave",
                                        "2 polygons of \"strange\" are without area"}));
}

// The texts of the remarks about an object, or about a setting.
std::vector<std::string> textsAbout(const Scene& scene, std::string_view about) {
    std::vector<std::string> texts;
    for (const Remark& remark : sceneRemarks(scene))
        if (remark.about == about) texts.push_back(remark.text);
    return texts;
}
bool starts(const std::vector<std::string>& texts, std::string_view with) {
    return texts.size() == 1 && texts[0].starts_with(with);
}

// A scene of one mesh with normals, as it is read from a file: a quad and a triangle beside it in the plane z = 0, both
// counter-clockwise seen from +z.
Scene readWithNormals(const std::string& normals) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "scene.toml",
                    "normal_weight = \"given\"\n[[light]]\nposition = [0, 0, 1]\n[[object]]\nname = \"square\"\n"
                    "vertices = [[-5,-5,0],[5,-5,0],[5,5,0],[-5,5,0],[9,0,0]]\npolygons = [[0,1,2,3],[1,4,2]]\n"
                    "normals = [" +
                        normals + "]\n");
    Result<Scene> scene = readScene(folder / "scene.toml");
    EXPECT_TRUE(scene) << format(scene.errors());
    return scene ? *scene : Scene();
}

TEST(SceneRemarks, CountGivenNormalsOfLengthZeroAndAgainstTheWinding) {
    const auto texts = [](const char* normals) { return textsAbout(readWithNormals(normals), "square"); };
    EXPECT_TRUE(texts("[0,0,1],[0,0,1],[1,0,0],[0,0,1],[0,0,1]").empty());
    EXPECT_TRUE(starts(texts("[0,0,1],[0,0,0],[0,0,0],[0,0,1],[0,0,1]"),
                       "2 of the 5 normals that \"square\" gives have length 0."));
    // All normals of the triangle are turned; of the quad's two of four, slightly less than half of the sum.
    EXPECT_TRUE(starts(texts("[0,0,1],[0.1,0,-3],[0.1,0,-3],[0,0,1],[0.1,0,-3]"),
                       "The given normals of 1 polygon of \"square\" point against the winding"));
    EXPECT_TRUE(starts(texts("[0,0,-1],[0,0,-1],[0,0,-1],[0,0,-1],[0,0,-1]"), "The given normals of 2 polygons of"));
}

// The square is 10 wide. 2^20 = 1 048 576 times that far away float keeps 2^24 / 2^20 = 16 steps of it.
TEST(SceneRemarks, SayWhereFloatCannotHoldAMesh) {
    Scene scene = square();
    scene.settings.precision = Precision::Float;
    const auto texts = [&](double away) {
        scene.objects[0].transform.translation = {away, 0, 0};
        return textsAbout(scene, "square");
    };
    EXPECT_TRUE(texts(1e7).empty());
    const auto far = texts(1e8);
    EXPECT_TRUE(starts(far,
                       "\"square\" is 10000001 times as far from the origin as it is large: float rounds its "
                       "vertices to 2 steps"))
        << (far.empty() ? "" : far[0]);
    scene.settings.precision = Precision::Double;
    EXPECT_TRUE(texts(1e8).empty());
    // In the mesh itself: the translation brings it back, after float has rounded it.
    Mesh mesh = *scene.objects[0].mesh;
    test::moveVertices(mesh, [](Vec3d p) { return p + Vec3d(0, 1e8, 0); });
    scene.objects[0].mesh = makeMesh(std::move(mesh));
    scene.objects[0].transform.translation = {0, -1e8, 0};
    EXPECT_TRUE(textsAbout(scene, "square").empty());
    scene.settings.precision = Precision::Float;
    EXPECT_EQ(textsAbout(scene, "square").size(), 1u);
}

// The eye is at z = 5: the square at 5 from it, a second one at 2, a third behind it.
TEST(SceneRemarks, CountTheObjectsBeforeTheNearPlane) {
    Scene scene = square();
    for (const double z : {3.0, 8.0}) {
        scene.objects.push_back(scene.objects[0]);
        scene.objects.back().name = "at " + std::to_string(int(z));
        scene.objects.back().transform.translation = {0, 0, z};
    }
    EXPECT_TRUE(textsAbout(scene, "camera.near").empty());
    scene.camera.near = 1.9;
    EXPECT_TRUE(textsAbout(scene, "camera.near").empty());
    scene.camera.near = 2.1;
    EXPECT_TRUE(starts(textsAbout(scene, "camera.near"), "\"at 3\" lies before the near plane, which is 2.1 from"));
    scene.camera.near = 6;
    EXPECT_TRUE(starts(textsAbout(scene, "camera.near"), "2 objects, \"square\" the first of them, lie before"));
    scene.camera.projection = ProjectionKind::Orthographic;  // what is behind the eye is before the plane, too
    EXPECT_TRUE(starts(textsAbout(scene, "camera.near"), "3 objects,"));
    scene.camera.near = -4;
    EXPECT_TRUE(textsAbout(scene, "camera.near").empty());
}

TEST(SceneRemarks, OfTheReadersComeFirstAndManyAreCounted) {
    Scene scene = square();
    for (int i = 0; i < 99; ++i) scene.remarks.push_back({"m.gltf", std::to_string(i) + " cameras are not read."});
    scene.objects[0].transform.scale.x = -1;
    const std::vector<Remark> remarks = sceneRemarks(scene);
    ASSERT_EQ(remarks.size(), kMaxRemarks);
    EXPECT_EQ(remarks[0], scene.remarks[0]);
    // 99 + 1 in all, 63 of them listed.
    EXPECT_EQ(remarks.back(), (Remark{"", "37 more remarks are not listed."}));
}

// Of 55 objects 54 are mirrored, two of them with a scale of 0, which is another remark.
TEST(SceneRemarks, AlikeForManyObjectsAreOneWithTheFirstNames) {
    Scene scene = square();
    for (int i = 1; i < 55; ++i) {
        scene.objects.push_back(scene.objects[0]);
        scene.objects.back().name = "o" + std::to_string(i);
    }
    for (std::size_t i = 1; i < 55; ++i) scene.objects[i].transform.scale.x = i < 53 ? -1 : 0;
    const std::vector<Remark> expected{
        {"object.1.sx",
         "\"o1\" is mirrored: its outside stays outside. The same holds for 51 more (\"o2\", \"o3\", \"o4\", …)."},
        {"object.53.sx",
         "The scale of \"o53\" is 0 along x: it is flat. Polygons across the plane have no area, and nothing of them "
         "is "
         "drawn. The same holds for 1 more (\"o54\")."}};
    EXPECT_EQ(sceneRemarks(scene), expected);
}

}  // namespace
}  // namespace pipeline
