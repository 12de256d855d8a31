// What is said about the meshes of a file that is read: turned inside out, or two in one plane.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>

#include "pipeline/formats/scene_reader.h"
#include "pipeline/plan/scene_remarks.h"
#include "tests/support/files.h"

namespace pipeline::mesh_remarks {
namespace {

// The eight corners of a box and its six sides, counter-clockwise seen from outside; inside out: the other way.
struct Boxes {
    std::vector<Vec3d> positions{};
    std::vector<std::vector<std::uint32_t>> polygons{};
    void add(Vec3d low, Vec3d high, bool insideOut) {
        const auto first = std::uint32_t(positions.size());
        for (unsigned i = 0; i < 8; ++i)
            positions.emplace_back(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z);
        for (std::vector<std::uint32_t> side : std::vector<std::vector<std::uint32_t>>{
                 {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
            for (std::uint32_t& corner : side) corner += first;
            if (insideOut) std::ranges::reverse(side);
            polygons.push_back(side);
        }
    }
    // As a file of them is read.
    Scene scene() const {
        std::string text = "o box\n";
        for (const Vec3d& p : positions) text += fmt::format("v {} {} {}\n", p.x, p.y, p.z);
        for (const std::vector<std::uint32_t>& polygon : polygons) {
            text += 'f';
            for (const std::uint32_t corner : polygon) text += fmt::format(" {}", corner + 1);
            text += '\n';
        }
        const test::TemporaryFolder folder;
        test::writeText(folder / "m.obj", text);
        const Result<Scene> scene = readScene(folder / "m.obj");
        EXPECT_TRUE(scene) << (scene ? "" : format(scene.errors()));
        return scene ? *scene : Scene();
    }
};
std::vector<std::string> said(const Scene& scene) {
    std::vector<std::string> texts;
    for (const Remark& remark : sceneRemarks(scene))
        if (remark.about != "up") texts.push_back(remark.text);
    return texts;
}
constexpr char kShowsBoth[] = "cull=none with two_sided=on shows and lights both sides.";

TEST(MeshRemarks, SayWhereAClosedMeshIsInsideOut) {
    Boxes right, wholly, partly, hollow, turned;
    right.add({-1, -1, -1}, {1, 1, 1}, false);
    wholly.add({-1, -1, -1}, {1, 1, 1}, true);
    partly.add({-3, -1, -1}, {-1, 1, 1}, false), partly.add({1, -1, -1}, {3, 1, 1}, true);
    hollow.add({-3, -3, -3}, {3, 3, 3}, false), hollow.add({-1, -1, -1}, {1, 1, 1}, true);
    turned.add({-1, -1, -1}, {1, 1, 1}, false);
    std::ranges::reverse(turned.polygons[4]);
    EXPECT_TRUE(said(right.scene()).empty());
    EXPECT_TRUE(said(hollow.scene()).empty()) << "the walls of a cavity wind as they should";
    const std::string rest = " run clockwise, as backs do. Reverse the order of their vertices; ";
    EXPECT_EQ(
        said(wholly.scene()),
        std::vector{"\"box\" is closed and turned inside out: seen from outside its polygons" + rest + kShowsBoth});
    EXPECT_EQ(said(partly.scene()),
              std::vector{"6 polygons of \"box\" are turned inside out: seen from outside they" + rest + kShowsBoth});
    EXPECT_EQ(said(turned.scene()),
              std::vector{"At 4 edges of \"box\" both polygons run along the edge the same way: one of the two is "
                          "turned inside out. " +
                          std::string(kShowsBoth)});
}

// An open box is neither; nor is one whose size or place leaves few digits for the sign of its volume.
TEST(MeshRemarks, AnOpenOrFlatMeshIsNotInsideOut) {
    Boxes open, flat, far;
    open.add({-1, -1, -1}, {1, 1, 1}, true), open.polygons.pop_back();
    EXPECT_TRUE(said(open.scene()).empty());
    flat.add({-1, -1, 0}, {1, 1, 0}, true);
    for (const std::string& text : said(flat.scene())) EXPECT_EQ(text.find("inside out"), text.npos) << text;
    far.add({9e7 - 1, -9e7, 9e7 - 1}, {9e7, -9e7 + 1, 9e7}, true), far.add({-9e7, 0, 0}, {1 - 9e7, 1, 1}, false);
    EXPECT_TRUE(said(far.scene()).at(0).starts_with("6 polygons of")) << said(far.scene()).at(0);
}

// A floor of 10 by 10, and a rug of 2 by 2 upon it at some height, from x on.
TEST(MeshRemarks, CoplanarPolygonsOfTwoObjectsThatOverlapFight) {
    const auto fights = [](double x, double height, bool turned) {
        const test::TemporaryFolder folder;
        test::writeText(folder / "m.obj",
                        fmt::format("o ground\nv 0 0 0\nv 10 0 0\nv 10 10 0\nv 0 10 0\nf 1 2 3 4\no rug\n"
                                    "v {0} 1 {1}\nv {2} 1 {1}\nv {2} 3 {1}\nv {0} 3 {1}\nf {3}\n",
                                    x, height, x + 2, turned ? "8 7 6 5" : "5 6 7 8"));
        const Result<Scene> scene = readScene(folder / "m.obj");
        EXPECT_TRUE(scene);
        return std::ranges::any_of(scene->remarks, [](const Remark& remark) {
            return remark.about == "rug" &&
                   remark.text.starts_with("Polygons of \"ground\" and \"rug\" lie in the same");
        });
    };
    EXPECT_TRUE(fights(4, 0, false));
    EXPECT_TRUE(fights(9, 0, false)) << "it hangs over";
    EXPECT_FALSE(fights(4, 0.01, false)) << "above it";
    EXPECT_FALSE(fights(10, 0, false)) << "beside it, with a common edge";
    EXPECT_FALSE(fights(4, 0, true)) << "the other way round: one of them is a back";
}

}  // namespace
}  // namespace pipeline::mesh_remarks
