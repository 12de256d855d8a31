#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "app/drawing3d/label_places.h"
#include "app/drawing3d/normal_arrows.h"
#include "app/drawing3d/obstacles.h"
#include "app/drawing3d/overlay.h"
#include "app/drawing3d/point_drawing.h"
#include "app/drawing3d/view_content.h"
#include "app/drawing3d/world_drawing.h"
#include "tests/app/view3d/view3d_fixture.h"
#include "tests/support/scenes.h"

using namespace view3d;

TEST(View3dContent, HoldsThePyramidInWorldSpace) {
    const ViewContent content = contentOf(test::pyramid());
    ASSERT_EQ(content.mesh->positions.size(), 5u);
    expectNear(content.mesh->positions[1], {470, 0, 0}, 1e-4);  // 150 · 1.8 + 200
    expectNear(content.mesh->positions[4], {335, 75, 150}, 1e-4);
    EXPECT_EQ(content.mesh->faces.size(), 6u);  // four triangles, and two of the base
    EXPECT_EQ(content.mesh->edges.size(), 8u);  // the base's diagonal is not one
    expectNear(content.bounds.min, {200, 0, 0}, 1e-4);
    expectNear(content.bounds.max, {470, 150, 150}, 1e-4);
    EXPECT_EQ(content.mesh->polygonNormals.size(), 5u);
    // Polygon 2 is (470,150,0) (200,150,0) (335,75,150): its normal (0, 2, 1) / √5 at the mean.
    const auto arrows = shownNormals(content, {});
    ASSERT_EQ(arrows.size(), 5u);
    expectNear(arrows[2].base, {335, 125, 50}, 1e-4);
    expectNear(arrows[2].direction, Vec3d(0, 2, 1) / std::sqrt(5.0), 1e-6);
}

// I of polygon 2 at (335, 125, 50): N·L = 3/√15 = 0.774597, R·V = 0.3974, its 8th power 0.00062, so
// I_r = 0.2·50 + 100 (0.2·0.7746 + 0.4·0.0006) = 25.517, I_g = 63.755, I_b = 114.739; I_max = 175.
TEST(View3dContent, FlatFacesHaveTheFrameBuffersColour) {
    const ViewContent content = contentOf(test::pyramid());
    int found = 0;
    for (const app::Face& face : content.mesh->faces) {
        if (face.polygon != 2) continue;
        ++found;
        EXPECT_TRUE(face.shaded);
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::vec3& color = content.mesh->colorOf(face, i);
            EXPECT_NEAR(color.r, 25.517 / 175, 1e-4);
            EXPECT_NEAR(color.g, 63.755 / 175, 1e-4);
            EXPECT_NEAR(color.b, 114.739 / 175, 1e-4);
        }
    }
    EXPECT_EQ(found, 1);
}

// The eye stands at (612, 612, 500): it sees neither the base nor polygon 0, whose normal has y < 0.
TEST(View3dContent, CulledPolygonsAreNotShaded) {
    const ViewContent content = contentOf(test::pyramid());
    for (const app::Face& face : content.mesh->faces)
        EXPECT_EQ(face.shaded, face.polygon != 0 && face.polygon != 4) << face.polygon;
}

TEST(View3dContent, GouraudColoursDifferAlongAFace) {
    pipeline::Scene scene = test::pyramid();
    scene.settings.shading = pipeline::Shading::Gouraud;
    const ViewContent content = contentOf(scene);
    for (const app::Face& face : content.mesh->faces)
        EXPECT_TRUE(face.polygon != 2 || content.mesh->colorOf(face, 0) != content.mesh->colorOf(face, 2));
}

// Phong shading leaves no intensities at the vertices; the model gives them. A light straight
// above a ball with no other term: at the top vertex N·L = 1, so I / I_max = k_d / max k_d.
TEST(View3dContent, PhongShadingIsEvaluatedAtTheVertices) {
    pipeline::Scene scene = test::pyramid();
    scene.settings.shading = pipeline::Shading::Phong;
    scene.objects[0].mesh = test::sphere(100, 12, 24);
    scene.objects[0].transform = {};
    scene.objects[0].material = {{0.2, 0.4, 0.8}, Vec3d(0), 1};
    scene.lights[0].position = {0, 0, 1};
    scene.ambient.intensity = 0;
    const ViewContent content = contentOf(scene);
    for (const app::Face& face : content.mesh->faces)
        for (std::size_t i = 0; i < 3; ++i)
            if (face.vertices[i] == 0) {
                EXPECT_NEAR(content.mesh->colorOf(face, i).r, 0.25, 1e-4);
                EXPECT_NEAR(content.mesh->colorOf(face, i).b, 1.0, 1e-4);
            }
}

