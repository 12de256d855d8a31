// What the manual says of I_max, of a shadow buffer's frame, of the comparison and of the penumbra, computed here from
// its text and from the buffers that an export writes, without the stages' code.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "pipeline/scene/mesh/topology.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

Vec3d vectorAt(const AnyBuffer& buffer, std::size_t i) {
    return {buffer.flat(3 * i), buffer.flat(3 * i + 1), buffer.flat(3 * i + 2)};
}

// A sphere of triangles over a ground, two lights of other colours.
Scene sphereOverGround() {
    Scene scene;
    scene.settings.width = scene.settings.height = 96;
    scene.settings.precision = Precision::Double;
    scene.settings.shading = Shading::Phong;
    scene.settings.shadowSize = 48;
    scene.camera.kind = CameraKind::LookAt;
    scene.camera.eye = {4, -5, 5}, scene.camera.target = {0, 0, 0.4}, scene.camera.fovY = 40;
    scene.objects.push_back(
        {"ground", test::mesh({{-3, -3, 0}, {3, -3, 0}, {3, 3, 0}, {-3, 3, 0}}, {{0, 1, 2}, {0, 2, 3}}), {}, {}});
    scene.objects.push_back({"ball", test::sphere(1, 9, 12), {}, {}});
    scene.objects[1].transform.translation = {0.2, 0.1, 1.3};
    scene.objects[0].material = {{0.3, 0.6, 0.2}, {0.1, 0.1, 0.5}, 5};
    scene.objects[1].material = {{0.7, 0.2, 0.4}, {0.3, 0.3, 0.3}, 30};
    scene.ambient = {30, {0.5, 1, 1}};
    scene.lights.push_back({LightKind::AtInfinity, {2, -1, 4}, 100, {1, 0.3, 0.2}, true});
    scene.lights.push_back({LightKind::Point, {-1, -2.5, 3.5}, 80, {0.1, 0.9, 0.4}, true});
    return scene;
}

// settings.md: with k_d and k_s the largest over all objects and colours, I_max is the largest of the three
// k_d I_a,c + sum of I_k,c (k_d + k_s).
TEST(ManualFormulas, ColorIsTheIntensityInShares) {
    const Scene scene = sphereOverGround();
    const FramePtr frame = test::frameOf(scene);
    // Largest k_d 0.7, k_s 0.5. Red: 0.7 15 + (100 + 8) 1.2; green 0.7 30 + (30 + 72) 1.2; blue 0.7 30 + (20 + 32) 1.2.
    const double iMax = std::max({10.5 + 108 * 1.2, 21 + 102 * 1.2, 21 + 52 * 1.2});
    const AnyBuffer intensity = *frame->buffer({BufferId::Intensity}), color = *frame->buffer({BufferId::Color});
    for (std::size_t i = 0; i < color.count(); ++i)
        ASSERT_EQ(color.flat(i), std::floor(255 * std::clamp(intensity.flat(i) / iMax, 0.0, 1.0) + 0.5)) << i;
}

// shadows.md, "Reproduce it outside".
struct Face {
    Vec3d origin, right, up, forward;  // z' counts along forward from origin
    double stepX, stepY;               // texels a unit, at z' = 1 of a point light
    bool perspective;
    int size;

    double depthOf(Vec3d p) const { return glm::dot(forward, p - origin); }
    glm::dvec2 placeOf(Vec3d p) const {  // texels
        const double by = perspective ? depthOf(p) : 1;
        return {size / 2.0 + stepX * glm::dot(right, p - origin) / by,
                size / 2.0 - stepY * glm::dot(up, p - origin) / by};
    }
};

Face faceAlong(Vec3d forward, Vec3d axis) {
    Face face{};
    face.forward = forward;
    face.right = glm::normalize(glm::cross(forward, axis));
    face.up = glm::cross(face.right, forward);
    return face;
}

