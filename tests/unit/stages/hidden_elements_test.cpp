// Which polygons and vertices flat and Gouraud shading evaluate.
#include <gtest/gtest.h>

#include <random>
#include <set>

#include "pipeline/run/frame_data.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

// A sphere of 10 680 triangles in a picture of 97 × 71.
Scene fineSphere(Shading shading, Precision precision = Precision::Float, Visibility visibility = Visibility::ZBuffer) {
    Scene scene = test::spheres();
    scene.settings.width = 97, scene.settings.height = 71;
    scene.settings.shading = shading, scene.settings.precision = precision, scene.settings.visibility = visibility;
    scene.objects.resize(1);
    scene.objects[0].mesh = test::sphere(150, 60, 90);
    return scene;
}

const BufferSet kPicture = setOf({BufferId::Color, BufferId::Intensity});

ShadingCounts countsOf(const Frame& frame) {
    return readStages(frame, [](const auto& data) { return data.shading->counts; });
}

// The polygons in the picture and their corners, from the buffer that names a polygon for each pixel.
struct Shown {
    std::set<std::int32_t> polygons;
    std::set<std::uint32_t> vertices;
    explicit Shown(const Frame& frame) {
        const AnyBuffer ids = *frame.buffer({BufferId::PolygonId});
        for (std::size_t i = 0; i < ids.count(); ++i)
            if (ids.flat(i) != kNothing) polygons.insert(std::int32_t(ids.flat(i)));
        for (const std::int32_t polygon : polygons) {
            const Topology::Corners corners = frame.topology().corners(std::size_t(polygon));
            for (std::size_t corner = 0; corner < corners.size(); ++corner) vertices.insert(corners[corner]);
        }
    }
};

// As many as there are in the picture, and the picture is the one of all of them: drawn in vectors, one by one, and painted.
TEST(HiddenElements, OfAFineMeshWhatNoPixelShowsIsNotEvaluated) {
    for (const Shading shading : {Shading::Flat, Shading::Gouraud})
        for (const auto& [precision, visibility] : {std::pair(Precision::Float, Visibility::ZBuffer),
                                                    {Precision::Double, Visibility::ZBuffer},
                                                    {Precision::Double, Visibility::Painter}})
            for (const CullMode cull : {CullMode::Back, CullMode::None}) {
                Scene scene = fineSphere(shading, precision, visibility);
                scene.settings.cull = cull;
                const FramePtr frame = test::frameOf(scene, kPicture);
                const Shown shown(*frame);
                const ShadingCounts counts = countsOf(*frame);
                if (shading == Shading::Flat) {
                    EXPECT_EQ(counts.polygons, std::ssize(shown.polygons));
                    EXPECT_EQ(counts.polygons + counts.hiddenPolygons, std::int64_t(frame->topology().polygonCount()));
                } else {
                    EXPECT_EQ(counts.vertices, std::ssize(shown.vertices));
                    EXPECT_EQ(counts.vertices + counts.hiddenVertices, std::int64_t(frame->topology().vertexCount()));
                }
                scene.settings.leaveOut = false;
                EXPECT_EQ(test::firstDifference(*frame, *test::frameOf(scene, kPicture), kPicture), "");
            }
}

// Terms take room for what is evaluated alone; whoever looks at the buffer all the same sees the others black.
TEST(HiddenElements, TermsTakeRoomForWhatIsEvaluatedAlone) {
    for (const Shading shading : {Shading::Flat, Shading::Gouraud})
        for (const Precision precision : {Precision::Float, Precision::Double}) {
            Scene scene = fineSphere(shading, precision);
            const FramePtr frame = test::frameOf(scene, kPicture);
            scene.settings.leaveOut = false;
            const bool flat = shading == Shading::Flat;
            const BufferName name{flat ? BufferId::PolygonsIntensity : BufferId::VerticesIntensity};
            const AnyBuffer few = *frame->buffer(name), all = *test::frameOf(scene)->buffer(name);
            ASSERT_EQ(few.shape, all.shape);
            const Shown shown(*frame);
            for (std::size_t i = 0; i < all.count(); ++i) {
                const std::uint32_t element = std::uint32_t(i / 3);
                const bool isSeen = flat ? shown.polygons.contains(int(element)) : shown.vertices.contains(element);
                ASSERT_EQ(few.flat(i), isSeen ? all.flat(i) : 0) << element;
            }
            readStages(*frame, [&](const auto& data) {
                const auto& elements = flat ? data.shading->polygons : data.shading->vertices;
                const std::size_t seen = flat ? shown.polygons.size() : shown.vertices.size();
                EXPECT_EQ(elements.intensity.size(), seen + 1);
                EXPECT_EQ(elements.terms.size(), (seen + 1) * scene.lights.size());
            });
        }
}