// L = (1,1,1)/√3; R = 2(N·L)N − L = (−1, 1.4, 0.2)/√3; V from (335,125,50) to the eye.
TEST(View3dContent, VectorsStandWhereTheIlluminationWasEvaluated) {
    const ViewContent content = contentOf(test::pyramid(), kRightFace);
    ASSERT_TRUE(content.point && content.foot);
    expectNear(*content.foot, {335, 125, 50}, 1e-3);
    EXPECT_EQ(content.pickedPolygon, 2);
    EXPECT_EQ(content.pickedLoop.size(), 3u);
    expectNear(vectorOf(content, VectorCode::N).direction, Vec3d(0, 2, 1) / std::sqrt(5.0), 1e-6);
    expectNear(vectorOf(content, VectorCode::L).direction, Vec3d(1) / std::sqrt(3.0), 1e-6);
    expectNear(vectorOf(content, VectorCode::R).direction, Vec3d(-1, 1.4, 0.2) / std::sqrt(3.0), 1e-6);
    const double s = 1000 * std::sin(glm::radians(60.0)) * std::sqrt(0.5);
    const Vec3d V = glm::normalize(Vec3d(s, s, 500) - Vec3d(335, 125, 50));
    expectNear(vectorOf(content, VectorCode::V).direction, V, 1e-6);
    expectNear(vectorOf(content, VectorCode::H).direction, glm::normalize(V + Vec3d(1) / std::sqrt(3.0)), 1e-6);
    EXPECT_EQ(vectorOf(content, VectorCode::L).letter, "L") << "one light needs no index";
    // The pixel's own point lies on the face's plane, 2y + z = 300, elsewhere.
    EXPECT_NEAR(2 * content.point->y + content.point->z, 300, 0.05);
}

TEST(View3dContent, LettersCountSeveralLights) {
    pipeline::Scene scene = test::pyramid();
    scene.lights.push_back({pipeline::LightKind::Point, {600, 600, 100}, 50, Vec3d(1), true});
    const ViewContent content = contentOf(scene, kRightFace);
    std::vector<std::string> letters;
    for (const VectorArrow& v : content.vectors) letters.push_back(v.letter);
    EXPECT_NE(std::ranges::find(letters, "L₀"), letters.end());
    EXPECT_NE(std::ranges::find(letters, "L₁"), letters.end());
    EXPECT_NE(std::ranges::find(letters, "N"), letters.end());
    ASSERT_EQ(content.lights.size(), 2u);
    EXPECT_TRUE(content.lights[0].atInfinity);
    EXPECT_FALSE(content.lights[1].atInfinity);
}

TEST(View3dContent, GouraudHasVectorsAtAllThreeVertices) {
    pipeline::Scene scene = test::pyramid();
    scene.settings.shading = pipeline::Shading::Gouraud;
    const ViewContent content = contentOf(scene, kRightFace);
    EXPECT_EQ(std::ranges::count(content.vectors, VectorCode::N, &VectorArrow::code), 3);
    EXPECT_EQ(std::ranges::count_if(content.vectors, [](const auto& v) { return v.main && v.code == VectorCode::N; }),
              1);
}

TEST(View3dContent, ABackgroundPixelHasNoVectors) {
    const ViewContent content = contentOf(test::pyramid(), glm::ivec2{2, 2});
    EXPECT_FALSE(content.point);
    EXPECT_TRUE(content.vectors.empty());
    EXPECT_EQ(content.pickedPolygon, -1);
}

TEST(View3dContent, AnotherPixelSharesTheMesh) {
    const pipeline::Scene scene = test::pyramid();
    const auto frame = test::frameOf(scene, app::contentBuffers(scene, false));
    const ViewContent first = app::contentOf(*frame, kRightFace);
    const ViewContent none = app::withPixel(first, *frame, {});
    EXPECT_EQ(none.mesh, first.mesh);
    EXPECT_FALSE(none.foot);
    EXPECT_TRUE(none.vectors.empty());
    EXPECT_EQ(app::withPixel(none, *frame, kRightFace).vectors.size(), first.vectors.size());
}

