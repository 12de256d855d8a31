// What the program chooses for a model that is opened by itself, and says: the axis that is up, the camera, the model.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "pipeline/formats/model_scene.h"
#include "pipeline/plan/scene_remarks.h"
#include "pipeline/scene/framing.h"
#include "pipeline/scene/settings_table.h"
#include "tests/support/gltf_files.h"

namespace pipeline::model_choices {
namespace {

using test::filesOf, test::fileOf, test::squareParts;

Scene sceneOf(const std::string& text, const std::string& name, const FileLoader& load = filesOf({})) {
    const Result<Scene> scene = readModelScene({text, name}, load);
    EXPECT_TRUE(scene) << (scene ? "" : format(scene.errors()));
    return scene ? *scene : Scene();
}
Scene with(Scene scene, const std::vector<std::string>& assignments) {
    for (const std::string& assignment : assignments) {
        auto changed = withSetting(std::move(scene), assignment);
        EXPECT_TRUE(changed) << (changed ? "" : format(changed.errors()));
        scene = std::move(changed).value();
    }
    return scene;
}

// What is said about the axis, while it is the one that was guessed.
std::string saidOfUp(const Scene& scene) {
    const auto remarks = sceneRemarks(scene);
    const auto remark = std::ranges::find(remarks, "up", &Remark::about);
    return remark == remarks.end() ? "" : remark->text;
}

// Heights 2 + sin x + cos y over a grid of 13 by 13 units, some 0.3 of that high.
std::string heights(bool zIsUp, bool clockwise) {
    std::string text;
    for (int v = 0; v < 14; ++v)
        for (int u = 0; u < 14; ++u) {
            const double h = 2 + 0.8 * std::sin(u) + 0.6 * std::cos(v);
            text += zIsUp ? fmt::format("v {} {} {}\n", u - 7, v - 7, h) : fmt::format("v {} {} {}\n", u - 7, h, 7 - v);
        }
    for (int v = 0; v < 13; ++v)
        for (int u = 0; u < 13; ++u) {
            const int a = 1 + 14 * v + u, b = a + 1, c = b + 14, d = a + 14;
            text += clockwise ? fmt::format("f {} {} {} {}\n", d, c, b, a) : fmt::format("f {} {} {} {}\n", a, b, c, d);
        }
    return text;
}

// A box from (-50, y, z) to (50, y + 100, z + 2).
std::string plate(double y, double z) {
    std::string text;
    for (int i = 0; i < 8; ++i)
        text += fmt::format("v {} {} {}\n", i & 1 ? 50 : -50, i & 2 ? y + 100 : y, i & 4 ? z + 2 : z);
    return text + "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
}

TEST(ModelChoices, ObjAndPlyAreYUpUnlessTheySayOtherwise) {
    // The seat, the back and a leg of a chair: nothing tells.
    const std::string chair =
        "v -2 0 -2\nv 2 0 -2\nv 2 .4 2\nv -2 .4 2\nv -2 3 -2\nv 2 3 -2\nv -2 -2.5 -2\nf 1 4 3 2\nf 1 2 6 5\nf 1 2 7\n";
    const std::string corners = "3 0 1 2\n";
    const std::string ply =
        "format ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n3 0 1\n1 4 2\n";
    struct Case {
        std::string text, name;
        UpAxis up;
        std::string why;
    };
    const Case cases[] = {
        {chair, "m.obj", UpAxis::Y, "as in most OBJ and PLY files"},
        {"ply\n" + ply + corners, "m.ply", UpAxis::Y, "as in most OBJ and PLY files"},
        {"# exported, Z-up\n" + chair, "m.obj", UpAxis::Z, "its comments say so"},
        {"# up axis: z\n" + chair, "m.obj", UpAxis::Z, "its comments say so"},
        {"# FreeCAD v0.20\n" + chair, "m.obj", UpAxis::Z, "its comments name FreeCAD"},
        {"# Blender v2.79\n" + chair, "m.obj", UpAxis::Y, "its comments name Blender"},
        {"ply\ncomment Created by Blender 2.77\n" + ply + corners, "m.ply", UpAxis::Z, "its comments name Blender"},
        {"o Floor\nv 0 0 0\nv 0 0 9\nv 9 0 0\nf 1 2 3\n", "m.obj", UpAxis::Y, "its object \"Floor\" is flat along y"},
        {"o Floor\nv 0 0 0\nv 9 0 0\nv 0 9 0\nf 1 2 3\n", "m.obj", UpAxis::Z, "its object \"Floor\" is flat along z"},
        {heights(true, false), "m.obj", UpAxis::Z, "its polygons are heights over a plane, thin along z"},
        {heights(true, true), "m.obj", UpAxis::Z, "its polygons are heights over a plane, thin along z"},
        {heights(false, false), "m.obj", UpAxis::Y, "its polygons are heights over a plane, thin along y"},
        // x and y from -65 to 65, z from 0 to 40.
        {"v -65 -65 0\nv 65 -65 0\nv 65 65 0\nv 0 0 40\nf 1 2 4\nf 2 3 4\nf 3 1 4\n", "m.obj", UpAxis::Z,
         "it begins at 0 along z and lies around 0 along x and y"},
        {"v -1 0 -1\nv 1 0 -1\nv 0 0 1\nv 0 3 0\nf 1 2 3\nf 1 4 2\nf 2 4 3\nf 3 4 1\n", "m.obj", UpAxis::Y,
         "it begins at 0 along y and lies around 0 along x and z"},
        // A bed of 100 by 100 by 2; a wall of the same size stands on y = 0.
        {plate(-50, -1), "m.obj", UpAxis::Z, "it is a plate around 0, thin along z"},
        {plate(0, 10), "m.obj", UpAxis::Y, "as in most OBJ and PLY files"},
        // Long along z, as vehicles are.
        {"v 0 1 -9\nv 2 1 9\nv 0 2 9\nv 2 4 -9\nf 1 2 3\nf 1 2 4\n", "m.obj", UpAxis::Y,
         "as in most OBJ and PLY files"},
        {"solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
         "2\nendloop\nendfacet\nendsolid\n",
         "m.stl", UpAxis::Z, "as in most STL files"},
    };
    for (const Case& one : cases) {
        const Scene scene = sceneOf(one.text, one.name);
        EXPECT_EQ(upOf(scene), one.up) << one.text;
        const char up = one.up == UpAxis::Y ? 'y' : 'z', other = one.up == UpAxis::Y ? 'z' : 'y';
        EXPECT_EQ(saidOfUp(scene),
                  fmt::format("{} of the file is taken to point up: {}; up={} turns it.", up, one.why, other));
        EXPECT_EQ(saidOfUp(with(scene, {fmt::format("up={}", other)})), "") << "no guess any more";
    }
    EXPECT_EQ(saidOfUp(sceneOf(fileOf(squareParts()), "m.gltf")), "y of the file points up, as in every glTF file.");
}

// A terrain of which the fronts face down is looked at from below; that is said until the camera is moved.
TEST(ModelChoices, ACameraBelowATerrainSaysSo) {
    const auto about = [](const Scene& scene) {
        const auto remarks = sceneRemarks(scene);
        return std::ranges::find(remarks, "camera.phi", &Remark::about) != remarks.end();
    };
    const Scene above = sceneOf(heights(true, false), "m.obj"), below = sceneOf(heights(true, true), "m.obj");
    EXPECT_LT(above.camera.phi, 90);
    EXPECT_FALSE(about(above));
    EXPECT_GT(below.camera.phi, 90);
    EXPECT_TRUE(about(below));
    EXPECT_FALSE(about(with(below, {"camera.phi=60"})));
}

// OpenGL's model is chosen for the lamp, and takes n up to 128.
TEST(ModelChoices, AnAutomaticChoiceRefusesNoFile) {
    const Scene scene =
        sceneOf("mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl lamp\nf 1 2 3\nusemtl polished\nf 1 3 2\n", "m.obj",
                filesOf({{"m.mtl", "newmtl lamp\nKe 1 0.9 0.6\nnewmtl polished\nKs .5 .5 .5\nNs 200\n"}}));
    EXPECT_EQ(scene.settings.model, Model::OpenGl);
    EXPECT_TRUE(checkScene(scene).empty()) << format(checkScene(scene));
    EXPECT_EQ(scene.objects[1].material.exponent, 128);
    const auto keys = [](const Scene& of) {
        std::set<std::string> all;
        for (const Remark& remark : sceneRemarks(of)) all.insert(remark.about);
        return all;
    };
    EXPECT_TRUE(keys(scene).contains("material.1.n") && keys(scene).contains("model"));
    // What is set then comes first, and what was chosen before it is not said.
    const Scene set = with(scene, {"model=blinn-phong", "material.1.n=200"});
    EXPECT_TRUE(checkScene(set).empty());
    EXPECT_FALSE(keys(set).contains("material.1.n"));
    for (const Remark& remark : sceneRemarks(set))
        EXPECT_EQ(remark.text.find("model=opengl is set"), std::string::npos);
}

}  // namespace
}  // namespace pipeline::model_choices