// To find what 3000 pixels show would cost more than to evaluate a few polygons.
TEST(HiddenElements, OfACoarseMeshEveryPolygonThatGoesOnIsEvaluated) {
    Scene scene = fineSphere(Shading::Flat);
    Object behind = scene.objects[0];
    scene.objects[0].mesh = test::sphere(150, 6, 9);
    behind.mesh = test::sphere(50, 4, 5);  // in the middle of the other: seen nowhere
    scene.objects.push_back(behind);
    const FramePtr frame = test::frameOf(scene, kPicture);
    const AnyBuffer verdicts = *frame->buffer({BufferId::PolygonsVerdict});
    long long kept = 0;
    for (std::size_t i = 0; i < verdicts.count(); ++i) kept += goesOn(Verdict(int(verdicts.flat(i))));
    EXPECT_EQ(countsOf(*frame).polygons, kept);
    EXPECT_GT(kept, std::ssize(Shown(*frame).polygons));
}

// Whoever asks for the intensities of the polygons has all of them.
TEST(HiddenElements, ABufferThatIsAskedForIsWhole) {
    const FramePtr frame = test::frameOf(fineSphere(Shading::Flat), setOf({BufferId::PolygonsIntensity}));
    EXPECT_EQ(countsOf(*frame).polygons, std::int64_t(frame->topology().polygonCount()));
}

// Layers show polygons that no pixel of the z-buffer does: all of a translucent sphere.
TEST(HiddenElements, WhatLayersShowIsEvaluated) {
    for (const Shading shading : {Shading::Flat, Shading::Gouraud}) {
        Scene scene = fineSphere(shading);
        scene.objects[0].material.alpha = 0.5;
        const FramePtr frame = test::frameOf(scene, kPicture);
        EXPECT_GT(countsOf(*frame).layers, 0);
        scene.settings.leaveOut = false;
        EXPECT_EQ(test::firstDifference(*frame, *test::frameOf(scene, kPicture), kPicture), "");
    }
}

// The corners of a sample are snapped anew: a sliver whose area is 0 in the one may have some in another, and be seen.
TEST(HiddenElements, WhatOneSampleOfAPixelShowsIsEvaluated) {
    std::mt19937 random(7);
    const auto within = [&](double most) { return std::uniform_real_distribution<double>(-most, most)(random); };
    std::vector<Vec3d> corners;
    std::vector<std::vector<std::uint32_t>> polygons;
    for (int i = 0; i < 4000; ++i) {
        const Vec3d a{within(40), within(30), within(5)}, along{within(30), within(30), 0};
        const Vec3d across = Vec3d(-along.y, along.x, 0) * (within(2e-4));
        polygons.push_back({});
        for (const Vec3d& corner : {a, a + along, a + 0.5 * along + across}) {
            polygons.back().push_back(std::uint32_t(corners.size()));
            corners.push_back(corner);
        }
    }
    for (const Shading shading : {Shading::Flat, Shading::Gouraud}) {
        Scene scene = fineSphere(shading);
        scene.camera = {};
        scene.camera.kind = CameraKind::LookAt, scene.camera.projection = ProjectionKind::Orthographic;
        scene.camera.eye = {0, 0, 50}, scene.camera.up = {0, 1, 0}, scene.camera.height = 71;
        scene.settings.antialiasing = 3;
        scene.objects[0].mesh = test::mesh(corners, polygons);
        scene.objects[0].transform = {};
        scene.lights[0].castsShadow = false;
        const BufferSet wanted = setOf({BufferId::Color, BufferId::Antialiased});
        const FramePtr frame = test::frameOf(scene, wanted);
        scene.settings.leaveOut = false;
        EXPECT_EQ(test::firstDifference(*frame, *test::frameOf(scene, wanted), wanted), "");
    }
}

}  // namespace
}  // namespace pipeline