TEST(View3dContent, WhatIsStoppedIsLeftUnfinished) {
    const auto frame = test::frameOf(test::pyramid());
    std::stop_source stop;
    EXPECT_EQ(app::contentOf(*frame, {}, nullptr, stop.get_token()).mesh->edges.size(), 8u);
    stop.request_stop();
    const ViewContent content = app::contentOf(*frame, kRightFace, nullptr, stop.get_token());
    EXPECT_TRUE(content.mesh->edges.empty());
    EXPECT_TRUE(content.mesh->faces.empty());
    EXPECT_FALSE(content.point);
}

TEST(View3dContent, AnEmptySceneStillHasBounds) {
    pipeline::Scene scene = test::pyramid();
    scene.objects.clear();
    const ViewContent content = contentOf(scene, glm::ivec2{10, 10});
    EXPECT_TRUE(content.mesh->faces.empty());
    EXPECT_GT(content.bounds.radius(), 0);
    EXPECT_FALSE(app::firstHit(content, {{0, 0, 5}, {0, 0, -1}}));
}

TEST(View3dContent, TheRayOfAPixelHitsWhatThePixelShows) {
    const pipeline::Scene scene = test::pyramid();
    const auto frame = test::frameOf(scene, app::contentBuffers(scene, false));
    const ViewContent content = app::contentOf(*frame, {});
    for (const glm::ivec2 pixel : {kRightFace, glm::ivec2{250, 300}, glm::ivec2{270, 260}, glm::ivec2{300, 262}}) {
        const double id =
            frame->buffer({pipeline::BufferId::PolygonId})->value(std::size_t(pixel.x), std::size_t(pixel.y));
        const Vec3d through = pipeline::worldPoint(content.eye, glm::dvec2(pixel) + 0.5, 1);
        const auto hit = app::firstHit(content, {content.eye.eye, glm::normalize(through - content.eye.eye)});
        ASSERT_EQ(hit.has_value(), id >= 0);
        if (!hit) continue;
        EXPECT_EQ(hit->polygon, int(id));
        const app::Shown shown = app::pixelShowing(*frame, content, *hit);
        ASSERT_TRUE(shown.pixel);
        EXPECT_EQ(*shown.pixel, pixel);
        const auto point = app::pointShownBy(content, pixel);
        ASSERT_TRUE(point);
        expectNear(*point, hit->at, 1e-6);
    }
}

TEST(View3dContent, WhatTheEyeDoesNotSeeHasNoPixelButAReason) {
    const pipeline::Scene scene = test::pyramid();
    const auto frame = test::frameOf(scene, app::contentBuffers(scene, false));
    const ViewContent content = app::contentOf(*frame, {});
    const auto base = app::firstHit(content, {{335, 75, -100}, {0, 0, 1}});
    ASSERT_TRUE(base);
    EXPECT_EQ(base->polygon, 4);
    const app::Shown shown = app::pixelShowing(*frame, content, *base);
    EXPECT_FALSE(shown.pixel);
    EXPECT_EQ(shown.whyNot, "The eye does not see that point: polygon 4 is turned away or hidden there.");
}

// 270 × 150 × 150 has the radius √(270² + 150² + 150²) / 2 = 171.9; a 2.5th of it is 68.8.
TEST(View3dDrawing, TheGridHasARoundStepAndFadesOut) {
    const ViewContent content = contentOf(test::pyramid());
    EXPECT_DOUBLE_EQ(app::gridStep(content), 100);
    float strongest = 0;
    for (const app::InkedLine& line : app::groundLines(content)) {
        EXPECT_EQ(line.a.z, 0);
        EXPECT_NEAR(std::remainder(line.a.x, 100), 0, 1e-9);
        EXPECT_NEAR(std::remainder(line.b.y, 100), 0, 1e-9);
        strongest = std::max(strongest, line.strengthA);
        EXPECT_TRUE(line.strengthA == 0 || glm::length(line.a - Vec3d(335, 75, 0)) < 3.3 * 171.9);
    }
    EXPECT_GT(strongest, 0.9f);
}

// From (335, 125, 50) the eye is |(277.4, 487.4, 450)| = 718.6 away; it lies outside the first view.
TEST(View3dDrawing, TheFirstViewHoldsTheObjectsAndNamesTheFarEye) {
    const ViewContent content = contentOf(test::pyramid(), kRightFace);
    const glm::dvec2 size{600, 420};
    const app::ViewFrame view{app::presetCamera(app::ViewPreset::Iso, content, {}, size, false), size};
    for (const Vec3d& p : content.mesh->positions) {
        const auto at = app::project(view.camera, size, p).at;
        EXPECT_TRUE(at.x > 0 && at.y > 0 && at.x < size.x && at.y < size.y);
    }
    const app::Drawing drawing = app::drawWorld(content, {}, view);
    const auto eye = std::ranges::find(drawing.labels, std::string("eye"), &app::Label::text);
    ASSERT_NE(eye, drawing.labels.end());
    EXPECT_EQ(eye->distance, ", 719 units away");
    EXPECT_EQ(drawing.vectors.size(), 5u);
    EXPECT_FALSE(app::showsWholeEye(content, view));
    const app::ViewFrame all{app::presetCamera(app::ViewPreset::Everything, content, {}, size, false), size};
    EXPECT_TRUE(app::showsWholeEye(content, all));
}

