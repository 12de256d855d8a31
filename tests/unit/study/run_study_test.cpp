// What a study does beside measuring: counters, times by process, parts that become one.
#include <gtest/gtest.h>

#include <algorithm>

#include "pipeline/run/draws.h"
#include "pipeline/scene/mesh/shape.h"
#include "pipeline/study/analysis.h"
#include "pipeline/study/ray_caster.h"
#include "pipeline/study/run_study.h"
#include "tests/support/scenes.h"

using namespace pipeline;
using Texts = std::vector<std::string>;

namespace {

StudyRequest requestOf(const Scene& scene, Texts sweeps) {
    StudyRequest request;
    request.scene = std::make_shared<const Scene>(scene);
    request.sweep = *parseSweeps(scene, sweeps);
    request.warmups = 0, request.repeats = 2;
    return request;
}

Scene small() {
    Scene scene = test::pyramid();
    scene.settings.width = 40, scene.settings.height = 30, scene.camera.pixelsPerUnit = 1.0 / 16;
    return scene;
}

// The counters stand beside the times: they are those of a frame that nobody asks for buffers, and the pyramid,
// convex and alone, looks up no shadow.
TEST(RunStudy, countsWhatTheTimedFrameDoes) {
    Scene scene = small();
    scene.camera.pixelsPerUnit = 0.25;  // dozens of pixels a polygon: each that culling keeps is evaluated
    const StudyRequest request = requestOf(scene, {"shading=flat,phong"});
    StudyReport report = beginStudy(request);
    ErrorFinder finder(request);
    for (StudyPoint& point : report.points) ASSERT_TRUE(finder.find(point, report, {}));
    EXPECT_EQ(report.points[0].counters.at("shadow look-ups"), 0);
    EXPECT_EQ(report.points[0].counters.at("polygons evaluated"), 3);  // culling keeps three of five
    EXPECT_EQ(report.points[1].counters.at("polygons evaluated"), 0);
    EXPECT_GT(report.points[1].counters.at("light evaluations"), report.points[0].counters.at("light evaluations"));
}

// A search that was interrupted and is made again, as after going on with a study, counts no frame twice.
TEST(RunStudy, findingAPointAgainLeavesItsCountersAsTheyAre) {
    const StudyRequest request = requestOf(small(), {"shading=flat,phong"});
    StudyReport report = beginStudy(request);
    ErrorFinder finder(request);
    ASSERT_TRUE(finder.find(report.points[1], report, {}));
    const auto once = report.points[1].counters;
    ASSERT_TRUE(finder.find(report.points[1], report, {}));
    EXPECT_EQ(report.points[1].counters, once);
}

TEST(RunStudy, aValueThatTheSceneRefusesIsAFailureOfThatPointAlone) {
    Scene scene = small();
    scene.camera.far = 2000;
    const StudyRequest request = requestOf(scene, {"camera.near=100,3000"});  // behind the far plane
    StudyReport report = beginStudy(request);
    EXPECT_EQ(report.points[0].failure, "");
    // What is wrong, and what would be right.
    EXPECT_EQ(report.points[1].failure, "camera.near is 3000, expected less than camera.far, which is 2000");
    ASSERT_TRUE(measureTimes(request, report.points, nullptr, {}));
    EXPECT_EQ(report.points[0].frame.processes.size(), 1u);
    EXPECT_TRUE(report.points[1].frame.empty());
}

// Of N samples at random the error is in proportion to N^(-1/2): of 8 x 8 a quarter of that of 2 x 2. One draw says little
// of that, for all pixels have the same positions.
TEST(RunStudy, theErrorOfSamplesAtRandomHasTheIntervalOfSeveralDraws) {
    Scene scene = small();
    scene.camera.pixelsPerUnit = 0.125;
    const StudyRequest request = requestOf(scene, {"antialiasing_pattern=grid,jittered,random", "antialiasing=2,8"});
    StudyReport report = beginStudy(request);
    ErrorFinder finder(request);
    for (StudyPoint& point : report.points) ASSERT_TRUE(finder.find(point, report, {}));
    const ErrorChoice rmse{"antialiased", "RMSE", ErrorKind::Model};
    for (std::size_t i = 0; i < 6; ++i) {
        const auto error = report.points[i].error(rmse);
        const auto drawn = report.points[i].drawn(rmse);
        ASSERT_TRUE(error) << i;
        ASSERT_EQ(bool(drawn), i >= 2) << "a grid is the same in each draw";
        if (!drawn) continue;
        EXPECT_LT(drawn->first, *error);
        EXPECT_GT(drawn->second, *error);
    }
    const auto few = report.points[4].drawn(rmse), many = report.points[5].drawn(rmse);
    EXPECT_LT(few->first / many->second, 4);
    EXPECT_GT(few->second / many->first, 4);
    EXPECT_FALSE(report.points[4].drawn({"z_view", "RMSE", ErrorKind::Model})) << "depth is the centre's";
}

// The same frame again, bit by bit, is draw 0.
TEST(RunStudy, theFirstDrawIsTheFramesOwn) {
    Scene scene = small();
    scene.settings.antialiasing = 3, scene.settings.antialiasingPattern = SamplePattern::Random;
    const FramePtr frame = test::frameOf(scene, setOf({BufferId::Antialiased}));
    const auto valuesOf = [](const FramePtr& of) {
        const AnyBuffer buffer = *of->buffer({BufferId::Antialiased});
        std::vector<double> values;
        for (std::size_t i = 0; i < buffer.count(); ++i) values.push_back(buffer.flat(i));
        return values;
    };
    EXPECT_EQ(valuesOf(withDraw(frame, 0, {})), valuesOf(frame));
    EXPECT_NE(valuesOf(withDraw(frame, 1, {})), valuesOf(frame));
}

// The object is out of sight: there is no picture whose error could be 0.
TEST(RunStudy, aPictureInWhichNothingIsDrawnHasNoErrors) {
    Scene scene = small();
    const StudyRequest request = requestOf(scene, {"object.0.ty=0,100000"});
    StudyReport report = beginStudy(request);
    ErrorFinder finder(request);
    for (StudyPoint& point : report.points) ASSERT_TRUE(finder.find(point, report, {}));
    EXPECT_EQ(report.points[0].failure, "");
    EXPECT_FALSE(report.points[0].errors.empty());
    EXPECT_EQ(report.points[1].failure, "nothing is drawn: there is nothing to compare");
    EXPECT_TRUE(report.points[1].errors.empty());
    EXPECT_EQ(analyse(report, report.choice).byTime.size(), 0u);
}

TEST(RunStudy, takesAsManyTimesAsAskedForAndNoneWhenStopped) {
    const StudyRequest request = requestOf(small(), {"shading=flat,gouraud"});
    StudyReport report = beginStudy(request);
    int rounds = 0;
    ASSERT_TRUE(measureTimes(request, report.points, [&](int done, int all) { rounds = done * 100 + all; }, {}));
    ASSERT_TRUE(measureTimes(request, report.points, nullptr, {}));
    EXPECT_EQ(rounds, 202);
    for (const StudyPoint& point : report.points) {
        ASSERT_EQ(point.frame.processes.size(), 2u);
        EXPECT_EQ(point.frame.processes[1].size(), 2u);
        EXPECT_TRUE(point.stages[index(StageId::ShadowBuffer)].empty()) << "left out";
        EXPECT_FALSE(point.stages[index(StageId::ZBuffer)].empty());
    }
    std::stop_source source;
    source.request_stop();
    EXPECT_FALSE(measureTimes(request, report.points, nullptr, source.get_token()));
    EXPECT_EQ(report.points[0].frame.processes.size(), 2u);
}

// The reference of the model is the same for every shading of one scene: an error bar is found once, and the second
// point's picture is compared with the very same object.
TEST(RunStudy, pointsThatDifferInShadingShareTheirReference) {
    const StudyRequest request = requestOf(small(), {"shading=flat,phong"});
    const StudyReport report = beginStudy(request);
    ErrorFinder finder(request);
    const auto a = finder.show(report.points[0], {}), b = finder.show(report.points[1], {});
    ASSERT_TRUE(a && b && a->reference);
    EXPECT_EQ(a->reference, b->reference);
}

// A sweep of samples is compared with the polygons that they are taken of; one that varies the polygons, too, is not.
TEST(RunStudy, samplesAloneAreComparedWithTheScenesOwnPolygons) {
    const auto nameOf = [](std::vector<std::string> sweep) {
        const StudyRequest request = requestOf(small(), sweep);
        StudyReport report = beginStudy(request);
        ErrorFinder finder(request);
        EXPECT_TRUE(finder.find(report.points[0], report, {}));
        return report.references[index(ErrorKind::Model)];
    };
    EXPECT_EQ(nameOf({"shadow.size=32,64"}), "the scene's polygons by rays, double");
    EXPECT_EQ(nameOf({"antialiasing=1,2"}), "the scene's polygons by rays, double");
    EXPECT_EQ(nameOf({"antialiasing"}), "the scene's polygons by rays, double") << "as the ready-made sweep does";
    EXPECT_EQ(nameOf({"shadow.size=32,64", "shading=flat,phong"}),
              "the mesh's facets, taken as its true surface, by rays, double");
}

// The error of the polygons themselves would hide that of the samples.
TEST(RunStudy, whereOnlySamplesVaryThePolygonsAreTheReference) {
    const StudyRequest request = requestOf(small(), {"shadow.size=16,32"});
    const StudyReport report = beginStudy(request);
    ErrorFinder finder(request);
    const auto a = finder.show(report.points[0], {}), b = finder.show(report.points[1], {});
    ASSERT_TRUE(a && b && a->reference);
    EXPECT_EQ(a->reference, b->reference);
    EXPECT_EQ(a->reference->name, "the scene's polygons by rays, double");
}

// 64 bits of significand against 113 differ by far less than a double's 53 say: an error of 0 was not measured. Counts
// of pixels and polygons were.
TEST(RunStudy, theErrorOfExtendedIsNotMeasurableInBuffersOfDoubles) {
    const StudyRequest request = requestOf(small(), {"precision=double,extended"});
    StudyReport report = beginStudy(request);
    ErrorFinder finder(request);
    for (StudyPoint& point : report.points) ASSERT_TRUE(finder.find(point, report, {}));
    const auto errorOf = [&](std::size_t point, const char* buffer, const char* measure) {
        return report.points[point].error({buffer, measure, ErrorKind::Arithmetic});
    };
    EXPECT_GT(errorOf(0, "intensity", "largest"), 0.0);
    EXPECT_EQ(errorOf(1, "intensity", "largest"), std::nullopt);
    EXPECT_EQ(errorOf(1, "z_view", "RMSE"), std::nullopt);
    EXPECT_EQ(errorOf(1, "polygon_id", "pixels that differ"), 0.0);
    EXPECT_NE(report.whyNone[index(ErrorKind::Arithmetic)].find("not measurable"), std::string::npos);
}

// Of a sphere the formula is known; a mesh stands for nothing but its facets.
TEST(RunStudy, aModelsTrueSurfaceIsSaidToBeItsFacets) {
    Scene scene = small();
    const auto nameOf = [](const Scene& of) { return rayCast(of, RaySurfaces::Exact, 0)->name; };
    EXPECT_EQ(nameOf(scene), "the mesh's facets, taken as its true surface, by rays, double");
    const Shape sphere{ShapeKind::Sphere, 8};
    scene.objects.push_back({"sphere", makeShape(sphere), {}, {}, {}, sphere});
    EXPECT_EQ(nameOf(scene), "true surfaces by rays, double; those of a mesh are its facets");
    scene.objects.erase(scene.objects.begin());
    EXPECT_EQ(nameOf(scene), "true surfaces by rays, double");
}

TEST(RunStudy, aSceneWithoutARayReferenceSaysWhy) {
    Scene scene = small();
    scene.settings.visibility = Visibility::Painter;
    const StudyRequest request = requestOf(scene, {"shading=flat,phong"});
    StudyReport report = beginStudy(request);
    ErrorFinder finder(request);
    ASSERT_TRUE(finder.find(report.points[0], report, {}));
    EXPECT_EQ(report.references[index(ErrorKind::Model)], "");
    EXPECT_NE(report.whyNone[index(ErrorKind::Model)], "");
    EXPECT_NE(report.references[index(ErrorKind::Arithmetic)], "");
    EXPECT_TRUE(report.points[0].blame.empty());
}

TEST(RunStudy, partsOfOneStudyBecomeOneAndOthersAreRefused) {
    StudyRequest request = requestOf(small(), {"shading=flat,gouraud,phong"});
    request.shards = 2;
    StudyReport even = beginStudy(request);
    request.shard = 1;
    StudyReport odd = beginStudy(request);
    EXPECT_EQ(even.points.size(), 2u);
    EXPECT_EQ(missingPoints(even), 1u);
    even.load = {0.5}, odd.load = {1.5};
    const auto merged = mergeStudies({odd, even});
    ASSERT_TRUE(merged);
    ASSERT_EQ(merged->points.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(merged->points[i].number, i);
    EXPECT_EQ(merged->load, (std::vector{1.5, 0.5}));
    EXPECT_EQ(missingPoints(*merged), 0u);

    Scene darker = small();
    darker.ambient.intensity = 1;
    const auto other = mergeStudies({even, beginStudy(requestOf(darker, {"shading=flat,gouraud,phong"}))});
    ASSERT_FALSE(other);
    EXPECT_EQ(other.errors().front().found, "part 2 is of another study than part 1: ambient.intensity is 50 and 1");
}

// What no setting tells: a vertex, a turn, a back material.
TEST(RunStudy, partsOfScenesWithOtherMeshesAreRefused) {
    const auto partOf = [](const Scene& scene) { return beginStudy(requestOf(scene, {"shading=flat,phong"})); };
    const StudyReport part = partOf(small());
    EXPECT_TRUE(mergeStudies({part, partOf(small())}));
    Scene moved = small(), turned = small(), painted = small();
    Mesh mesh = *moved.objects[0].mesh;
    const Vec3d first = mesh.positions[0];
    mesh.positions.set(0, first + Vec3d(0, 0, 1e-9));
    moved.objects[0].mesh = std::make_shared<const Mesh>(mesh);
    turned.objects[0].transform.turns.push_back({10, {0, 0, 1}});
    painted.objects[0].backMaterial = Material{};
    Scene mirrored = small();
    mesh.positions.set(0, first);
    test::moveVertices(mesh, [](Vec3d p) { return Vec3d(-1, 1, 1) * p; });
    mirrored.objects[0].mesh = std::make_shared<const Mesh>(mesh);
    for (const Scene& other : {moved, turned, painted, mirrored}) {
        const auto merged = mergeStudies({part, partOf(other)});
        ASSERT_FALSE(merged);
        EXPECT_NE(merged.errors().front().found.find("have other meshes or turns"), std::string::npos);
    }
}

// The same times once more are no more measurements: the interval would shrink for nothing.
TEST(RunStudy, aPartThatIsGivenTwiceIsRefused) {
    StudyReport part = beginStudy(requestOf(small(), {"shading=flat,phong"}));
    for (StudyPoint& point : part.points) point.frame.processes = {{1.25, 2.5}, {1.5, 2.75}};
    StudyReport other = part;
    for (StudyPoint& point : other.points) point.frame.processes = {{1.25, 2.625}};
    EXPECT_TRUE(mergeStudies({part, other}));
    const auto twice = mergeStudies({part, other, part});
    ASSERT_FALSE(twice);
    EXPECT_EQ(twice.errors().front().found, "part 3 has times that a part before has too");
    // Of one frame each, two points may agree by chance, all do not.
    for (StudyPoint& point : part.points) point.frame.processes = {{1.25}};
    other = part;
    EXPECT_FALSE(mergeStudies({part, other}));
    other.points[0].frame.processes = {{1.5}};
    EXPECT_TRUE(mergeStudies({part, other}));
}

// Two parts of 3 processes with the same points hold 6 a point; a part with other points adds none to these. Of a part
// that was to have 3 and was interrupted after 2, 2 are there.
TEST(RunStudy, partsWithTimesOfTheSamePointsHaveTheProcessesOfBoth) {
    double milliseconds = 1;  // no two frames take the same
    const auto part = [&](std::size_t shard, std::size_t processes) {
        StudyRequest request = requestOf(small(), {"shading=flat,phong"});
        request.shards = 2, request.shard = shard;
        StudyReport report = beginStudy(request);
        for (StudyPoint& point : report.points)
            for (std::size_t i = 0; i < processes; ++i, ++milliseconds)
                point.frame.processes.push_back({milliseconds, milliseconds + 0.5});
        report.processes = 3;
        return report;
    };
    EXPECT_EQ(mergeStudies({part(0, 3), part(0, 3)})->processes, 6);
    EXPECT_EQ(mergeStudies({part(0, 3), part(1, 3)})->processes, 3);
    EXPECT_EQ(mergeStudies({part(0, 2), part(1, 2)})->processes, 2);
}

}  // namespace
