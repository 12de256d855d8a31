// Colours of vertices: read from files, multiplied into k_d and k_a, interpolated as the shading demands.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "pipeline/contracts/contract.h"
#include "pipeline/export/buffers/gl_calls.h"
#include "pipeline/formats/model_reader.h"
#include "pipeline/formats/model_scene.h"
#include "pipeline/formats/toml/toml_scene.h"
#include "pipeline/formats/toml/toml_writer.h"
#include "pipeline/inspect/pixel_report.h"
#include "pipeline/run/frame_data.h"
#include "pipeline/study/errors.h"
#include "tests/support/gltf_files.h"
#include "tests/support/rays.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

using B = BufferId;
using test::bytesOf, test::dataUri, test::Parts;

LoadedModel modelOf(const std::string& text, const char* extension, const test::Parts& files = {}) {
    const Result<LoadedModel> model =
        readModel({text, std::string("m") + extension}, extension, test::filesOf({files.begin(), files.end()}));
    EXPECT_TRUE(model) << (model ? "" : format(model.errors()));
    return model ? *model : LoadedModel{};
}
std::string colorsOf(const LoadedModel& model) {
    std::string text;
    for (const Object& object : model.objects)
        for (const Vec3d& c : object.mesh->colors) text += fmt::format("{:g} {:g} {:g}, ", c.x, c.y, c.z);
    return text;
}
std::string remarkTextOf(const LoadedModel& model) {
    std::string text;
    for (const Remark& remark : model.remarks) text += remark.text + '\n';
    return text;
}

TEST(VertexColors, AreReadFromObj) {
    const LoadedModel model = modelOf("v 0 0 0 1 0 0\nv 4 0 0 0 1 0\nv 4 3 0\nf 1 2 3\n", ".obj");
    EXPECT_EQ(colorsOf(model), "1 0 0, 0 1 0, 1 1 1, ");  // one without is white
    EXPECT_EQ(remarkTextOf(model), "");
    EXPECT_EQ(model.objects[0].material.diffuse, Vec3d(1));
    EXPECT_EQ(model.objects[0].material.ambient, Vec3d(1));
    // With a weight before them; a lone weight is none.
    EXPECT_EQ(colorsOf(modelOf("v 0 0 0 1 0.5 0 0\nv 4 0 0 1\nv 4 3 0 1\nf 1 2 3\n", ".obj")),
              "0.5 0 0, 1 1 1, 1 1 1, ");
    const LoadedModel bytes = modelOf("v 0 0 0 255 0 51\nv 4 0 0 0 0 1\nv 4 3 0 0 0 0\nf 1 2 3\n", ".obj");
    EXPECT_EQ(colorsOf(bytes), "1 0 0.2, 0 0 0.00392157, 0 0 0, ");
    EXPECT_EQ(remarkTextOf(bytes), "Colours of vertices are above 1: all are taken as written from 0 to 255.\n");
    const LoadedModel wrong = modelOf("v 0 0 0 -1 0 0\nv 4 0 0 0 x 0\nv 4 3 0 0 0 0\nf 1 2 3\n", ".obj");
    EXPECT_EQ(colorsOf(wrong), "1 1 1, 1 1 1, 0 0 0, ");
    EXPECT_EQ(remarkTextOf(wrong), "2 colours of vertices, not three numbers from 0 up, are taken as white.\n");
    // Many programs write white.
    EXPECT_EQ(colorsOf(modelOf("v 0 0 0 1 1 1\nv 4 0 0 1 1 1\nv 4 3 0 1 1 1\nf 1 2 3\n", ".obj")), "");
    // k_d of the file's material is multiplied by them.
    const LoadedModel both = modelOf("mtllib a.mtl\nusemtl a\nv 0 0 0 1 0 0\nv 4 0 0 0 1 0\nv 4 3 0 0 0 1\nf 1 2 3\n",
                                     ".obj", {{"a.mtl", "newmtl a\nKd 0.5 0.25 1\n"}});
    EXPECT_EQ(both.objects[0].material.diffuse, Vec3d(0.5, 0.25, 1));
    EXPECT_EQ(colorsOf(both), "1 0 0, 0 1 0, 0 0 1, ");
}

