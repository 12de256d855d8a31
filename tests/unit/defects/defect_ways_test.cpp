// Ways of making a defect that are errors of their own, and two defects at once: each against what is known without it.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "pipeline/defects/defect_table.h"
#include "pipeline/defects/defect_ways.h"
#include "pipeline/run/frame_data.h"
#include "tests/support/scenes.h"

namespace {

using namespace pipeline;

FramePtr frameOf(Scene scene) {
    scene.settings.precision = Precision::Double;
    scene.settings.leaveOut = false;
    return test::frameOf(scene);
}
const FrameData<double>& dataOf(const FramePtr& frame) { return *pipeline::dataOf<double>(*frame); }

// The first buffer up to a stage in which two frames differ; empty: none.
std::string difference(const FramePtr& a, const FramePtr& b, StageId until = StageId::Shading) {
    BufferSet upTo;
    for (const BufferInfo& info : bufferTable()) upTo[index(info.id)] = info.stage <= until;
    return test::firstDifference(*a, *b, upTo);
}

Scene smoothBox() {
    Scene scene = test::boxOverGround();
    scene.settings.shading = Shading::Phong;
    scene.settings.normalWeight = NormalWeight::Mean;
    scene.objects[1].transform.rotation = {20, 0, 30};
    for (Object& object : scene.objects) object.material.specular = Vec3d(0.5), object.material.exponent = 4;
    return scene;
}

TEST(DefectWays, ObjectsTurnTheOtherWay) {
    Scene scene = smoothBox(), turned = scene;
    for (Object& object : turned.objects) object.transform.rotation = -object.transform.rotation;
    const FramePtr wrong = frameOf(plant(scene, Defect::TrsOrder, kTheOtherWay));
    EXPECT_EQ(difference(wrong, frameOf(turned)), "");
    EXPECT_NE(difference(wrong, frameOf(scene)), "");
}

TEST(DefectWays, HalfOfTheAngleIsTakenForTheWhole) {
    Scene scene = smoothBox(), narrow = scene;
    narrow.camera.fovY /= 2;
    EXPECT_EQ(difference(frameOf(plant(scene, Defect::HalfAngle, 2)), frameOf(narrow)), "");
}

// Of a renderer that takes the normals of a file as they are, and makes the others of vertices in the world: the file's
// normals are in its buffer, and those of polygons are right.
TEST(DefectWays, OnlyGivenNormalsAreTakenAsTheyAre) {
    Scene scene = smoothBox();
    Mesh mesh = *scene.objects[1].mesh;
    mesh.normals.clear();
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        mesh.normals.push_back(v % 2 == 0 ? Vec3d(0.6, 0, 0.8) : Vec3d(0, -0.8, 0.6));
    scene.objects[1].mesh = std::make_shared<const Mesh>(mesh);
    scene.settings.normalWeight = NormalWeight::Given;
    const FramePtr right = frameOf(scene), wrong = frameOf(plant(scene, Defect::NormalMatrix, kGivenUntouched));
    EXPECT_FALSE(test::firstDifference(*right, *wrong, setOf({BufferId::VerticesNormal})).empty());
    EXPECT_EQ(test::firstDifference(*right, *wrong, setOf({BufferId::PolygonsNormal})), "");
    const AnyBuffer normals = *wrong->buffer({BufferId::VerticesNormal});
    const std::size_t first = scene.objects[0].mesh->positions.size();
    for (std::size_t v = 0; v < mesh.normals.size(); ++v)
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(normals.value(0, first + v, c), mesh.normals[v][c], 1e-15) << v;
}

// At a pixel's centre the areas of the three triangles that it makes with two vertices each are λ_i. Its place is
// Σ λ_i p_i, or with divided weights Σ (λ_i / z_i) p_i / Σ (λ_i / z_i), and V points from there to the eye.
void expectPlaces(const FramePtr& frame, bool divided) {
    const auto& data = dataOf(frame);
    const std::vector<Vec3d> screen = screenPlaces(*data.transform);
    const AnyBuffer position = *frame->buffer({BufferId::Position}), view = *frame->buffer({BufferId::ViewVector});
    const Vec3d eye = smoothBox().camera.eye;
    for (std::size_t i = 0; i < data.zBuffer->triangle->pixels.size(); ++i) {
        const std::uint32_t triangle = data.zBuffer->triangle->pixels[i];
        if (triangle == kNoTriangle) continue;
        const auto width = std::size_t(data.transform->view.size.x);
        const std::size_t x = i % width, y = i / width;
        const glm::dvec2 at(double(x) + 0.5, double(y) + 0.5);
        const auto& v = data.transform->topology->triangles[triangle].vertices;
        Vec3d sum(0);
        double weights = 0;
        for (int k = 0; k < 3; ++k) {
            const glm::dvec2 a = glm::dvec2(screen[v[(k + 1) % 3]]) - at, b = glm::dvec2(screen[v[(k + 2) % 3]]) - at;
            const double weight = (a.x * b.y - a.y * b.x) / (divided ? data.transform->viewSpace(v[k]).z : 1);
            sum += weight * data.transform->world[v[k]], weights += weight;
        }
        const Vec3d found(position.value(x, y, 0), position.value(x, y, 1), position.value(x, y, 2));
        EXPECT_LT(glm::length(found - sum / weights), 1e-3) << i;  // vertices are snapped to parts of a pixel
        const Vec3d towards(view.value(x, y, 0), view.value(x, y, 1), view.value(x, y, 2));
        EXPECT_LT(glm::length(towards - glm::normalize(eye - found)), 1e-12) << i;
    }
}

TEST(DefectWays, AffinePlacesAreMixedByAreasInThePicture) {
    const FramePtr right = frameOf(smoothBox()), wrong = frameOf(plant(smoothBox(), Defect::Affine, kPositionToo));
    expectPlaces(wrong, false);
    EXPECT_NE(difference(wrong, right), "");
    EXPECT_EQ(difference(wrong, right, StageId::ZBuffer), "");
}

// Who divides x and y by one distance shades as before: with weights for a picture in perspective, and from the eye.
TEST(DefectWays, WhoForgetsTheDivisionStillLooksFromTheEye) {
    expectPlaces(frameOf(plant(smoothBox(), Defect::HalfAngle, kOneDistance)), true);
}

// Two sides of the box face away from the light: they have S = 0 too, and keep the ambient term.
TEST(DefectWays, AmbientLightIsLostWhereLightIsBlocked) {
    const FramePtr right = frameOf(smoothBox());
    const FramePtr wrong = frameOf(plant(smoothBox(), Defect::AmbientInShadow, kBlockedAlone));
    const AnyBuffer intensity = *right->buffer({BufferId::Intensity}), found = *wrong->buffer({BufferId::Intensity}),
                    ambient = *right->buffer({BufferId::Ambient}), s = *right->buffer({BufferId::Shadow, 0}),
                    nDotL = *right->buffer({BufferId::NDotL, 0});
    std::size_t blocked = 0, away = 0;
    const auto width = std::size_t(dataOf(right).transform->view.size.x);
    for (std::size_t i = 0; i < dataOf(right).zBuffer->triangle->pixels.size(); ++i) {
        const std::size_t x = i % width, y = i / width;
        if (dataOf(right).zBuffer->triangle->pixels[i] == kNoTriangle || s.value(x, y, 0) > 0) continue;
        const bool facesLight = nDotL.value(x, y, 0) > 0;
        ++(facesLight ? blocked : away);
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(found.value(x, y, c), intensity.value(x, y, c) - (facesLight ? ambient.value(x, y, c) : 0),
                        1e-12)
                << i;
    }
    EXPECT_GT(blocked, 10u);
    EXPECT_GT(away, 10u);
    EXPECT_EQ(difference(wrong, right, StageId::ZBuffer), "");
}

// Who culls by a light that shines along the viewing axis culls by the viewing axis.
TEST(DefectWays, ALightBehindTheEyeCullsAsTheViewingAxisDoes) {
    Scene scene = smoothBox();
    scene.camera.fovY = 90;
    scene.lights[0].position = scene.camera.eye - scene.camera.target;
    const FramePtr byLight = frameOf(plant(scene, Defect::CullAxis, kAlongTheLight));
    EXPECT_EQ(difference(byLight, frameOf(plant(scene, Defect::CullAxis)), StageId::Cull), "");
    scene.lights[0].position = -scene.lights[0].position;
    EXPECT_NE(difference(frameOf(plant(scene, Defect::CullAxis, kAlongTheLight)), byLight, StageId::Cull), "");
}

// At the vertex of a box three unit normals meet at right angles: their mean has length 1/√3.
TEST(DefectWays, NormalsOfVerticesAreLeftAsMeans) {
    const FramePtr wrong = frameOf(plant(smoothBox(), Defect::NormalShort, kMeanNotUnit));
    for (const Vec3d& normal : dataOf(wrong).normals->vertex)
        EXPECT_NEAR(glm::length(normal), 1 / std::sqrt(3.0), 1e-12);
    EXPECT_EQ(difference(wrong, frameOf(smoothBox()), StageId::Cull), "");
}

TEST(DefectWays, VerticesThatCountAlikeGiveATriangleOneNormal) {
    const FramePtr wrong = frameOf(plant(smoothBox(), Defect::NormalShort, kAlike));
    const auto& triangles = dataOf(wrong).zBuffer->triangle->pixels;
    const auto& normals = dataOf(wrong).shading->vectors[index(BufferId::Normal)][0].pixels;
    std::map<std::uint32_t, Vec3d> ofTriangle;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (triangles[i] == kNoTriangle) continue;
        const auto [first, isNew] = ofTriangle.emplace(triangles[i], normals[i]);
        EXPECT_EQ(first->second, normals[i]);
        EXPECT_NEAR(glm::length(normals[i]), 1, 1e-12);
    }
    EXPECT_GT(ofTriangle.size(), 5u);
}

