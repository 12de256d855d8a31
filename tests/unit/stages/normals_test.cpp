#include "pipeline/stages/normals.h"

#include <gtest/gtest.h>

#include "pipeline/core/numerics.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

Vec3d rowOf(const AnyBuffer& b, std::size_t row) {
    return {b.value(0, row, 0), b.value(0, row, 1), b.value(0, row, 2)};
}

FramePtr frameOf(std::shared_ptr<const Mesh> mesh, NormalWeight weight = NormalWeight::Mean, Vec3d scale = Vec3d(1),
                 Precision precision = Precision::Double) {
    Scene scene;
    scene.settings.precision = precision;
    scene.settings.normalWeight = weight;
    scene.objects = {{"mesh", std::move(mesh), {scale, {}, {}}, {}}};
    scene.camera.kind = CameraKind::LookAt;
    return test::frameOf(scene);
}
Vec3d polygonNormal(const FramePtr& frame, std::size_t i) {
    return rowOf(*frame->buffer({BufferId::PolygonsNormal}), i);
}
Vec3d vertexNormal(const FramePtr& frame, std::size_t i) {
    return rowOf(*frame->buffer({BufferId::VerticesNormal}), i);
}

double degreesBetween(Vec3d a, Vec3d b) { return angleBetween(a, b) * 57.29577951308232; }

// Newell on (0,0,0) (1,0,0) (1,1,h) (0,1,0): half the sum of cross products is (-h/2, -h/2, 1).
TEST(Normals, OfANonPlanarQuadIsNewells) {
    const double h = 0.4;
    const auto quad = test::mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, h}, {0, 1, 0}}, {{0, 1, 2, 3}});
    EXPECT_LT(degreesBetween(polygonNormal(frameOf(quad), 0), {-h / 2, -h / 2, 1}), 1e-12);
}

// Relative to the first vertex, a normal far from the origin keeps its digits: edges of 1 at 10^7.
TEST(Normals, KeepTheirDigitsFarFromTheOrigin) {
    const Vec3d o(1e7, -1e7, 1e7);
    const auto triangle = test::mesh({o, o + Vec3d(1, 0, 0.25), o + Vec3d(0, 1, 0.5)}, {{0, 1, 2}});
    EXPECT_LT(degreesBetween(polygonNormal(frameOf(triangle), 0), {-0.25, -0.5, 1}), 1e-9);
}

// The inverse transpose of scale (1, 1, 10^-6) turns (1, 0, 1) into (10^-6, 0, 1) up to length.
TEST(Normals, GoWithTheInverseTranspose) {
    const auto slope = test::mesh({{0, 0, 0}, {0, 1, 0}, {-1, 0, 1}}, {{1, 2, 0}});
    ASSERT_LT(degreesBetween(polygonNormal(frameOf(slope), 0), {1, 0, 1}), 1e-9);
    const Vec3d scaled = polygonNormal(frameOf(slope, NormalWeight::Mean, {1, 1, 1e-6}), 0);
    EXPECT_LT(degreesBetween(scaled, {1e-6, 0, 1}), 1e-9);
}

TEST(Normals, AMirrorKeepsOutwardOutward) {
    const FramePtr mirrored = frameOf(test::box({-1, -1, -1}, {1, 1, 1}), NormalWeight::Mean, {-1, 1, 1});
    EXPECT_EQ(polygonNormal(mirrored, 1), Vec3d(0, 0, 1));   // the top stays the top
    EXPECT_EQ(polygonNormal(mirrored, 3), Vec3d(-1, 0, 0));  // what was +x is -x now
}

TEST(Normals, OfAPolygonWithoutAreaAreZero) {
    const auto line = test::mesh({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 1, 2}});
    EXPECT_EQ(polygonNormal(frameOf(line), 0), Vec3d(0));
    EXPECT_EQ(vertexNormal(frameOf(line), 0), Vec3d(0));
}

// A cube whose top is two triangles: at the corner that both share, the mean counts the top twice, the angle
// (45 + 45 degrees) once. Area: two triangles of half the square's area, once too.
TEST(Normals, WeightsTellHowPolygonsAreSplit) {
    const auto cube =
        test::mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
                   {{0, 3, 2, 1}, {4, 5, 6}, {4, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}});
    EXPECT_LT(degreesBetween(vertexNormal(frameOf(cube, NormalWeight::Mean), 6), {1, 1, 2}), 1e-12);
    EXPECT_LT(degreesBetween(vertexNormal(frameOf(cube, NormalWeight::Angle), 6), {1, 1, 1}), 1e-12);
    EXPECT_LT(degreesBetween(vertexNormal(frameOf(cube, NormalWeight::Area), 6), {1, 1, 1}), 1e-12);
}