// Flat shading would give the one triangle one colour.
TEST(VertexColors, AModelOpensWithThemInterpolated) {
    const Result<Scene> scene =
        readModelScene({"v 0 0 0 1 0 0\nv 4 0 0 0 1 0\nv 4 3 0 0 0 1\nf 1 2 3\n", "a.obj"}, test::filesOf({}));
    ASSERT_TRUE(scene);
    EXPECT_EQ(scene->settings.shading, Shading::Phong);
}

// Vertex 1 is used by no polygon: the colours of the others stay theirs.
TEST(VertexColors, AreReadFromPly) {
    const auto ply = [](const char* type, const char* names, const char* rows) {
        std::string text =
            "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
            "property float z\n";
        for (const char* name = names; *name; ++name)
            text += fmt::format("property {} {}\n", type,
                                *name == 'r'   ? "red"
                                : *name == 'g' ? "green"
                                : *name == 'b' ? "blue"
                                               : "alpha");
        return text + "element face 1\nproperty list uchar int vertex_indices\nend_header\n" + rows + "3 0 2 3\n";
    };
    EXPECT_EQ(
        colorsOf(modelOf(ply("uchar", "rgb", "0 0 0 255 0 0\n9 9 9 1 1 1\n1 0 0 0 51 0\n0 1 0 0 0 102\n"), ".ply")),
        "1 0 0, 0 0.2 0, 0 0 0.4, ");
    EXPECT_EQ(colorsOf(modelOf(ply("float", "rgb", "0 0 0 1 0 0\n9 9 9 1 1 1\n1 0 0 0 .5 0\n0 1 0 nan 0 0\n"), ".ply")),
              "1 0 0, 0 0.5 0, 1 1 1, ");
    const LoadedModel opaque =
        modelOf(ply("uchar", "rgba", "0 0 0 255 0 0 9\n9 9 9 1 1 1 9\n1 0 0 0 51 0 9\n0 1 0 0 0 102 9\n"), ".ply");
    EXPECT_EQ(remarkTextOf(opaque), "\"alpha\" of 4 rows of the element \"vertex\" is not read.\n");
    const LoadedModel two = modelOf(ply("uchar", "rg", "0 0 0 255 0\n9 9 9 1 1\n1 0 0 0 51\n0 1 0 0 0\n"), ".ply");
    EXPECT_EQ(colorsOf(two), "");
    EXPECT_EQ(remarkTextOf(two), "The colours of 4 rows of the element \"vertex\" are not read.\n");
}

// Normalised 16-bit colours with opacity: 65535 is 1. Two corners at one place with different colours stay two vertices.
TEST(VertexColors, AreReadFromGltf) {
    Parts parts = test::squareParts();
    const std::string positions = bytesOf<float>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0}),
                      indices = bytesOf<std::uint16_t>({0, 1, 2, 3, 1, 2}),
                      colors = bytesOf<std::uint16_t>({65535, 0, 0, 1, 0, 13107, 0, 1, 0, 0, 0, 1, 0, 0, 65535, 1});
    parts["buffers"] = fmt::format(R"([{{"byteLength": 92, "uri": "{}"}}])", dataUri(positions + indices + colors));
    parts["bufferViews"] = R"([{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 12},
                               {"buffer": 0, "byteOffset": 60, "byteLength": 32}])";
    parts["accessors"] = R"([{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
                             {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"},
                             {"bufferView": 2, "componentType": 5123, "normalized": true, "count": 4, "type": "VEC4"}])";
    parts["meshes"] = R"([{"primitives": [{"attributes": {"POSITION": 0, "COLOR_0": 2}, "indices": 1}]}])";
    const LoadedModel model = modelOf(test::fileOf(parts), ".gltf");
    EXPECT_EQ(colorsOf(model), "1 0 0, 0 0.2 0, 0 0 0, 0 0 1, ");
    EXPECT_EQ(model.objects.at(0).material.diffuse, Vec3d(1));
    EXPECT_EQ(remarkTextOf(model), "");
}