Face faceAtInfinity(const std::vector<Vec3d>& vertices, Vec3d towards, int size) {
    const Vec3d f = -glm::normalize(towards), a = glm::abs(f);
    const Vec3d axis = a.z <= std::min(a.x, a.y) ? Vec3d(0, 0, 1) : a.y <= a.x ? Vec3d(0, 1, 0) : Vec3d(1, 0, 0);
    Face face = faceAlong(f, axis);
    Vec3d low(1e300), high(-1e300);
    for (const Vec3d& p : vertices) {
        const Vec3d q(glm::dot(face.right, p), glm::dot(face.up, p), glm::dot(f, p));
        low = glm::min(low, q), high = glm::max(high, q);
    }
    face.origin = (low.x + high.x) / 2 * face.right + (low.y + high.y) / 2 * face.up + low.z * f;
    face.stepX = (size - 2) / (high.x - low.x), face.stepY = (size - 2) / (high.y - low.y);
    face.size = size;
    return face;
}

std::vector<Face> facesOf(const std::vector<Vec3d>& vertices, const Light& light, int size) {
    if (light.kind == LightKind::AtInfinity) return {faceAtInfinity(vertices, light.position, size)};
    std::vector<Face> faces;
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {1.0, -1.0}) {
            Vec3d forward(0);
            forward[axis] = sign;
            Face face = faceAlong(forward, axis == 2 ? Vec3d(0, 1, 0) : Vec3d(0, 0, 1));
            face.origin = light.position, face.perspective = true, face.size = size;
            face.stepX = face.stepY = size / 2.0;
            faces.push_back(face);
        }
    return faces;
}

struct World {
    std::vector<Vec3d> vertices;
    std::vector<std::array<Vec3d, 3>> triangles;
};
World worldOf(const Frame& frame) {
    World world;
    const AnyBuffer places = *frame.buffer({BufferId::VerticesWorld});
    for (std::size_t i = 0; i < places.rows(); ++i) world.vertices.push_back(vectorAt(places, i));
    for (const Triangle& t : frame.topology().triangles)
        world.triangles.push_back(
            {world.vertices[t.vertices[0]], world.vertices[t.vertices[1]], world.vertices[t.vertices[2]]});
    return world;
}

// The nearest z' along the ray through the centre of a texel; the second is how near to a triangle's edge it passes, as a
// share of the triangle, at a surface no farther than that.
std::pair<double, double> nearest(const Face& face, const World& world, glm::dvec2 centre) {
    const double x = (centre.x - face.size / 2.0) / face.stepX, y = (face.size / 2.0 - centre.y) / face.stepY;
    const Vec3d across = x * face.right + y * face.up;
    const Vec3d from = face.perspective ? face.origin : face.origin + across - 1e3 * face.forward;
    const Vec3d way = face.perspective ? face.forward + across : face.forward;
    double z = std::numeric_limits<double>::infinity(), margin = 1;
    for (const auto& [a, b, c] : world.triangles) {
        const Vec3d n = glm::cross(b - a, c - a);
        const double by = glm::dot(n, way);
        if (by == 0) continue;
        const double t = glm::dot(n, a - from) / by;
        const Vec3d p = from + t * way;
        const double area = glm::dot(n, n);
        const double least = std::min({glm::dot(n, glm::cross(b - a, p - a)), glm::dot(n, glm::cross(c - b, p - b)),
                                       glm::dot(n, glm::cross(a - c, p - c))}) /
                             area;
        if (!(t > 0)) continue;
        margin = std::min(margin, std::abs(least));
        if (least >= 0) z = std::min(z, face.depthOf(p));
    }
    return {z, margin};
}

