// The vectors of pipeline/simd against the stages' own text, bit by bit.
#include <gtest/gtest.h>

#include <cstring>
#include <numeric>
#include <random>
#include <set>

#include "pipeline/run/frame_data.h"
#include "pipeline/scene/mesh/shape.h"
#include "pipeline/simd/model_kernels.h"
#include "pipeline/simd/seen_blocks.h"
#include "pipeline/simd/shade_pixels.h"
#include "pipeline/simd/transform.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

using test::polygonsOfAllSizes;
using test::spheres;

// The stages' own text, a pixel at a time, against the vectors that the runner takes in float.
void expectTheSameBits(const Scene& scene) {
    const FramePtr frame = test::frameOf(
        scene, setOf({BufferId::Color, BufferId::Overdraw, BufferId::Barycentric, BufferId::PolygonsNormal}));
    const FrameData<float>& data = *dataOf<float>(*frame);
    const TransformOutput<float>& in = *data.transform;
    // Whole, also where the runner makes no copies.
    TransformInputs transformInputs = data.keys.transform;
    NormalsInputs normalsInputs = data.keys.normals;
    transformInputs.placesAsGiven = normalsInputs.asGiven = false;
    TransformOutput<float> transformed = prepareTransform<float>(transformInputs);
    for (std::size_t object = 0; object < scene.objects.size(); ++object)
        transform(transformInputs, object, 0, in.topology->meshes[object]->positions.size(), transformed);
    EXPECT_EQ(transformed.world, in.world);
    if (data.cull) {
        CullOutput culled = prepareCull(in.topology->polygonCount());
        cull(data.keys.cull, in, 0, in.topology->polygonCount(), culled);
        EXPECT_EQ(culled.verdicts, data.cull->verdicts);
        EXPECT_EQ(culled.marks, data.cull->marks);
    }
    NormalsOutput<float> normals = prepareNormals(normalsInputs, in);
    polygonNormals(normalsInputs, in, 0, normals.polygon.size(), normals);
    for (std::size_t object = 0; object < scene.objects.size() && normalsInputs.vertexNormals; ++object) {
        sumAroundVertices(normalsInputs, in, object, normals);
        unitVertexNormals(normalsInputs, in, object, 0, scene.objects[object].mesh->positions.size(), normals);
        replaceVanishing(in, object, normals);
    }
    EXPECT_EQ(normals.polygon, data.normals->polygon);
    EXPECT_EQ(normals.vertex, data.normals->vertex);
    EXPECT_EQ(normals.vanishing, data.normals->vanishing);
    const TriangleBins<float> bins = binTriangles<float>(*in.topology, in.view, in.world, data.verdicts());
    ZBufferOutput<float> out = prepareZBuffer<float>({{0, 0}, in.view.size}, DepthFormat::Linear);
    for (std::size_t tile = 0; tile < bins.bins.size(); ++tile)
        zBuffer(in.view, DepthFormat::Linear, bins, bins.bins[tile], bins.tile(tile), out);
    EXPECT_EQ(out.zView->pixels, data.zBuffer->zView->pixels);
    EXPECT_EQ(out.triangle->pixels, data.zBuffer->triangle->pixels);
    EXPECT_EQ(out.barycentric.pixels, data.zBuffer->barycentric.pixels);
    EXPECT_EQ(out.overdraw.pixels, data.zBuffer->overdraw.pixels);
    EXPECT_EQ(out.depthWrites.pixels, data.zBuffer->depthWrites.pixels);
    const auto sum = [](const Buffer2D<std::int32_t>& counts) {
        return std::accumulate(counts.pixels.begin(), counts.pixels.end(), 0LL);
    };
    EXPECT_EQ(sum(out.overdraw), data.zBuffer->arrived);
    EXPECT_EQ(sum(out.depthWrites), data.zBuffer->won);
    for (int y = 0; y < in.view.size.y; y += 7)
        for (int x = 0; x < in.view.size.x; x += 5) {
            const std::uint32_t id = out.triangle->at({x, y});
            if (id == kNoTriangle) continue;
            EXPECT_EQ(barycentricAt(in, id, {x, y}), out.barycentric.at({x, y}));
        }
    if (!data.shadowBuffer) return;
    const ShadowBufferOutput<float> prepared = prepareShadowBuffer(data.keys.shadowBuffer, in);
    for (std::size_t k = 0; k < prepared.lights.size(); ++k) {
        const std::vector<LightView<float>>& samples = data.shadowBuffer->lights[k];
        ASSERT_EQ(samples.size(), prepared.lights[k].size());
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const LightView<float>& light = samples[i];
            EXPECT_EQ(light.faces, prepared.lights[k][i].faces);
            EXPECT_EQ(light.rounding, prepared.lights[k][i].rounding);
            for (std::size_t face = 0; face < light.faces.size(); ++face) {
                const TriangleBins<float> seen = binForLight(in, light.faces[face], data.keys.shadowBuffer.cull);
                Buffer2D<float> depth(light.faces[face].size, std::numeric_limits<float>::infinity());
                for (std::size_t tile = 0; tile < seen.bins.size(); ++tile)
                    shadowBuffer(light.faces[face], seen, tile, depth);
                EXPECT_EQ(depth.pixels, light.depth[face]->pixels);
            }
        }
    }
}