// Two sides of one sheet share their vertices: the mean vanishes, and the first polygon's normal stands in.
TEST(Normals, OfADoubleSidedSheetAreTheFirstPolygons) {
    const auto sheet = test::mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}});
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(vertexNormal(frameOf(sheet), i), Vec3d(0, 0, 1));
}

// Said where a stage's counts are: in the window, by plan --counts, bench, and in the manifest.
TEST(Normals, AVanishingMeanIsReported) {
    const auto counts = [](std::vector<std::vector<std::uint32_t>> polygons) {
        return frameOf(test::mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, polygons))->run(StageId::Normals).counts;
    };
    EXPECT_EQ(counts({{0, 1, 2}, {0, 2, 1}}),
              "2 polygon normals; 3 vertex normals; 3 without a mean, the first polygon's instead");
    EXPECT_EQ(counts({{0, 1, 2}}), "1 polygon normal; 3 vertex normals");
}

// A power of two changes no bit of a normal, however small the mesh. By area, edges below 2^-63 have areas that are not
// normal numbers in float. Of triangles and of quads, whose kernels differ.
TEST(Normals, KeepEveryBitOfAScaledMeshDownToTheSmallestNumbers) {
    const auto vertexNormals = [](const FramePtr& frame, std::size_t count) {
        std::vector<Vec3d> normals;
        for (std::size_t i = 0; i < count; ++i) normals.push_back(vertexNormal(frame, i));
        return normals;
    };
    for (const auto& mesh : {test::sphere(1, 12, 20), test::box({-1, -1, -1}, {1, 2, 3})})
        for (const NormalWeight weight : {NormalWeight::Mean, NormalWeight::Area, NormalWeight::Angle}) {
            const std::size_t count = mesh->positions.size();
            const auto plain = vertexNormals(frameOf(mesh, weight, Vec3d(1), Precision::Float), count);
            for (const int exponent : {-20, -50, -72, -90}) {
                const Vec3d scale(std::ldexp(1.0, exponent));
                const FramePtr frame = frameOf(mesh, weight, scale, Precision::Float);
                EXPECT_EQ(vertexNormals(frame, count), plain) << exponent << " " << int(weight);
                for (std::size_t i = 0; i < mesh->polygonCount(); ++i)
                    EXPECT_NEAR(glm::length(polygonNormal(frame, i)), 1, 1e-6) << exponent;
            }
        }
}

// Two triangles folded onto each other but for 5e-8 rad: their unit normals sum to a vector of that length. In float each of
// them is off by as much, 2^-24, and what is left points anywhere; double has the bisector of the third corners.
TEST(Normals, OpposedButForRoundingAreTheFirstPolygons) {
    const auto mesh = test::mesh({{0.1631126595437225, -0.42552722677878374, 0.89012405852585},
                                  {-0.1631126595437225, 0.42552722677878374, -0.89012405852585},
                                  {-0.8996605140433589, -0.4344826654473671, -0.04284592042411314},
                                  {-0.8996604937945788, -0.4344827051384043, -0.042845943109096424}},
                                 {{0, 2, 1}, {0, 1, 3}});
    const Vec3d bisector(-0.8996605039189695, -0.434482685292886, -0.04284593176660481);
    for (const NormalWeight weight : {NormalWeight::Mean, NormalWeight::Area, NormalWeight::Angle}) {
        const FramePtr inFloat = frameOf(mesh, weight, Vec3d(1), Precision::Float), inDouble = frameOf(mesh, weight);
        for (std::size_t vertex : {0u, 1u}) {
            EXPECT_EQ(vertexNormal(inFloat, vertex), polygonNormal(inFloat, 0)) << int(weight);
            EXPECT_LT(degreesBetween(vertexNormal(inDouble, vertex), bisector), 1e-4) << int(weight);
        }
        EXPECT_NE(inFloat->run(StageId::Normals).counts.find("2 without a mean"), std::string::npos) << int(weight);
        EXPECT_EQ(inDouble->run(StageId::Normals).counts.find("without a mean"), std::string::npos) << int(weight);
    }
}

TEST(Normals, ASliverIsRightToTheStoredInput) {
    const auto sliver = test::mesh({{0, 0, 0}, {1, 0, 0}, {0.5, 1e-6, 1e-6}}, {{0, 1, 2}});
    // (1,0,0) x (0.5, h, h) = (0, -h, h).
    EXPECT_LT(degreesBetween(polygonNormal(frameOf(sliver), 0), {0, -1, 1}), 1e-9);
    EXPECT_LT(
        degreesBetween(polygonNormal(frameOf(sliver, NormalWeight::Mean, Vec3d(1), Precision::Float), 0), {0, -1, 1}),
        1e-4);
}

}  // namespace
}  // namespace pipeline
