// The laws that errors follow as a knob is turned: each known from elsewhere, measured here on frames of a sphere. A law
// that does not show is a defect.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "pipeline/stages/depth.h"
#include "pipeline/study/errors.h"
#include "pipeline/study/ray_caster.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

Object shape(ShapeKind kind, int tessellation, ObjectTransform transform = {}) {
    return {std::string(name(kind)), makeShape({kind, tessellation}), transform, {}, {}, Shape{kind, tessellation}};
}

// The unit sphere from a distance of 4, turned so that no vertex lies where the highlight is.
Scene sphere(Shading shading, int tessellation, double exponent = 8) {
    Scene scene;
    scene.settings.width = scene.settings.height = 160;
    scene.settings.precision = Precision::Double;
    scene.settings.shading = shading;
    scene.camera.kind = CameraKind::LookAt;
    scene.camera.eye = {0, -4, 0}, scene.camera.target = {0, 0, 0}, scene.camera.fovY = 30;
    scene.objects = {shape(ShapeKind::Sphere, tessellation, {Vec3d(1), {13, 29, 7}, {}})};
    scene.objects[0].material.diffuse = Vec3d(0.6);
    scene.objects[0].material.specular = Vec3d(0.4);
    scene.objects[0].material.exponent = exponent;
    scene.lights.push_back({LightKind::AtInfinity, {-0.5, -1, 0.7}, 1, Vec3d(1), true});
    return scene;
}

double error(const Scene& scene, std::string_view buffer, std::string_view measure) {
    Reference found = *rayCast(scene, RaySurfaces::Exact, 0);
    if (buffer == "antialiased") castWholePixels(scene, RaySurfaces::Exact, 0, {}, found);
    const Picture& reference = found.picture;
    const FramePtr frame = test::frameOf(scene, errorsNeed());
    for (const ErrorRow& row : compare(*frame, pictureOf(*frame), {&reference, nullptr}))
        if (row.buffer == buffer && row.measure == measure) return row.value[index(ErrorKind::Model)].value();
    ADD_FAILURE() << "no row " << buffer << " " << measure;
    return 0;
}

// log2 of what is gained by each halving of the edges, from 8 to 64 pieces a quarter circle: from where they are shorter
// than the highlight is wide.
std::vector<double> orders(Shading shading, std::string_view buffer, std::string_view measure) {
    std::vector<double> found;
    double last = 0;
    for (const int tessellation : {8, 16, 32, 64}) {
        const double now = error(sphere(shading, tessellation), buffer, measure);
        if (last > 0) found.push_back(std::log2(last / now));
        last = now;
    }
    return found;
}

// A chord of length h lies h² / 8 below its circle.
TEST(Laws, DepthFallsWithTheSquareOfTheEdge) {
    for (const double order : orders(Shading::Phong, "z_view", "RMSE")) {
        EXPECT_GT(order, 1.5);
        EXPECT_LT(order, 2.1);
    }
}

// One normal a polygon: up to half an edge away from where it is right.
TEST(Laws, FlatColourFallsWithTheEdge) {
    for (const double order : orders(Shading::Flat, "intensity", "RMSE")) EXPECT_NEAR(order, 1, 0.1);
}

// Interpolation that is right at the vertices errs by the second derivative times h² / 8.
TEST(Laws, GouraudAndPhongFallWithTheSquareOfTheEdge) {
    for (const Shading shading : {Shading::Gouraud, Shading::Phong})
        for (const double order : orders(shading, "intensity", "RMSE")) {
            EXPECT_GT(order, 1.5) << int(shading);
            EXPECT_LT(order, 2.1) << int(shading);
        }
}

// (R·V)^1000 has halved where N is off by 1.07 degrees; vertices lie 11, 5.6 and 2.8 degrees apart. Gouraud shading
// loses half and more of k_s = 0.4 of white, Phong shading sees it.
TEST(Laws, GouraudLosesTheHighlightOfExponent1000) {
    for (const int tessellation : {8, 16, 32}) {
        const double gouraud = error(sphere(Shading::Gouraud, tessellation, 1000), "intensity", "largest");
        const double phong = error(sphere(Shading::Phong, tessellation, 1000), "intensity", "largest");
        EXPECT_GT(gouraud, 0.19) << tessellation;
        EXPECT_LT(phong, gouraud / 5) << tessellation;
    }
}