TEST(Vectors, RasterizeToTheSameBits) {
    Scene scene = spheres();
    scene.objects.push_back(scene.objects[0]);  // ties at every pixel of it
    expectTheSameBits(scene);
    scene.lights[0].kind = LightKind::Point;
    scene.camera.projection = ProjectionKind::Orthographic;
    expectTheSameBits(scene);
    for (unsigned seed = 0; seed < 60; ++seed) {
        Scene random = test::randomScene(seed);
        random.settings.precision = Precision::Float, random.settings.depthFormat = DepthFormat::Linear;
        random.settings.visibility = Visibility::ZBuffer;
        for (Object& object : random.objects) object.material.alpha = 1;
        if (random.settings.antialiasing == 1) expectTheSameBits(random);
    }
}

TEST(Vectors, CullPolygonsOfAnyNumberOfCornersToTheSameBits) {
    Scene scene = polygonsOfAllSizes();
    for (const CullMode cull : {CullMode::Back, CullMode::None})
        for (const Shading shading : {Shading::Flat, Shading::Gouraud}) {
            scene.settings.cull = cull, scene.settings.shading = shading;
            expectTheSameBits(scene);
        }
}

// 4 * 64 quadrilaterals around and 2 * 64 upwards are 64,512 triangles: set up in several pieces.
TEST(Vectors, RasterizeManyTrianglesToTheSameBits) {
    Scene scene = spheres();
    scene.objects[0].mesh = makeShape({ShapeKind::Sphere, 64});
    scene.objects[0].transform.scale = Vec3d(150);
    expectTheSameBits(scene);
}

// A shadow buffer draws what faces the light first and leaves out the rest where that is nearer. Of a sphere that is
// turned inside out, what faces away is the nearer; of one in another that is turned, it depends on the place; planes of
// 2 triangles through all of it are larger than the tiles.
TEST(Vectors, DrawShadowsOfWhatIsTurnedInsideOutToTheSameBits) {
    const auto turned = [](const Mesh& mesh) {
        Mesh out;
        out.positions = mesh.positions;
        for (std::size_t i = mesh.polygonCount(); i-- > 0;) {
            const auto corners = mesh.polygon(i);
            out.addPolygon(std::vector(corners.rbegin(), corners.rend()));
        }
        return makeMesh(std::move(out));
    };
    for (int i = 0; i < 6; ++i) {
        Scene scene = spheres();
        scene.lights[0].kind = i % 2 ? LightKind::Point : LightKind::AtInfinity;
        scene.settings.cull = CullMode::None, scene.settings.shadowCull = ShadowCull(i / 2);
        Object inner = scene.objects[0];
        inner.mesh = turned(*inner.mesh), inner.transform.scale *= 0.9;
        Object plane = scene.objects[0];
        plane.mesh = makeShape({ShapeKind::Plane, 1}), plane.transform.scale = Vec3d(900);
        scene.objects.push_back(inner), scene.objects.push_back(plane);
        scene.objects[1].mesh = turned(*scene.objects[1].mesh);
        scene.objects[2].transform.scale.x *= -1;
        expectTheSameBits(scene);
    }
}

// A sum of area vectors grows with the square of the scale: at 2^-20 and at 2^18 its own square has to be scaled, in some
// of the vertices. A sheet of two sides has sums that vanish: 20 polygons back to back at 12 vertices of their own.
TEST(Vectors, FindNormalsOfAnySizeToTheSameBits) {
    Scene scene = spheres();
    scene.settings.shading = Shading::Phong;
    scene.settings.normalWeight = NormalWeight::Area;
    const Object sphere = scene.objects[0];
    for (const double scale : {0x1p-20, 0x1p-14, 0x1p18, 0x1p60}) {
        scene.objects.push_back(sphere);
        scene.objects.back().transform.scale = Vec3d(scale);
    }
    Object sheet = sphere;
    std::vector<Vec3d> positions;
    std::vector<std::vector<std::uint32_t>> polygons;
    for (std::uint32_t i = 0; i < 12; ++i) positions.emplace_back(i / 2, i % 2, 0);
    for (std::uint32_t i = 0; i < 10; ++i) polygons.push_back({i, i + 1, i + 2}), polygons.push_back({i + 2, i + 1, i});
    sheet.mesh = test::mesh(positions, polygons);
    scene.objects.push_back(sheet);
    expectTheSameBits(scene);
    scene.objects = {sheet};
    const FramePtr frame = test::frameOf(scene, setOf({BufferId::Color}));
    EXPECT_EQ(dataOf<float>(*frame)->normals->vanishing, 12U);
}

