// What keeps a mesh of a million triangles from stopping the 3D view.
#include <gtest/gtest.h>

#include <random>

#include "app/view3d/view_content.h"

namespace {

using app::FaceTree;
using app::Vec3d;
using app::ViewContent;

// Triangles up to 0.2 wide in a cube of 2, every tenth the same as the one before it, and one without a place.
ViewContent soup(std::mt19937& random) {
    std::uniform_real_distribution<double> place(-1, 1), edge(-0.1, 0.1);
    const auto vector = [&](auto& along) { return Vec3d(along(random), along(random), along(random)); };
    auto mesh = std::make_shared<app::ViewMesh>();
    for (std::uint32_t i = 0; i < 3000; ++i) {
        const Vec3d middle = vector(place);
        for (int corner = 0; corner < 3; ++corner)
            mesh->positions.push_back(i % 10 == 9 ? mesh->positions[mesh->positions.size() - 3]
                                                  : middle + vector(edge));
        mesh->faces.push_back({{3 * i, 3 * i + 1, 3 * i + 2}, {}, std::int32_t(i)});
    }
    mesh->positions[300].x = NAN;
    ViewContent content;
    content.mesh = mesh;
    return content;
}

TEST(View3dFaceTree, FindsTheFirstFaceThatLookingAtAllFinds) {
    std::mt19937 random(7);
    const ViewContent all = soup(random);
    auto mesh = std::make_shared<app::ViewMesh>(*all.mesh);
    mesh->tree = std::make_shared<const FaceTree>(
        pipeline::rays::makeTree<double>(std::uint32_t(mesh->faces.size()), [&](std::uint32_t i) {
            return pipeline::rays::Corners<double>{mesh->positions[3 * i], mesh->positions[3 * i + 1],
                                                   mesh->positions[3 * i + 2]};
        }));
    ViewContent few = all;
    few.mesh = mesh;
    std::uniform_real_distribution<double> place(-2, 2);
    int hits = 0;
    for (int i = 0; i < 2000; ++i) {
        Vec3d origin(place(random), place(random), place(random)), direction(place(random), place(random), 1);
        if (i % 4 == 0) direction = Vec3d(0, 0, i % 8 == 0 ? 1 : -1);  // along an axis
        const app::Ray ray{origin, glm::normalize(direction)};
        const auto expected = firstHit(all, ray), found = firstHit(few, ray);
        ASSERT_EQ(found.has_value(), expected.has_value());
        if (!found) continue;
        ++hits;
        EXPECT_EQ(found->polygon, expected->polygon);
        EXPECT_EQ(found->distance, expected->distance);
    }
    EXPECT_GT(hits, 200);
}

}  // namespace