// What lies between two numbers that a fixed format of b bits stores, at distance z:
//   z_k = f n / (f - d_k (f - n)), d_k = (k -+ 1/2) / (2^b - 1); to first order dz = z² (f - n) / (f n (2^b - 1)).
TEST(Laws, FixedDepthsLieInBinsOfZSquared) {
    const double n = 0.1, f = 1000;
    View view;
    view.near = n, view.far = f;
    for (const auto& [format, bits] : {std::pair{DepthFormat::Fixed16, 16}, {DepthFormat::Fixed24, 24}}) {
        const DepthCode code(view, format);
        const auto stored = [&](double z) { return code.encode(z, 1 / z); };
        const double levels = std::exp2(bits) - 1;
        for (const double z : {0.2, 3.0, 47.0, 912.0}) {
            // The ends of the bin by halving.
            const auto endOf = [&](double outside) {
                double in = z, out = outside;
                for (int i = 0; i < 200; ++i) (stored((in + out) / 2) == stored(z) ? in : out) = (in + out) / 2;
                return in;
            };
            const double width = endOf(f * 1.5) - endOf(n);
            const double k = std::round(f * (z - n) / (z * (f - n)) * levels);
            const auto at = [&](double steps) { return f * n / (f - steps / levels * (f - n)); };
            EXPECT_NEAR(width, at(k + 0.5) - at(k - 0.5), 1e-4 * width) << bits << " " << z;
            const double first = z * z * (f - n) / (f * n * levels);
            EXPECT_NEAR(width / first, 1, bits == 16 && z > 100 ? 0.15 : 0.01) << bits << " " << z;
        }
    }
    // 16 bits at 912 of 1000: bins of an eighth of the distance.
    const DepthCode code(view, DepthFormat::Fixed16);
    int bins = 0;
    for (double z = 912 * (1 - 0.063), last = -1; z < 912 * (1 + 0.063); z *= 1 + 1e-4) {
        const double d = code.encode(z, 1 / z);
        bins += d != last, last = d;
    }
    EXPECT_LE(bins, 3);
}

// Near the far plane d is just below 1, where numbers of 32-bit floats lie 2^-24 apart: bins as 24 bits make them. Reversed,
// d = n / z as the far plane goes to infinity, and a float has 24 digits wherever it is: bins of 2^-24 to 2^-23 of z.
TEST(Laws, FloatDepthsLieInBinsOfZSquaredAndReversedOnesOfZ) {
    const double n = 0.1, f = 1e9;
    View view;
    view.near = n, view.far = f;
    const auto width = [&](DepthFormat format, double z) {
        const DepthCode code(view, format);
        const auto endOf = [&](double outside) {
            double in = z, out = outside;
            for (int i = 0; i < 200; ++i)
                (code.encode((in + out) / 2, 2 / (in + out)) == code.encode(z, 1 / z) ? in : out) = (in + out) / 2;
            return in;
        };
        return endOf(2 * z) - endOf(z / 2);
    };
    for (const double z : {1.0, 7.0, 90.0, 1234.0}) {
        EXPECT_NEAR(width(DepthFormat::Float, z), z * z * 0x1p-24 / n, 0.02 * z * z * 0x1p-24 / n) << z;
        EXPECT_GT(width(DepthFormat::Reversed, z) / z, 0.98 * 0x1p-24) << z;
        EXPECT_LT(width(DepthFormat::Reversed, z) / z, 1.02 * 0x1p-23) << z;
    }
}

// A plane that faces the camera at z = 47: what a frame stores is at most half a bin off, and in 24 bits 256 times less
// than in 16.
TEST(Laws, AFramesDepthsAreWithinHalfABin) {
    Scene scene = sphere(Shading::Flat, 4);
    scene.settings.cull = CullMode::None;
    scene.camera.eye = {0, 0, 47}, scene.camera.up = {0, 1, 0};
    scene.camera.near = 0.1, scene.camera.far = 1000;
    scene.objects = {shape(ShapeKind::Plane, 1, {Vec3d(60), {2, 3, 0}, {}})};
    for (const auto& [format, bits] : {std::pair{DepthFormat::Fixed16, 16}, {DepthFormat::Fixed24, 24}}) {
        scene.settings.depthFormat = format;
        const FramePtr frame = test::frameOf(scene, errorsNeed());
        const Picture picture = pictureOf(*frame);
        double farthest = 0;
        for (const double z : picture.zView.pixels) farthest = std::max(farthest, std::isfinite(z) ? z : 0);
        const double bin = farthest * farthest * (1000 - 0.1) / (1000 * 0.1 * (std::exp2(bits) - 1));
        for (const ErrorRow& row : compare(*frame, picture, {})) {
            if (row.buffer != "depth" || row.measure != "largest") continue;
            const double largest = row.value[index(ErrorKind::Storage)].value();
            EXPECT_LE(largest, 0.52 * bin) << bits;
            EXPECT_GT(largest, 0.4 * bin) << bits;
        }
    }
}