// A triangle whose vertices have the normals z, −x and −y, in this order in the mesh.
Scene oneTriangle(std::vector<std::uint32_t> order) {
    Scene scene = smoothBox();
    scene.objects.resize(1);
    scene.settings.cull = CullMode::None, scene.settings.normalWeight = NormalWeight::Given;
    Mesh mesh;
    for (const Vec3d& p : {Vec3d(0, 0, 2), Vec3d(-1, 0, 1), Vec3d(1, 0, 0)}) mesh.positions.push_back(p);
    for (const Vec3d& n : {Vec3d(0, 0, 1), Vec3d(-1, 0, 0), Vec3d(0, -1, 0)}) mesh.normals.push_back(n);
    mesh.addPolygon(order);
    scene.objects[0].mesh = makeMesh(std::move(mesh));
    return scene;
}
const auto& normalsOf(const FramePtr& frame) {
    return dataOf(frame).shading->vectors[index(BufferId::Normal)][0].pixels;
}

// If the mesh has the vertices from the top to the bottom of the picture nothing changes; if two of them are exchanged
// the normal of one is at the place of the other.
TEST(DefectWays, VerticesAreSortedWithoutTheirNormals) {
    const auto wrong = [](const Scene& of) { return frameOf(plant(of, Defect::NormalShort, kSortedAlone)); };
    const FramePtr rightFrame = frameOf(oneTriangle({0, 1, 2})), sortedFrame = wrong(oneTriangle({0, 1, 2})),
                   exchangedFrame = wrong(oneTriangle({0, 2, 1}));
    const auto &right = normalsOf(rightFrame), &sorted = normalsOf(sortedFrame), &exchanged = normalsOf(exchangedFrame);
    // The lowest vertex has normal 1 then, and the middle one normal 2: as if these had been exchanged.
    double differs = 0;
    for (std::size_t i = 0; i < right.size(); ++i) {
        EXPECT_NEAR(glm::length(sorted[i] - right[i]), 0, 1e-12);
        differs = std::max(differs, glm::length(exchanged[i] - right[i]));
        // Normals z, −x, −y: what was the share of −x is now that of −y.
        EXPECT_NEAR(exchanged[i].x, right[i].y, 1e-12);
        EXPECT_NEAR(exchanged[i].y, right[i].x, 1e-12);
    }
    EXPECT_GT(differs, 0.5);
}