TEST(View3dDrawing, OptionsLeaveOutWhatTheyName) {
    const ViewContent content = contentOf(test::pyramid(), kRightFace);
    const app::ViewFrame view{app::presetCamera(app::ViewPreset::Iso, content, {}, {600, 420}, false), {600, 420}};
    app::ViewOptions options;
    options.shown[std::size_t(VectorCode::H)] = false;
    EXPECT_EQ(app::drawWorld(content, options, view).vectors.size(), 4u);
    options.vectors = options.lights = options.eye = false;
    const app::Drawing bare = app::drawWorld(content, options, view);
    EXPECT_TRUE(bare.vectors.empty());
    EXPECT_TRUE(bare.solids.empty());
    EXPECT_EQ(bare.lines.size(), 3u) << "the axes";
}

// A scene scaled by 2^-20 or 2^20 gives the same picture: nothing here has a size of its own.
TEST(View3dDrawing, AScaledSceneGivesTheSameView) {
    const glm::dvec2 size{600, 420};
    const auto tips = [&](double scale) {
        pipeline::Scene scene = test::pyramid();
        scene.objects[0].transform.scale *= scale;
        scene.objects[0].transform.translation *= scale;
        scene.camera.rho *= scale;
        const ViewContent content = contentOf(scene, kRightFace);
        const app::ViewFrame view{app::presetCamera(app::ViewPreset::Iso, content, {}, size, false), size};
        std::vector<glm::dvec2> result;
        for (const app::Label& label : app::drawWorld(content, {}, view).labels)
            result.push_back(app::project(view.camera, size, label.at).at);
        return result;
    };
    const auto one = tips(1);
    for (const double scale : {std::ldexp(1.0, -20), std::ldexp(1.0, 20)}) {
        const auto other = tips(scale);
        ASSERT_EQ(one.size(), other.size());
        for (std::size_t i = 0; i < one.size(); ++i) EXPECT_NEAR(glm::length(one[i] - other[i]), 0, 1e-3) << i;
    }
}

// N·L = 3/√15: 39.2°; R·V = 0.3974: 66.6°. Turning keeps every angle, and N is up.
TEST(View3dPoint, TheHemisphereHasNUpAndTheEquationsAngles) {
    const ViewContent content = contentOf(test::pyramid(), kRightFace);
    const auto point = app::pointContent(content);
    ASSERT_TRUE(point);
    expectNear(vectorOf(*point, VectorCode::N).direction, {0, 0, 1}, 1e-6);
    EXPECT_NEAR(vectorOf(*point, VectorCode::L).direction.z, 3 / std::sqrt(15.0), 1e-6);
    EXPECT_NEAR(glm::dot(vectorOf(*point, VectorCode::R).direction, vectorOf(*point, VectorCode::V).direction), 0.3974,
                1e-4);
    // The turn is one, not a mirroring.
    const auto handed = [](const ViewContent& c) {
        return glm::dot(vectorOf(c, VectorCode::N).direction,
                        glm::cross(vectorOf(c, VectorCode::L).direction, vectorOf(c, VectorCode::V).direction));
    };
    EXPECT_NEAR(handed(*point), handed(content), 1e-6);

    const glm::dvec2 size{500, 400};
    const app::ViewFrame view{app::pointCamera(app::ViewPreset::Iso, *point, {}, size, false), size};
    std::vector<std::string> angles;
    for (const app::Label& label : app::drawPoint(*point, {}, view).labels)
        if (label.kind == app::Label::Kind::Angle) angles.push_back(label.text);
    EXPECT_EQ(angles, (std::vector<std::string>{"NL 39.2°", "RV 66.6°"}));
}

