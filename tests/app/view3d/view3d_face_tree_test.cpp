// What keeps a mesh of a million triangles from stopping the 3D view.
#include <gtest/gtest.h>

#include <random>

#include "app/drawing3d/space_content.h"

namespace {

using app::FaceTree;
using app::Vec3d;
using app::ViewContent;
using app::ViewSpace;

// Triangles up to 0.2 wide in a cube of 2, every tenth the same as the one before it, and one without a place.
ViewContent soup(std::mt19937& random) {
    std::uniform_real_distribution<double> place(-1, 1), edge(-0.1, 0.1);
    const auto vector = [&](auto& along) { return Vec3d{along(random), along(random), along(random)}; };
    auto mesh = std::make_shared<app::ViewMesh>();
    for (std::uint32_t i = 0; i < 3000; ++i) {
        const Vec3d middle = vector(place);
        for (int corner = 0; corner < 3; ++corner)
            mesh->positions.push_back(i % 10 == 9 ? mesh->positions[mesh->positions.size() - 3]
                                                  : middle + vector(edge));
        mesh->faces.push_back({{3 * i, 3 * i + 1, 3 * i + 2}, std::int32_t(i)});
    }
    mesh->positions[300].x = NAN;
    ViewContent content;
    content.mesh = mesh;
    return content;
}

struct Soup {
    ViewContent all, few;  // without a tree, and with one
};

Soup bothWays(std::mt19937& random) {
    const ViewContent all = soup(random);
    auto mesh = std::make_shared<app::ViewMesh>(*all.mesh);
    mesh->tree = std::make_shared<const FaceTree>(
        pipeline::rays::makeTree<double>(std::uint32_t(mesh->faces.size()), [&](std::uint32_t i) {
            return pipeline::rays::Corners<double>{mesh->positions[3 * i], mesh->positions[3 * i + 1],
                                                   mesh->positions[3 * i + 2]};
        }));
    ViewContent few = all;
    few.mesh = mesh;
    return {all, few};
}

// From (0, -0.9, 0) along y: 200 by 200 pixels, near 0.2, far 1.5, so that both planes pass through the cube.
pipeline::View intoTheCube(bool perspective) {
    pipeline::View view;
    view.eye = {0, -0.9, 0};
    view.right = {1, 0, 0};
    view.up = {0, 0, 1};
    view.forward = {0, 1, 0};
    view.scale = {100, 100};
    view.size = {200, 200};
    view.centre = {100, 100};
    view.near = 0.2;
    view.far = 1.5;
    view.perspective = perspective;
    return view;
}

TEST(View3dFaceTree, FindsTheFirstFaceThatLookingAtAllFinds) {
    std::mt19937 random(7);
    const auto [all, few] = bothWays(random);
    std::uniform_real_distribution<double> place(-2, 2);
    int hits = 0;
    for (int i = 0; i < 2000; ++i) {
        Vec3d origin{place(random), place(random), place(random)}, direction{place(random), place(random), 1};
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

// The eye stands in the cube's side and looks in, so that many triangles are cut, and rays come from everywhere.
TEST(View3dFaceTree, FindsInEverySpaceWhatLookingAtAllFinds) {
    std::mt19937 random(8);
    const Soup soup = bothWays(random);
    std::uniform_real_distribution<double> place(-1, 1);
    for (const bool perspective : {true, false})
        for (const ViewSpace space : {ViewSpace::Eye, ViewSpace::Clip, ViewSpace::Screen}) {
            ViewContent all = soup.all, few = soup.few;
            all.eye = few.eye = intoTheCube(perspective);
            const app::SpaceMap map{.space = space, .view = all.eye};
            all = inSpace(all, map), few = inSpace(few, map);
            const Vec3d low = space == ViewSpace::Screen ? Vec3d(0.0) : Vec3d(-1.0);
            const Vec3d high = space == ViewSpace::Screen ? Vec3d(200, 200, 200) : Vec3d(1.0);
            const auto somewhere = [&] {
                return (low + high) / 2.0 + (high - low) * Vec3d{place(random), place(random), place(random)};
            };
            int hits = 0;
            for (int i = 0; i < 600; ++i) {
                const Vec3d from = somewhere();
                Vec3d direction = somewhere() - from;
                if (i % 4 == 0) direction[1] = 0;                             // at one depth
                if (i % 4 == 1) direction = Vec3d(0, i % 8 < 4 ? 1 : -1, 0);  // along it, and back
                const app::Ray ray{from, glm::normalize(direction)};
                const auto expected = firstHit(all, ray), found = firstHit(few, ray);
                ASSERT_EQ(found.has_value(), expected.has_value()) << int(space) << ' ' << i;
                if (!found) continue;
                ++hits;
                EXPECT_EQ(found->polygon, expected->polygon);
                EXPECT_NEAR(found->distance, expected->distance, 1e-9 * glm::length(high - low));
                EXPECT_NEAR(glm::length(found->at - expected->at), 0, 1e-9 * glm::length(high - low));
            }
            EXPECT_GT(hits, 60) << int(space);
        }
}

// Another pixel or another thing selected changes none of the polygons.
TEST(View3dFaceTree, WhatIsMarkedAnewKeepsThePolygonsOfItsSpace) {
    std::mt19937 random(9);
    ViewContent world = soup(random);
    world.eye = intoTheCube(true);
    for (const ViewSpace space : {ViewSpace::Eye, ViewSpace::Clip}) {
        const app::SpaceMap map{.space = space, .view = world.eye};
        const ViewContent before = inSpace(world, map);
        ViewContent marked = world;
        int cut = 0;
        for (std::uint32_t i = 0; i < 300; ++i) {
            marked.pickedLoop = {3 * i, 3 * i + 1, 3 * i + 2};
            const ViewContent kept = inSpace(marked, map, &before), anew = inSpace(marked, map);
            ASSERT_EQ(kept.mesh, before.mesh);
            EXPECT_EQ(kept.bounds.min, anew.bounds.min);
            ASSERT_EQ(kept.pickedLoop, anew.pickedLoop);
            cut += kept.pickedLoop.size() != 3;
        }
        EXPECT_EQ(cut > 10, space == ViewSpace::Clip);
        pipeline::View other = world.eye;
        other.near *= 2;
        EXPECT_NE(inSpace(marked, {.space = space, .view = other}, &before).mesh, before.mesh) << "another space";
    }
}

}  // namespace