// N = λ_0 z − λ_1 x − λ_2 y, made unit: what was the share of z is now that of −x.
TEST(DefectWays, WeightsOfTwoVerticesAreExchanged) {
    const FramePtr rightFrame = frameOf(oneTriangle({0, 1, 2})),
                   wrongFrame = frameOf(plant(oneTriangle({0, 1, 2}), Defect::NormalShort, kExchanged));
    const auto &right = normalsOf(rightFrame), &wrong = normalsOf(wrongFrame);
    double differs = 0;
    for (std::size_t i = 0; i < right.size(); ++i) {
        EXPECT_NEAR(glm::length(wrong[i] - Vec3d(-right[i].z, right[i].y, -right[i].x)), 0, 1e-12);
        differs = std::max(differs, glm::length(wrong[i] - right[i]));
    }
    EXPECT_GT(differs, 0.5);
}

// From 1/z = Σ λ_i / z_i and b_i = λ_i z / z_i: the weights in the picture are λ_i = b_i z_i / z.
TEST(DefectWays, WeightsOfTwoVerticesAreExchangedForDepthsToo) {
    Scene scene = oneTriangle({0, 1, 2});
    scene.objects[0].transform.rotation = {60, 0, 0};  // at three depths
    const FramePtr right = frameOf(scene), wrong = frameOf(plant(scene, Defect::ZAffine, kExchangedDepths));
    const auto& in = *dataOf(right).transform;
    const Vec3d z(in.viewSpace(0).z, in.viewSpace(1).z, in.viewSpace(2).z);
    double differs = 0;
    for (std::size_t i = 0; i < normalsOf(right).size(); ++i) {
        if (dataOf(right).zBuffer->triangle->pixels[i] == kNoTriangle) continue;
        const double there = dataOf(right).zBuffer->zView->pixels[i];
        const Vec3d lambda = dataOf(right).zBuffer->barycentric.pixels[i] * z / there;
        const double expected = 1 / (lambda[1] / z[0] + lambda[0] / z[1] + lambda[2] / z[2]);
        EXPECT_NEAR(dataOf(wrong).zBuffer->zView->pixels[i], expected, 1e-12 * expected);
        Vec3d normal(0);
        for (const auto& [from, to] : {std::pair{1, 0}, {0, 1}, {2, 2}})
            normal += lambda[from] / z[to] * in.normalMatrix[0] * scene.objects[0].mesh->normals[std::size_t(to)];
        EXPECT_NEAR(glm::length(normalsOf(wrong)[i] - glm::normalize(normal)), 0, 1e-12);
        differs = std::max(differs, std::abs(expected - there));
    }
    EXPECT_GT(differs, 0.5);
}