// The plane under a sphere, seen from below, orthographic: nothing hides it, and the sphere's own shadow is not in view.
Scene shadowOnPlane(int shadowSize) {
    Scene scene = sphere(Shading::Flat, 4);
    scene.settings.width = scene.settings.height = 256;
    scene.settings.cull = CullMode::None;
    scene.settings.shadowSize = shadowSize;
    scene.camera.projection = ProjectionKind::Orthographic;
    scene.camera.eye = {0, 0, -20}, scene.camera.up = {0, 1, 0}, scene.camera.height = 4;
    scene.objects = {shape(ShapeKind::Plane, 1, {Vec3d(6), {}, {}}),
                     shape(ShapeKind::Sphere, 96, {Vec3d(1), {}, {0.1, 0.2, 1.5}})};
    scene.lights[0].position = {0.3, 0.2, 1};
    return scene;
}

// A texel decides for up to half its width on either side of the shadow's edge.
TEST(Laws, TheEdgeOfAShadowIsOffByATexel) {
    const double coarse = error(shadowOnPlane(32), "shadow.0", "misclassified");
    const double fine = error(shadowOnPlane(256), "shadow.0", "misclassified");
    EXPECT_NEAR(std::log2(coarse / fine) / 3, 1, 0.15);
    // Of an edge of 2 π or so half a texel's width on 16 square units: 6.3 · 7 / 32 / 4 / 16 = 2 % in the mean.
    EXPECT_LT(coarse, 0.04);
}

// Beyond a texel from its edge nothing is wrong. Texels of at most 8.5 / 1022 units, the diagonal of
// the plane, are narrower than pixels of 4 / 256: every
// pixel with another S has one beside it that lies across the edge.
TEST(Laws, AwayFromItsEdgeAShadowIsRight) {
    const Scene scene = shadowOnPlane(1024);
    const Picture rays = rayCast(scene, RaySurfaces::Exact, 0)->picture;
    const Picture ours = pictureOf(*test::frameOf(scene, picturesNeed()));
    const Buffer2D<double>& shadow = rays.shadow[0];
    int wrong = 0;
    for (int y = 1; y < 255; ++y)
        for (int x = 1; x < 255; ++x) {
            if (ours.shadow[0].at({x, y}) == shadow.at({x, y})) continue;
            ++wrong;
            bool isBesideEdge = false;
            for (int j = y - 1; j <= y + 1; ++j)
                for (int i = x - 1; i <= x + 1; ++i)
                    isBesideEdge = isBesideEdge || shadow.at({i, j}) != shadow.at({x, y});
            ASSERT_TRUE(isBesideEdge) << x << ", " << y;
        }
    EXPECT_LT(wrong, 200);  // of an edge of 400 pixels or so
    EXPECT_GT(std::ranges::count(shadow.pixels, 0.0), 5000);
}

// N samples across a light: a straight edge's share of it is off by at most 1 / (2 N).
TEST(Laws, APenumbraIsOffByHalfASample) {
    for (const int samples : {4, 8, 16}) {
        Scene scene = shadowOnPlane(512);
        scene.objects = {shape(ShapeKind::Plane, 1, {Vec3d(16), {}, {}}),
                         shape(ShapeKind::Plane, 1, {Vec3d(16), {}, {-8, 0, 1}})};
        scene.camera.height = 2;
        scene.settings.width = scene.settings.height = 128;
        scene.lights[0] = {LightKind::Area, {0, 0, 4}, 1, Vec3d(1), true};
        scene.lights[0].area = {{0, 0, -1}, 2, 0, samples};
        const double largest = error(scene, "shadow.0", "largest");
        // And by where its own shadow buffer has the edge: a texel of 2 · 4 / 512 on the floor, at 3/2 a unit.
        EXPECT_LE(largest, 0.5 / samples + 1.5 * 8 / 512) << samples;
        EXPECT_GT(largest, 0.4 / samples) << samples;
    }
}

// The part of a pixel that an edge leaves is off by N^(-3/4) with N samples on a grid: of n x n samples by n^(-3/2).
TEST(Laws, AnAntialiasedEdgeIsOffByThePowerOfThreeQuarters) {
    Scene scene = sphere(Shading::Phong, 64);
    scene.settings.width = scene.settings.height = 64;
    double first = 0, last = 0;
    for (const int samples : {1, 2, 4, 8}) {
        scene.settings.antialiasing = samples;
        const double now = error(scene, "antialiased", "RMSE");
        if (samples == 1) first = now;
        if (samples > 1) {
            EXPECT_LT(now, last) << samples;
        }
        last = now;
    }
    EXPECT_NEAR(std::log2(first / last) / 3, 1.5, 0.25);
}

}  // namespace
}  // namespace pipeline