// Also where the mesh gives them: its 0, tiny and huge ones stand amid others of a vector.
TEST(Vectors, TurnGivenNormalsToTheSameBits) {
    for (unsigned seed = 0; seed < 40; ++seed) {
        Scene scene = spheres();
        scene.settings.shading = Shading::Phong;
        scene.objects.push_back(scene.objects[0]);
        scene.objects.back().transform.scale = {1, -0.3, 2};
        std::mt19937 random(seed);
        test::giveNormals(scene, random);
        expectTheSameBits(scene);
    }
}

// Edge functions beyond what double holds: a triangle from one end of the guard band to the other.
TEST(Vectors, RasterizeHugeTrianglesToTheSameBits) {
    Scene scene = test::pyramid();
    scene.camera.kind = CameraKind::LookAt;
    scene.camera.eye = {1, 1, 10}, scene.camera.target = {1.3, 1.1, 0}, scene.camera.up = {0, 1, 0};
    scene.camera.near = 1e-3, scene.camera.far = 1e6;
    scene.objects[0].transform.scale = Vec3d(1000);
    for (const int bits : {1, 8, 12, 16}) {
        scene.settings.subPixelBits = bits;
        expectTheSameBits(scene);
    }
}

// What shadePixels leaves, a pixel at a time, against what the runner's vectors left in the frame. Returns whether there
// was anything to compare.
bool expectTheSameShading(const Scene& scene, BufferSet wanted) {
    const FramePtr frame = test::frameOf(scene, wanted.set(index(BufferId::Barycentric)));
    const FrameData<float>& data = *dataOf<float>(*frame);
    ShadingInputs inputs = data.keys.shading;
    if (!inputs.parts[Part::ShadedInVectors] || inputs.samples > 1) return false;
    inputs.parts.whole.set(Part::ShadedInVectors, false);
    BufferSet made;
    for (std::size_t id = 0; id < kBufferCount; ++id)
        made[id] = !data.shading->vectors[id].empty() || !data.shading->scalars[id].empty();
    made.reset(index(BufferId::Antialiased));  // made of the picture afterwards
    ShadingOutput<float> out = prepareShading(inputs, data.shadingSources(), made);
    out.polygons = data.shading->polygons, out.vertices = data.shading->vertices;
    ShadingCounts counts;
    const glm::ivec2 size = data.transform->view.size;
    for (std::size_t tile = 0; tile < data.zBuffer->tileIsDrawn.size(); ++tile)
        if (data.zBuffer->tileIsDrawn[tile])
            counts += shadePixels(inputs, data.shadingSources(), tileOf(size, tile), out);
    const auto bits = [](const auto& pixels) {
        std::vector<std::uint32_t> words(pixels.size() * sizeof(pixels[0]) / 4);
        if (!words.empty()) std::memcpy(words.data(), pixels.data(), words.size() * 4);
        return words;
    };
    EXPECT_EQ(bits(out.color.pixels), bits(data.shading->color.pixels));
    for (std::size_t id = 0; id < kBufferCount; ++id) {
        const std::string_view name = bufferTable()[id].name;
        if (!made[id]) continue;  // intensity, which shadePixels leaves anyway
        for (std::size_t k = 0; k < out.vectors[id].size(); ++k)
            EXPECT_TRUE(bits(out.vectors[id][k].pixels) == bits(data.shading->vectors[id][k].pixels)) << name << k;
        for (std::size_t k = 0; k < out.scalars[id].size(); ++k)
            EXPECT_TRUE(bits(out.scalars[id][k].pixels) == bits(data.shading->scalars[id][k].pixels)) << name << k;
    }
    if (!inputs.parts[Part::PolygonTerms] && !inputs.parts[Part::VertexTerms]) {  // else these have been counted too
        EXPECT_EQ(counts.evaluations, data.shading->counts.evaluations);
        EXPECT_EQ(counts.powers, data.shading->counts.powers);
        EXPECT_EQ(counts.vanished, data.shading->counts.vanished);
    }
    EXPECT_EQ(counts.lookups, data.shading->counts.lookups);
    EXPECT_EQ(counts.idleLookups, data.shading->counts.idleLookups);
    return true;
}