// Vertices are snapped to 1/256 texel: texels next to an edge may see the other side of it.
TEST(ManualFormulas, AShadowBufferHoldsTheNearestDistanceAtItsTexelsCentres) {
    const Scene scene = sphereOverGround();
    const FramePtr frame = test::frameOf(scene);
    const World world = worldOf(*frame);
    for (std::size_t k = 0; k < scene.lights.size(); ++k) {
        const AnyBuffer Z = *frame->buffer({BufferId::ShadowBuffer, int(k)});
        const std::vector<Face> faces = facesOf(world.vertices, scene.lights[k], scene.settings.shadowSize);
        const auto size = std::size_t(scene.settings.shadowSize);
        ASSERT_EQ(Z.count(), faces.size() * size * size);
        int compared = 0, held = 0;
        for (std::size_t i = 0; i < Z.count(); ++i) {
            const glm::dvec2 centre(double(i % size) + 0.5, double(i / size % size) + 0.5);
            const auto [z, margin] = nearest(faces[i / (size * size)], world, centre);
            if (margin < 0.02) continue;
            ++compared;
            if (!std::isfinite(z)) {
                ASSERT_EQ(Z.flat(i), z) << i;
                continue;
            }
            ++held;
            ASSERT_NEAR(Z.flat(i), z, 0.01 * z) << "light " << k << ", number " << i;
        }
        EXPECT_GT(compared, int(Z.count() / 2)) << k;
        EXPECT_GT(held, 300) << k;
    }
}

double storedAt(const AnyBuffer& Z, const Face& face, std::size_t number, int x, int y) {
    const auto size = std::size_t(face.size);
    return Z.flat(number * size * size + std::size_t(y) * size + std::size_t(x));
}

// The bias of shadows.md: by the plane of the point's triangle, and by the surface that the texel holds.
double biasOf(const AnyBuffer& Z, const Face& face, std::size_t number, Vec3d p, Vec3d normal, glm::ivec2 texel,
              double rounding) {
    const Vec3d n(glm::dot(face.right, normal), glm::dot(face.up, normal), glm::dot(face.forward, normal));
    const double delta = (0.5 + 1.0 / 128) * (std::abs(n.x) / face.stepX + std::abs(n.y) / face.stepY);
    double own = delta / std::abs(n.z);
    const double z = face.depthOf(p);
    if (face.perspective) {
        const double share = z * delta / std::abs(glm::dot(normal, p - face.origin));
        own = z * share / (1 + share);
    }
    const glm::dvec2 offset = face.placeOf(p) - (glm::dvec2(texel) + 0.5);
    const double stored = storedAt(Z, face, number, texel.x, texel.y);
    double held = 0;
    for (int axis = 0; axis < 2; ++axis) {
        glm::ivec2 beside = texel;
        beside[axis] += offset[axis] > 0 ? -1 : 1;
        if (beside[axis] < 0 || beside[axis] >= face.size) continue;
        const double there = storedAt(Z, face, number, beside.x, beside.y);
        if (stored > there) held += (stored - there) / (face.perspective ? there : 1) * std::abs(offset[axis]);
    }
    if (face.perspective) held = held < 1 ? stored * held / (1 - held) : 0;
    return std::max(own + rounding, held);
}