// Of depth = (f / (f − n)) (1 − n / z) in 0 to 1, and 2 depth − 1 in −1 to 1: the file holds a z-th of it, and what has
// the least there is seen. That falls with z from 2 n on, or 4 n: far surfaces win.
TEST(DefectWays, TheDepthIsDividedTwice) {
    Scene scene = smoothBox();
    scene.camera.near = 2, scene.camera.far = 30;
    EXPECT_EQ(difference(frameOf(plant(scene, Defect::ZAffine, kDividedTwice)), frameOf(scene)), "") << "of z_view";
    scene.settings.depthFormat = DepthFormat::Float;
    const FramePtr right = frameOf(scene);
    const auto& in = *dataOf(right).transform;
    for (const bool ndc : {false, true}) {
        const auto stored = [&](double z) { return (ndc ? -1 : 0) + (ndc ? 2 : 1) * 30.0 / 28 * (1 - 2 / z); };
        const FramePtr wrong = frameOf(plant(scene, Defect::ZAffine, ndc ? kNdcDividedTwice : kDividedTwice));
        const auto& seen = *dataOf(wrong).zBuffer;
        std::size_t farther = 0;
        for (std::size_t i = 0; i < seen.triangle->pixels.size(); ++i) {
            if (seen.triangle->pixels[i] == kNoTriangle) continue;
            double z = 0;
            for (int k = 0; k < 3; ++k)
                z += seen.barycentric.pixels[i][k] *
                     in.viewSpace(in.topology->triangles[seen.triangle->pixels[i]].vertices[std::size_t(k)]).z;
            EXPECT_NEAR(stored(seen.zView->pixels[i]), stored(z) / z, 1e-12);
            const double nearest = dataOf(right).zBuffer->zView->pixels[i];
            EXPECT_LE(stored(z) / z, stored(nearest) / nearest + 1e-7);  // 0 to 1 in float
            farther += z > nearest + 0.1;
        }
        EXPECT_GT(farther, 100u) << ndc;
    }
}