BufferSet withoutVectors() {
    using enum BufferId;
    BufferSet wanted = test::everyBuffer();
    for (const BufferId id :
         {DiffuseCoefficient, Normal, ViewVector, LightVector, ReflectionVector, HalfwayVector, NDotL, RDotV, NDotH})
        wanted.reset(index(id));
    return wanted;
}

TEST(Vectors, ShadeToTheSameBits) {
    for (const Model model : {Model::Phong, Model::BlinnPhong, Model::OpenGl, Model::CookTorrance})
        for (const Shading shading : {Shading::Flat, Shading::Gouraud, Shading::Phong}) {
            if (!whyNoKernel(model).empty() && shading == Shading::Phong) continue;
            Scene scene = spheres();
            scene.settings.model = model, scene.settings.shading = shading;
            scene.objects[1].material.highlight = Highlight::Phong;
            for (const LightKind kind : {LightKind::AtInfinity, LightKind::Point, LightKind::Area}) {
                scene.lights[0].kind = kind;
                scene.lights[0].area = {{-1, -1, -1}, 80, 80, 2};
                const BufferSet all = shading == Shading::Phong ? test::everyBuffer() : withoutVectors();
                EXPECT_TRUE(expectTheSameShading(scene, all));
                EXPECT_TRUE(expectTheSameShading(scene, setOf({BufferId::Color})));
                scene.settings.shadowFilter = 1, scene.settings.shadowBias = ShadowBias::Slope;
                scene.settings.shadowBiasValue = 0.5;
            }
        }
}

// Where nearly every pixel sees another triangle, they are looked at pixel by pixel: of spheres of triangles smaller than a
// pixel, drawn in each of their six orders. A plane through all of it, cut by the near plane, is seen in some of the same
// vectors.
Scene fineMeshes() {
    Scene scene = spheres();
    scene.settings.width = 97, scene.settings.height = 71, scene.settings.cull = CullMode::None;
    for (Object& object : scene.objects) object.mesh = test::sphere(150, 60, 90);
    Object plane = scene.objects[0];
    plane.mesh = makeShape({ShapeKind::Plane, 1}), plane.transform.scale = Vec3d(9000);
    plane.transform.rotation = {80, 0, 20};
    scene.objects.push_back(plane);
    return scene;
}

// How many of the six orders there are in which corners are drawn: which of them is the farthest, and whether they run
// clockwise on the screen.
std::size_t cornerOrders(const TransformOutput<float>& in) {
    std::set<std::pair<std::ptrdiff_t, bool>> orders;
    for (const Triangle& triangle : in.topology->triangles) {
        std::array<SnappedVertex, 3> c{};
        for (std::size_t i = 0; i < 3; ++i) c[i] = in.snapped.of[triangle.vertices[i]];
        const auto farthest = std::ranges::min_element(c, {}, &SnappedVertex::w) - c.begin();
        const auto x = [&](std::size_t i) { return double(c[i].x) - double(c[0].x); };
        const auto y = [&](std::size_t i) { return double(c[i].y) - double(c[0].y); };
        orders.emplace(farthest, x(1) * y(2) > y(1) * x(2));
    }
    return orders.size();
}

TEST(Vectors, ShadeTrianglesSmallerThanPixelsToTheSameBits) {
    for (const ProjectionKind projection : {ProjectionKind::Perspective, ProjectionKind::Orthographic})
        for (const LightKind kind : {LightKind::AtInfinity, LightKind::Point}) {
            Scene scene = fineMeshes();
            scene.camera.projection = projection, scene.lights[0].kind = kind;
            const FramePtr frame = test::frameOf(scene, setOf({BufferId::Color}));
            const ZBufferOutput<float>& drawn = *dataOf<float>(*frame)->zBuffer;
            long long others = 0;
            for (const TrianglePiece& piece : drawn.seen->pieces.pieces) others += std::ssize(piece.others);
            EXPECT_LT(drawn.seenPixels, 4 * static_cast<long long>(drawn.seen->triangles));
            EXPECT_GT(others, 0);
            EXPECT_EQ(cornerOrders(*dataOf<float>(*frame)->transform), 6u);
            expectTheSameBits(scene);
            EXPECT_TRUE(expectTheSameShading(scene, test::everyBuffer()));
            EXPECT_TRUE(expectTheSameShading(scene, setOf({BufferId::Color})));
            scene.objects.resize(1);
            EXPECT_TRUE(expectTheSameShading(scene, setOf({BufferId::Color})));
        }
}