// Facing the eye: red, green and blue at the vertices.
Scene triangle(Shading shading, Interpolation interpolation = Interpolation::Perspective) {
    Scene scene;
    scene.settings.width = 60, scene.settings.height = 48;
    scene.settings.shading = shading, scene.settings.interpolation = interpolation;
    scene.settings.precision = Precision::Double;
    scene.camera.kind = CameraKind::LookAt, scene.camera.eye = {0.3, -4, 0.5}, scene.camera.target = Vec3d(0);
    Mesh mesh;
    mesh.positions = {{-1.5, 0, -1}, {1.5, 1, -1}, {0, -1, 1.2}};
    mesh.colors = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh.addPolygon(std::vector<std::uint32_t>{0, 1, 2});
    scene.objects.push_back({"rgb", makeMesh(std::move(mesh)), {}, {Vec3d(0.5), Vec3d(0.25), 8, Vec3d(0.5)}});
    scene.lights.push_back({LightKind::Point, {1, -5, 3}, 100, Vec3d(1), false});
    scene.ambient.intensity = 8;
    return scene;
}
template <class Use>
void forEachSeen(const Frame& frame, Use use) {
    const auto polygon = frame.buffer({B::PolygonId});
    std::size_t seen = 0;
    for (int y = 0; y < frame.scene().settings.height; ++y)
        for (int x = 0; x < frame.scene().settings.width; ++x)
            if (const std::size_t i = std::size_t(y) * 60 + std::size_t(x); polygon->flat(i) >= 0) ++seen, use(i);
    EXPECT_GT(seen, 200u);
}
Vec3d at(const Frame& frame, const BufferName& name, std::size_t i) {
    const auto buffer = frame.buffer(name);
    return {buffer->flat(3 * i), buffer->flat(3 * i + 1), buffer->flat(3 * i + 2)};
}
void expectNear(const Vec3d& is, const Vec3d& expected, double bound) {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(is[c], expected[c], bound);
}

// Where only the colours vary: k_a I_a = 0.5 · 8 times the barycentric coordinates, since vertex i has the i-th unit vector.
// Flat shading has the mean of the vertices, in OpenGL's model the first. 16 roundings of numbers up to 4 at most.
TEST(VertexColors, AreInterpolatedAsTheShadingDemands) {
    constexpr double kRounding = 16 * 4 * 0x1p-53;
    for (const Shading shading : {Shading::Phong, Shading::Gouraud}) {
        const FramePtr frame = test::frameOf(triangle(shading));
        forEachSeen(*frame, [&](std::size_t i) {
            expectNear(at(*frame, {B::Ambient}, i), 4.0 * at(*frame, {B::Barycentric}, i), kRounding);
            expectNear(at(*frame, {B::DiffuseCoefficient}, i), 0.5 * at(*frame, {B::Barycentric}, i), kRounding);
        });
    }
    Scene flat = triangle(Shading::Flat);
    for (const auto& [model, color] : {std::pair{Model::Phong, Vec3d(1.0 / 3)}, {Model::OpenGl, Vec3d(1, 0, 0)}}) {
        flat.settings.model = model;
        flat.lights[0].intensity = 0.2, flat.ambient.intensity = 0.5;
        const FramePtr frame = test::frameOf(flat);
        forEachSeen(*frame, [&](std::size_t i) {
            expectNear(at(*frame, {B::Ambient}, i), 0.25 * color, kRounding);
            expectNear(at(*frame, {B::DiffuseCoefficient}, i), 0.5 * color, kRounding);
        });
    }
}

// A diffuse term is that of the same scene without colours, times the colour; the specular one is the same.
TEST(VertexColors, MultiplyTheDiffuseTermAlone) {
    for (const Model model : {Model::Phong, Model::BlinnPhong, Model::CookTorrance}) {
        Scene scene = triangle(Shading::Phong);
        scene.settings.model = model;
        const FramePtr colored = test::frameOf(scene);
        Mesh plain = *scene.objects[0].mesh;
        plain.colors.clear();
        scene.objects[0].mesh = makeMesh(std::move(plain));
        const FramePtr white = test::frameOf(scene);
        forEachSeen(*colored, [&](std::size_t i) {
            const Vec3d diffuse = at(*white, {B::Diffuse, 0}, i);
            expectNear(at(*colored, {B::Diffuse, 0}, i), diffuse * at(*colored, {B::Barycentric}, i),
                       8 * 0x1p-53 * diffuse.x);
            EXPECT_EQ(at(*colored, {B::Specular, 0}, i), at(*white, {B::Specular, 0}, i));
        });
    }
}