// The dots of a line are too short each to be seen as one; the words keep off it all the same.
TEST(View3dDrawing, TheEyesCaptionKeepsOffItsRay) {
    const ViewContent content = contentOf(test::pyramid(), kRightFace);
    ASSERT_TRUE(content.foot);
    for (const glm::dvec2 size : {glm::dvec2(640, 480), glm::dvec2(400, 500), glm::dvec2(900, 420)})
        for (int degrees = 0; degrees < 360; degrees += 15) {
            app::OrbitCamera camera = app::presetCamera(app::ViewPreset::Everything, content, {}, size, false);
            app::orbit(camera, degrees, 0);
            const app::ViewFrame view{camera, size};
            for (const app::PlacedLabel& placed : app::placeLabels(app::drawWorld(content, {}, view), view)) {
                if (placed.label.text != "eye" || placed.atBorder) continue;
                const auto from = app::project(camera, size, *content.foot);
                if (!from.inFront) continue;
                const double crossed = app::covered(app::lineOutline(from.at, placed.mark, 1), app::boxOf(placed));
                EXPECT_EQ(crossed, 0) << size.x << ", " << degrees;
            }
        }
}

// Nor on an arrow, a shaft from the point to its tip, where the view has room.
TEST(View3dPoint, AnglesKeepOffArcsAndArrows) {
    const auto point = app::pointContent(contentOf(test::pyramid(), kRightFace));
    ASSERT_TRUE(point);
    for (const glm::dvec2 size : {glm::dvec2(500, 400), glm::dvec2(640, 480), glm::dvec2(820, 500)}) {
        const app::ViewFrame view{app::pointCamera(app::ViewPreset::Iso, *point, {}, size, false), size};
        const app::Drawing drawing = app::drawPoint(*point, {}, view);
        for (const app::PlacedLabel& placed : app::placeLabels(drawing, view)) {
            if (placed.label.kind != app::Label::Kind::Angle) continue;
            double crossed = 0;
            const auto cross = [&](Vec3d a, Vec3d b) {
                crossed += app::covered(
                    app::lineOutline(app::project(view.camera, size, a).at, app::project(view.camera, size, b).at, 1),
                    app::boxOf(placed));
            };
            for (const app::InkedLine& line : drawing.lines)
                if (line.ink == app::Ink::Text) cross(line.a, line.b);
            for (const VectorArrow& v : point->vectors) cross(Vec3d(0.0), v.direction);
            // What runs through it is longer than it is high; a corner may be touched.
            EXPECT_LT(crossed, 0.7 * placed.size.height()) << placed.label.text << ", " << size.x;
        }
    }
}

TEST(View3dPoint, NoPixelHasNoHemisphere) {
    EXPECT_FALSE(app::pointContent(contentOf(test::pyramid())));
    EXPECT_FALSE(app::pointContent(contentOf(test::pyramid(), glm::ivec2{2, 2})));
}

TEST(View3dPoint, EveryTipIsInsideTheView) {
    const auto point = app::pointContent(contentOf(test::pyramid(), kRightFace));
    ASSERT_TRUE(point);
    for (const glm::dvec2 size : {glm::dvec2(500, 400), glm::dvec2(300, 600)})
        for (const bool orthographic : {false, true}) {
            const app::OrbitCamera camera = app::pointCamera(app::ViewPreset::Iso, *point, {}, size, orthographic);
            for (const VectorArrow& v : point->vectors) {
                const auto at = app::project(camera, size, v.direction).at;
                EXPECT_TRUE(at.x > 0 && at.y > 0 && at.x < size.x && at.y < size.y);
            }
        }
}

// The equation's N·L under the cursor: N and L as they are, the others at 35 %.
TEST(View3dDrawing, WhatIsNotPointedAtIsFaint) {
    const ViewContent content = contentOf(test::pyramid(), kRightFace);
    const app::ViewFrame view{app::presetCamera(app::ViewPreset::Iso, content, {}, {640, 480}, false), {640, 480}};
    app::Drawing drawing = app::drawWorld(content, {}, view);
    app::dimAllBut({}, drawing);
    for (const app::InkedSolid& vector : drawing.vectors) EXPECT_EQ(vector.strength, 1) << "nothing is pointed at";
    app::dimAllBut({VectorCode::N, VectorCode::L}, drawing);
    ASSERT_EQ(drawing.vectors.size(), 5u);
    for (const app::InkedSolid& vector : drawing.vectors)
        EXPECT_EQ(vector.strength, vector.ink == app::Ink::N || vector.ink == app::Ink::L ? 1 : 0.35);
    for (const app::Label& label : drawing.labels)
        if (label.kind != app::Label::Kind::Letter) {
            EXPECT_EQ(label.strength, 1) << label.text;
        }
}