// Light from behind the eye, low over the ground: R·V is below 0 there, and above 0 on the sides of the box.
TEST(DefectWays, ThePowerOfANegativeNumberIsBlack) {
    Scene scene = smoothBox();
    scene.lights[0].position = {1, -6, 1.5};
    for (const Highlight highlight : {Highlight::Phong, Highlight::BlinnPhong}) {
        for (Object& object : scene.objects) object.material.highlight = highlight;
        const FramePtr right = frameOf(scene), wrong = frameOf(plant(scene, Defect::Exponent, kPowerOfNegative));
        const auto at = [&](BufferId id, std::size_t i) {
            return dataOf(right).shading->scalars[index(id)][0].pixels[i];
        };
        std::size_t black = 0, others = 0;
        for (std::size_t i = 0; i < dataOf(right).shading->color.pixels.size(); ++i) {
            const double cosine = at(highlight == Highlight::Phong ? BufferId::RDotV : BufferId::NDotH, i);
            const bool isBlack = at(BufferId::NDotL, i) > 0 && cosine < 0 && at(BufferId::Shadow, i) > 0;
            const Color8 color = dataOf(right).shading->color.pixels[i];
            EXPECT_EQ(dataOf(wrong).shading->color.pixels[i], isBlack ? Color8(0) : color);
            black += isBlack && color != Color8(0), others += !isBlack && color != Color8(0);
        }
        EXPECT_EQ(black > 100, highlight == Highlight::Phong) << black;
        EXPECT_GT(others, 100u);
    }
}

TEST(DefectWays, ABlockOfPixelsHasTheColourOfItsFirst) {
    Scene scene = smoothBox();
    scene.settings.width = 131, scene.settings.height = 71;
    const FramePtr rightFrame = frameOf(scene);
    const Buffer2D<Color8>& right = dataOf(rightFrame).shading->color;
    for (const int side : {2, 4}) {
        const FramePtr wrong = frameOf(plant(scene, Defect::BlocksOfFour, side == 2 ? 0 : kFourByFour));
        std::size_t differing = 0;
        for (int y = 0; y < 71; ++y)
            for (int x = 0; x < 131; ++x) {
                const Color8 first = right.at({x - x % side, y - y % side});
                EXPECT_EQ(dataOf(wrong).shading->color.at({x, y}), first) << x << ", " << y;
                differing += first != right.at({x, y});
            }
        EXPECT_GT(differing, 100u);
        EXPECT_EQ(difference(wrong, rightFrame, StageId::ZBuffer), "");
    }
}