// Float has the same numbers as double but for its rounding: the scalar stage takes the place of the vectors.
TEST(VertexColors, AreShadedOneByOneInFloat) {
    Scene scene = triangle(Shading::Phong);
    const FramePtr wide = test::frameOf(scene);
    scene.settings.precision = Precision::Float;
    const FramePtr narrow = test::frameOf(scene, setOf({B::Color, B::Intensity, B::PolygonId}));
    forEachSeen(*narrow, [&](std::size_t i) {
        if (wide->buffer({B::PolygonId})->flat(i) < 0) return;
        expectNear(at(*narrow, {B::Intensity}, i), at(*wide, {B::Intensity}, i), 1e-4 * 100);
    });
    EXPECT_EQ(
        readStages(*narrow, [](const auto& data) { return bool(data.keys.shading.parts[Part::ShadedInVectors]); }),
        false);
}

// Rays share no code with the stages above the scene.
TEST(VertexColors, LookTheSameByRays) {
    for (const Shading shading : {Shading::Phong, Shading::Gouraud, Shading::Flat})
        for (const Interpolation interpolation : {Interpolation::Perspective, Interpolation::Scanline}) {
            const FramePtr frame = test::frameOf(triangle(shading, interpolation), picturesNeed());
            const test::RayComparison found = test::compareWithRays(*frame);
            EXPECT_EQ(found.different, "") << int(shading) << ' ' << int(interpolation);
            EXPECT_GT(found.seen, 200);
        }
}

TEST(VertexColors, HoldWhatContractsAsk) {
    for (const Shading shading : {Shading::Phong, Shading::Gouraud, Shading::Flat}) {
        const FramePtr frame = test::frameOf(triangle(shading), contractBuffers());
        const ContractInput input = contractInput(*frame);
        for (const ContractResult& result : checkContracts(input)) EXPECT_TRUE(result.holds()) << result.name();
    }
}

// The inspector evaluates again: what it says is what the buffers hold, and its equation comes to the intensity.
TEST(VertexColors, AreInTheEquationOfAPixel) {
    for (const Shading shading : {Shading::Phong, Shading::Gouraud, Shading::Flat}) {
        const FramePtr frame = test::frameOf(triangle(shading));
        const PixelReport report = inspectPixel(*frame, {30, 24});
        ASSERT_TRUE(report.covered);
        const std::size_t i = 24 * 60 + 30;
        EXPECT_EQ(report.ambient, at(*frame, {B::Ambient}, i));
        EXPECT_EQ(report.diffuse.at(0), at(*frame, {B::Diffuse, 0}, i));
        EXPECT_EQ(report.intensity, at(*frame, {B::Intensity}, i));
    }
}

TEST(VertexColors, AreWrittenAndReadInScenes) {
    const Scene scene = triangle(Shading::Gouraud);
    const auto text = toTomlScene(scene);
    ASSERT_TRUE(text);
    const auto none = [](std::string_view) -> Result<NamedFile> { return Error(); };
    const auto again = readTomlScene({*text, "s.toml"}, none);
    ASSERT_TRUE(again) << format(again.errors());
    EXPECT_EQ(again->objects[0].mesh->colors, scene.objects[0].mesh->colors);
    EXPECT_EQ(test::firstDifference(*test::frameOf(scene), *test::frameOf(*again)), "");
    const auto wrong = readTomlScene({"[[object]]\nvertices = [[0,0,0],[1,0,0],[0,1,0]]\npolygons = [[0,1,2]]\n"
                                      "colors = [[1,0,0],[0,-1,0]]\n",
                                      "s.toml"},
                                     none);
    ASSERT_FALSE(wrong);
    EXPECT_NE(format(wrong.errors()).find("s.toml:4:"), std::string::npos) << format(wrong.errors());
}

TEST(VertexColors, AreNotInOpenGlsCalls) {
    Scene scene = triangle(Shading::Gouraud);
    scene.settings.model = Model::OpenGl;
    EXPECT_NE(glRefuses(scene).find("colours of vertices"), std::string::npos);
}

}  // namespace
}  // namespace pipeline