// Lights beside, between and around the objects: points fall on every face of their cubes, and in one vector on several;
// a polygon faces all places of an area light, some of them or none.
TEST(Vectors, LookUpLightsAmidTheObjectsToTheSameBits) {
    Scene scene = spheres();
    Light& light = scene.lights[0];
    for (const Vec3d place : {Vec3d(0, 0, 0), Vec3d(60, -40, 30), Vec3d(-150, 90, -20)})
        for (const ShadowBias bias : {ShadowBias::Automatic, ShadowBias::Constant, ShadowBias::Slope})
            for (const int samples : {1, 3}) {
                light.kind = LightKind::Area, light.position = place, light.area = {{1, 2, -1}, 120, 90, samples};
                scene.settings.shadowBias = bias, scene.settings.shadowBiasValue = 0.7;
                scene.settings.shadowFilter = bias == ShadowBias::Constant ? 1 : 0;
                EXPECT_TRUE(expectTheSameShading(scene, setOf({BufferId::Color, BufferId::Shadow})));
            }
}

// Affine: whole triangles, with perspective and without, and the pieces that a near plane through a sphere leaves.
TEST(Vectors, InterpolateLinearlyInThePictureToTheSameBits) {
    Scene scene = spheres();
    scene.settings.shading = Shading::Gouraud, scene.settings.interpolation = Interpolation::Affine;
    scene.settings.cull = CullMode::None;
    EXPECT_TRUE(expectTheSameShading(scene, withoutVectors()));
    scene.camera.near = scene.camera.rho;
    EXPECT_TRUE(expectTheSameShading(scene, withoutVectors()));
    scene.camera.near = 0, scene.camera.projection = ProjectionKind::Orthographic;
    EXPECT_TRUE(expectTheSameShading(scene, withoutVectors()));
}

// Whatever the processor has: the kernels of each instruction set, of a single number too.
TEST(Vectors, HaveTheSameBitsInEveryWidth) {
    if (test::kHasOneInstructionSet) GTEST_SKIP() << test::kWhyNotCompared;
    Scene phong = spheres(), gouraud = spheres(), area = spheres(), affine = spheres();
    const Scene fine = fineMeshes();
    affine.settings.shading = Shading::Gouraud, affine.settings.interpolation = Interpolation::Affine;
    area.lights[0].kind = LightKind::Area, area.lights[0].area = {{-1, -1, -1}, 80, 80, 3};
    phong.objects[1].material.highlight = Highlight::Phong, phong.settings.model = Model::BlinnPhong;
    gouraud.settings.shading = Shading::Gouraud;
    std::set<int> widths;
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
        SCOPED_TRACE(hwy::TargetName(target));
        widths.insert(vectorLanes());
        expectTheSameBits(phong);
        expectTheSameBits(polygonsOfAllSizes());
        EXPECT_TRUE(expectTheSameShading(phong, test::everyBuffer()));
        EXPECT_TRUE(expectTheSameShading(gouraud, withoutVectors()));
        EXPECT_TRUE(expectTheSameShading(area, test::everyBuffer()));
        EXPECT_TRUE(expectTheSameShading(affine, withoutVectors()));
        EXPECT_TRUE(expectTheSameShading(fine, setOf({BufferId::Color})));
    }
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    EXPECT_GT(widths.size(), 1u);
    EXPECT_LE(*widths.rbegin(), 16);
}

TEST(Vectors, ShadeRandomAndStrangeScenesToTheSameBits) {
    int compared = 0;
    for (unsigned seed = 0; seed < 120; ++seed) {
        Scene scene = seed % 2 ? test::randomScene(seed) : test::strangeScene(seed);
        scene.settings.precision = Precision::Float, scene.settings.arithmetic = Arithmetic::Exact;
        scene.settings.interpolation = Interpolation::Perspective, scene.settings.forms = {};
        if (scene.settings.shading == Shading::Gouraud && seed % 4 < 2)
            scene.settings.interpolation = Interpolation::Affine;
        for (Object& object : scene.objects) object.material.alpha = 1;
        scene.settings.twoSided = false;  // the kernels light one side
        SCOPED_TRACE(seed);
        compared += expectTheSameShading(
            scene, seed % 3 && scene.settings.shading == Shading::Phong ? test::everyBuffer() : withoutVectors());
    }
    EXPECT_GT(compared, 60);
}

}  // namespace
}  // namespace pipeline