TEST(DefectWays, TheHighlightIsLeftInTheShadow) {
    Scene scene = smoothBox();
    const FramePtr right = frameOf(scene), wrong = frameOf(plant(scene, Defect::AmbientInShadow, kHighlightInShadow));
    scene.lights[0].castsShadow = false;
    const FramePtr without = frameOf(scene);
    const auto at = [](const FramePtr& frame, BufferId id) -> const auto& {
        return dataOf(frame).shading->vectors[index(id)][0].pixels;
    };
    const auto& shadow = dataOf(right).shading->scalars[index(BufferId::Shadow)][0].pixels;
    std::size_t dark = 0;
    for (std::size_t i = 0; i < shadow.size(); ++i) {
        const Vec3d added = at(wrong, BufferId::Intensity)[i] - at(right, BufferId::Intensity)[i];
        const Vec3d expected = (1 - shadow[i]) * at(without, BufferId::Specular)[i];
        EXPECT_NEAR(glm::length(added - expected), 0, 1e-9);
        dark += glm::length(expected) > 1;
    }
    EXPECT_GT(dark, 50u);
}

TEST(TwoDefects, BothAreMade) {
    Scene scene = smoothBox();
    const Scene both = plantToo(plant(scene, Defect::TrsOrder, kTheOtherWay), Defect::NoAmbient);
    Scene turned = scene;
    for (Object& object : turned.objects) object.transform.rotation = -object.transform.rotation;
    EXPECT_EQ(difference(frameOf(both), frameOf(plant(turned, Defect::NoAmbient))), "");
    EXPECT_NE(difference(frameOf(both), frameOf(plant(scene, Defect::NoAmbient))), "");
    // In the other order too, with ways of both.
    const Scene other = plantToo(plant(scene, Defect::NormalShort, kAlike), Defect::TrsOrder, kTheOtherWay);
    EXPECT_EQ(difference(frameOf(other), frameOf(plant(turned, Defect::NormalShort, kAlike))), "");
    // Files too: one polygon the other way round.
    const Scene winding = plantToo(plant(scene, Defect::NoAmbient), Defect::Winding);
    EXPECT_EQ(difference(frameOf(winding), frameOf(plant(scene, Defect::Winding)), StageId::ZBuffer), "");
    EXPECT_NE(difference(frameOf(winding), frameOf(plant(scene, Defect::Winding))), "");
}

TEST(TwoDefects, OfOneTextAreRefused) {
    const Scene scene = plant(smoothBox(), Defect::CullSign);
    EXPECT_EQ(plantToo(scene, Defect::CullSign), scene);
    EXPECT_EQ(plantToo(scene, Defect::CullAxis, kAlongTheLight), scene);
    const Scene two = plantToo(scene, Defect::NoMax);
    EXPECT_NE(two, scene);
    EXPECT_EQ(plantToo(two, Defect::Gamma), two) << "a third";
}

// Where the samples lie is a convention: it takes both along.
TEST(TwoDefects, SamplesMayLieElsewhereToo) {
    const Scene two = plantToo(plant(smoothBox(), Defect::CullSign), Defect::NoMax, 2);
    const Scene moved = sampledAt(two, PixelCorner::UpperLeft);
    EXPECT_EQ(sampleShiftOf(two), glm::dvec2(0));
    EXPECT_EQ(sampleShiftOf(moved), glm::dvec2(0.5));
    EXPECT_TRUE(difference(frameOf(moved), frameOf(two), StageId::Normals).starts_with("vertices.screen"));
    EXPECT_EQ(dataOf(frameOf(moved)).keys.cull, dataOf(frameOf(two)).keys.cull);
    EXPECT_EQ(dataOf(frameOf(moved)).keys.shading.illumination, dataOf(frameOf(two)).keys.shading.illumination);
}

}  // namespace