TEST(ManualFormulas, SIsTheComparisonWithTheBiasOfBothPlanes) {
    const Scene scene = sphereOverGround();
    const FramePtr frame = test::frameOf(scene);
    const World world = worldOf(*frame);
    const AnyBuffer ids = *frame->buffer({BufferId::PolygonId}), places = *frame->buffer({BufferId::Position}),
                    normals = *frame->buffer({BufferId::PolygonsNormal});
    for (std::size_t k = 0; k < scene.lights.size(); ++k) {
        const Light& light = scene.lights[k];
        const AnyBuffer Z = *frame->buffer({BufferId::ShadowBuffer, int(k)}),
                        S = *frame->buffer({BufferId::Shadow, int(k)});
        const std::vector<Face> faces = facesOf(world.vertices, light, scene.settings.shadowSize);
        double largest = 0;
        for (const Vec3d& p : world.vertices)
            largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
        for (int c = 0; c < 3; ++c) largest = std::max(largest, std::abs(faces[0].origin[c]));
        int lit = 0, dark = 0;
        for (std::size_t i = 0; i < ids.count(); ++i) {
            if (ids.flat(i) < 0) continue;
            const Vec3d p = vectorAt(places, i), n = vectorAt(normals, std::size_t(ids.flat(i)));
            const Vec3d towards = light.kind == LightKind::AtInfinity ? light.position : light.position - p;
            if (!(glm::dot(n, towards) > 0)) {
                ASSERT_EQ(S.flat(i), 0);
                continue;
            }
            std::size_t number = 0;
            if (faces.size() > 1) {
                const Vec3d d = p - light.position, a = glm::abs(d);
                const int axis = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
                number = std::size_t(2 * axis + (d[axis] < 0));
            }
            const Face& face = faces[number];
            const glm::ivec2 texel(glm::floor(face.placeOf(p)));
            const double z = face.depthOf(p), stored = storedAt(Z, face, number, texel.x, texel.y);
            const double bias = biasOf(Z, face, number, p, n, texel, 16 * 0x1p-52 * largest);
            if (std::abs(z - (stored + bias)) < 1e-9 * z) continue;
            ASSERT_EQ(S.flat(i), z > stored + bias ? 0 : 1) << "light " << k << ", pixel " << i;
            (S.flat(i) == 0 ? dark : lit)++;
        }
        EXPECT_GT(lit, 1000) << k;
        EXPECT_GT(dark, 100) << k;
    }
}

// Of a straight edge N columns of samples tell S with an error of 1/(2N) at most; and each sample's edge lies up to half a
// texel beside the true one, t/2 on the floor, over which S changes by t/(2W), W the penumbra's width: here 2/3, of a
// light of width 2 at height 4 over an edge at height 1. Snapping adds 1/256 texel.
TEST(ManualFormulas, ThePenumbraErrsByHalfACellAndHalfATexel) {
    for (const int samples : {1, 2, 3, 8})
        for (const int size : {16, 64, 256}) {
            Scene scene;
            scene.settings.width = 200, scene.settings.height = 20;
            scene.settings.shadowSize = size;
            scene.settings.precision = Precision::Double;
            scene.settings.cull = CullMode::None;
            scene.camera.kind = CameraKind::LookAt;
            scene.camera.projection = ProjectionKind::Orthographic;
            scene.camera.eye = {0, 0, -20}, scene.camera.target = {0, 0, 0}, scene.camera.up = {0, 1, 0};
            scene.camera.height = 0.2;
            const auto across = [](double left, double right, double z) {
                return test::mesh({{left, -8, z}, {right, -8, z}, {right, 8, z}, {left, 8, z}}, {{0, 1, 2, 3}});
            };
            scene.objects = {{"floor", across(-8, 8, 0), {}, {}}, {"blocker", across(-8, 0, 1), {}, {}}};
            Light light{LightKind::Area, {0, 0, 4}, 100, Vec3d(1), true};
            light.area = {{0, 0, -1}, 2, 0, samples};
            scene.lights = {light};
            const FramePtr frame = test::frameOf(scene);
            const AnyBuffer S = *frame->buffer({BufferId::Shadow, 0}), place = *frame->buffer({BufferId::Position});
            const double W = 2.0 / 3, t = 2.0 * 4 / size, bound = 0.5 / samples + (t / 2 + t / 256) / W;
            double worst = 0;
            for (std::size_t i = 0; i < S.count(); ++i) {
                const double visible = std::clamp(0.5 + place.flat(3 * i) / W, 0.0, 1.0);
                worst = std::max(worst, std::abs(S.flat(i) - visible));
            }
            EXPECT_LE(worst, bound) << samples << " samples, " << size;
            // Of a jump of 1/N one side errs by half of it, or does so at the next pixel, 0.01 on.
            EXPECT_GT(worst, 0.5 / samples - 0.01 / W) << samples << " samples, " << size;
        }
}

}  // namespace
}  // namespace pipeline
