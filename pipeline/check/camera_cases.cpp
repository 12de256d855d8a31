#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "pipeline/check/case.h"
#include "pipeline/check/scenes.h"
#include "pipeline/core/angles.h"
#include "pipeline/plan/scene_remarks.h"
#include "pipeline/scene/settings_table.h"
#include "pipeline/stages/transform.h"

// Transforms that lose a dimension, and cameras in places where a basis by cross products has none.
namespace pipeline::check {
namespace {

constexpr double kEps = 0x1p-52;

// How far three axes are from orthonormal, in rounding units.
double skewness(Vec3d a, Vec3d b, Vec3d c) {
    const Long3 axes[3]{Long3(a), Long3(b), Long3(c)};
    Long worst = 0;
    for (int i = 0; i < 3; ++i)
        for (int k = i; k < 3; ++k) worst = std::max(worst, std::abs(glm::dot(axes[i], axes[k]) - Long(i == k)));
    return double(worst / Long(kEps));
}

Scene flattened() {
    Scene scene = frontScene(6, {boxMesh(-1, 1)});
    scene.objects[0].transform.scale = {1, 1, 0};
    scene.objects[0].transform.rotation = {0, 30, 0};
    return scene;
}
Finding runFlattened(Trial& trial) {
    ObjectTransform transform;
    transform.scale = {1, 1, 0};
    const glm::mat3 inverse = glm::inverse(glm::mat3(glm::dmat3(1, 0, 0, 0, 1, 0, 0, 0, 0)));
    double naive = 0;
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r) naive += !std::isfinite(inverse[c][r]);
    // Of diag(1, 1, 0) the cofactors are diag(0, 0, 1), at some length.
    const glm::dmat3 ours = normalMatrix(makeObjectMatrix(transform));
    double worst = 0;
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r) worst = std::max(worst, std::abs(ours[c][r] / ours[2][2] - (c == 2 && r == 2)));
    trial.frame(flattened());
    return {naive > 0 ? std::nan("") : 0, worst, fmt::format("{:.0f} entries not finite", naive), ""};
}

Scene vanished() {
    Scene scene = frontScene(6, {boxMesh(-1, 1), boxMesh(-1, 1), boxMesh(-1, 1)});
    scene.objects[0].transform.scale = Vec3d(0);
    scene.objects[1].transform.scale = {1, 0, 0};
    scene.objects[2].transform.scale = {0, 0, 2};
    scene.objects[2].transform.rotation = {20, 30, 40};
    scene.settings.shading = Shading::Gouraud;
    return scene;
}
Finding runVanished(Trial& trial) {
    const glm::vec3 none(0);
    return {double((none / std::sqrt(glm::dot(none, none))).x), double(drawnPixels(trial.frame(vanished())))};
}

Scene mirrored() {
    Random random(33);
    std::vector<Corners> triangles;
    for (int i = 0; i < 40; ++i) {
        const Vec3d middle = random.inCube(1.2);
        triangles.push_back({middle + random.inCube(0.6), middle + random.inCube(0.6), middle + random.inCube(0.6)});
    }
    Scene scene = frontScene(6, {trianglesOf(triangles)});
    scene.objects[0].transform.scale = {-1, 1, 1};
    scene.lights[0].position = {-1, 2, 3};
    scene.settings.cull = CullMode::Back;
    return scene;
}
// Pixels of `a` that are not those of `b` seen in a mirror.
double notMirrored(const FramePtr& a, const FramePtr& b) {
    const AnyBuffer x = *a->buffer({BufferId::Color}), y = *b->buffer({BufferId::Color});
    double count = 0;
    for (std::size_t row = 0; row < x.rows(); ++row)
        for (std::size_t column = 0; column < x.columns(); ++column)
            for (int c = 0; c < 3; ++c)
                if (x.value(column, row, c) != y.value(x.columns() - 1 - column, row, c)) {
                    ++count;
                    break;
                }
    return count;
}
Finding runMirrored(Trial& trial) {
    const Scene scene = mirrored();
    Scene plain = scene, turned = scene;
    plain.objects[0].transform.scale = Vec3d(1);
    plain.lights[0].position.x *= -1;
    // What a stage gets that does not turn the windings of a mirrored object round.
    Polygons reversed;
    const Mesh& mesh = *scene.objects[0].mesh;
    for (std::size_t p = 0; p < mesh.polygonCount(); ++p)
        reversed.emplace_back(mesh.polygon(p).rbegin(), mesh.polygon(p).rend());
    turned.objects[0].mesh = meshOf(mesh.positions, reversed);
    const FramePtr expected = trial.frame(plain);
    return {notMirrored(trial.frame(turned), expected), notMirrored(trial.frame(scene), expected)};
}

// The normal of a plane in an object squeezed along z: n = (1, 0, 1)/√2 becomes (s, 0, 1) at some length.
double squeezedNaive(double s) { return double(degreesBetween({Long(s), 0, 1}, Long3(Vec3d(1, 0, s)))); }
double squeezedOurs(double s) {
    ObjectTransform transform;
    transform.scale = {1, 1, s};
    return double(degreesBetween({Long(s), 0, 1}, Long3(normalMatrix(makeObjectMatrix(transform)) * Vec3d(1, 0, 1))));
}
Finding runSqueezed(Trial&) { return {squeezedNaive(1e-6), squeezedOurs(1e-6)}; }

// Of lecture 1's camera: right = (−sin θ, cos θ, 0), up = (−cos φ cos θ, −cos φ sin θ, sin φ).
struct Axes {
    Long3 right, up, away;
};
Axes closedForm(double theta, double phi) {
    const Long st = std::sin(radians(theta)), ct = std::cos(radians(theta));
    const Long sp = std::sin(radians(phi)), cp = std::cos(radians(phi));
    return {{-st, ct, 0}, {-cp * ct, -cp * st, sp}, {sp * ct, sp * st, cp}};
}
Scene fromAbove(double theta, double phi) {
    Scene scene = litScene({boxMesh(-1, 1)});
    scene.camera.kind = CameraKind::Spherical;
    scene.camera.rho = 6, scene.camera.theta = theta, scene.camera.phi = phi;
    scene.camera.screenDistance = 100;
    return scene;
}
Scene atThePole() { return fromAbove(30, 0); }
// lookAt in float, from the same place but around a target that is not the origin.
double lookAtError(double phi) {
    const Axes exact = closedForm(30, phi);
    const Vec3d target(1000, 2000, 500);
    const glm::vec3 eye(target + 1000.0 * Vec3d(exact.away));
    const glm::vec3 forward = glm::normalize(glm::vec3(target) - eye);
    const glm::vec3 right = glm::normalize(glm::cross(forward, glm::vec3(0, 0, 1)));
    return double(degreesBetween(Long3(right), exact.right));
}
double basisError(double phi) {
    double worst = 0;
    for (double theta : {-180.0, -30.0, 0.0, 30.0, 45.0, 77.7, 90.0, 359.0}) {
        const View view = makeView(fromAbove(theta, phi));
        const Axes exact = closedForm(theta, phi);
        worst = std::max({worst, double(degreesBetween(Long3(view.right), exact.right)),
                          double(degreesBetween(Long3(view.up), exact.up)),
                          double(degreesBetween(-Long3(view.forward), exact.away))});
    }
    return worst;
}
Finding runPole(Trial& trial) {
    double worst = 0;
    for (double phi : {0.0, 1e-12, 1e-6, 1e-3, 1.0, 90.0, 179.999, 180.0}) {
        worst = std::max(worst, basisError(phi));
        const View view = makeView(fromAbove(30, phi));
        trial.demand(skewness(view.right, view.up, view.forward) <= 4, "the axes are not orthonormal");
    }
    trial.frame(atThePole());
    trial.frame(fromAbove(30, 180));
    return {lookAtError(0), worst};
}

Finding runRightAngles(Trial&) {
    double naive = 0, ours = 0;
    static constexpr double kSine[]{0, 1, 0, -1};
    for (int quarter = -8; quarter <= 8; ++quarter) {
        const double sine = kSine[(quarter + 8) % 4], cosine = kSine[(quarter + 9) % 4];
        const float angle = float(quarter) * (std::numbers::pi_v<float> / 2);
        naive = std::max({naive, std::abs(double(std::sin(angle)) - sine), std::abs(double(std::cos(angle)) - cosine)});
        ours = std::max(
            {ours, std::abs(sinDegrees(90.0 * quarter) - sine), std::abs(cosDegrees(90.0 * quarter) - cosine)});
    }
    return {naive, ours};
}

Scene inItsTarget() {
    Scene scene = fromAbove(30, 60);
    scene.camera.rho = 0;
    return scene;
}
Finding runInItsTarget(Trial& trial) {
    const Scene scene = inItsTarget();
    const View view = makeView(scene);
    trial.demand(view.eye == Vec3d(0), "the eye is not in the origin");
    trial.demand(!sceneRemarks(scene).empty(), "nothing is said about it");
    trial.frame(scene);
    const glm::vec3 none(0);
    return {double(glm::normalize(none).x), skewness(view.right, view.up, view.forward)};
}

Finding runWildAngles(Trial& trial) {
    double differ = 0, naive = 0;
    Random random(10);
    for (int i = 0; i < 1000; ++i) {
        const double theta = random.between(-1e6, 1e6), phi = random.between(-1e6, 1e6);
        // fmod is exact: the rest is the same angle.
        const View wild = makeView(fromAbove(theta, phi));
        const View tame = makeView(fromAbove(std::fmod(theta, 360), std::fmod(phi, 360)));
        differ += wild.right != tame.right || wild.up != tame.up || wild.forward != tame.forward;
        const float turned = std::sin(float(theta) * (std::numbers::pi_v<float> / 180));
        naive =
            std::max(naive, std::abs(double(turned) - double(std::sin(radians(std::fmod(Long(theta), Long(360)))))));
    }
    Scene refused = fromAbove(1e9, 60);
    trial.demand(!checkScene(refused).empty(), "θ of 10⁹ degrees is not refused");
    refused = fromAbove(30, 60), refused.camera.rho = -1;
    trial.demand(!checkScene(refused).empty(), "ρ below 0 is not refused");
    return {naive, differ, fmt::format("sine {:.1g} off", naive), ""};
}

Scene upAlongView() {
    Scene scene = frontScene(6, {boxMesh(-1, 1)});
    scene.camera.up = {0, 0, 1};
    return scene;
}
Finding runUpAlongView(Trial& trial) {
    double worst = 0;
    for (const Vec3d up : {Vec3d(0, 0, 1), Vec3d(0, 0, -3), Vec3d(0)}) {
        Scene scene = upAlongView();
        scene.camera.up = up;
        const View view = makeView(scene);
        worst = std::max(worst, skewness(view.right, view.up, view.forward));
        trial.demand(!sceneRemarks(scene).empty(), "nothing is said about it");
        trial.frame(scene);
    }
    const glm::vec3 right = glm::cross(glm::vec3(0, 0, -1), glm::vec3(0, 0, 1));
    return {double(glm::normalize(right).x), worst};
}

Finding runEuler(Trial&) {
    Random random(16);
    double naive = 0, ours = 0;
    for (int i = 0; i < 1000; ++i) {
        ObjectTransform transform;
        transform.rotation = {random.between(-180, 180), 90, random.between(-180, 180)};
        const glm::dmat3 m = makeObjectMatrix(transform).linear;
        ours = std::max(ours, skewness(m[0], m[1], m[2]));
        const glm::vec3 angle = glm::vec3(transform.rotation) * (std::numbers::pi_v<float> / 180);
        const glm::vec3 s = glm::sin(angle), c = glm::cos(angle);
        const glm::mat3 x(1, 0, 0, 0, c.x, s.x, 0, -s.x, c.x), y(c.y, 0, -s.y, 0, 1, 0, s.y, 0, c.y),
            z(c.z, s.z, 0, -s.z, c.z, 0, 0, 0, 1);
        const glm::mat3 f = z * y * x;
        naive = std::max(naive, skewness(Vec3d(f[0]), Vec3d(f[1]), Vec3d(f[2])));
    }
    return {naive, ours};
}

}  // namespace

std::span<const Case> cameraCases() {
    static const Case cases[]{
        {.id = "T1",
         .group = Group::Camera,
         .title = "Scale (1, 1, 0)",
         .input = "a box made flat",
         .naive = "normals by the inverse transpose",
         .stable = "normals by the matrix of cofactors",
         .measure = "largest error of an entry",
         .reference = "diag(0, 0, 1), closed form",
         .bound = 0,
         .run = runFlattened,
         .scene = flattened},
        {.id = "T2",
         .group = Group::Camera,
         .title = "Scale 0 along two or three axes",
         .input = "three boxes",
         .naive = "normal divided by its length",
         .stable = "no area: nothing is drawn",
         .measure = "drawn pixels",
         .unit = "pixels",
         .reference = "area 0",
         .bound = 0,
         .outcome = Outcome::Empty,
         .run = runVanished,
         .scene = vanished},
        {.id = "T3",
         .group = Group::Camera,
         .title = "Mirror (−1, 1, 1)",
         .input = "40 triangles, back faces culled",
         .naive = "windings as the mesh has them",
         .stable = "the sign of the determinant turns windings and normals",
         .measure = "pixels that differ",
         .unit = "pixels",
         .reference = "the mirrored picture",
         .bound = 0,
         .run = runMirrored,
         .scene = mirrored},
        {.id = "T4",
         .group = Group::Camera,
         .title = "Normal under scale (1, 1, 10⁻⁶)",
         .input = "n = (1, 0, 1)/√2",
         .naive = "M n",
         .stable = "cof(M) n",
         .measure = "angle",
         .unit = "°",
         .reference = "(10⁻⁶, 0, 1), closed form",
         .bound = 1e-9,
         .run = runSqueezed,
         .knob = {.label = "scale along z", .low = 1e-6, .high = 1, .naive = squeezedNaive, .ours = squeezedOurs}},
        {.id = "T7",
         .group = Group::Camera,
         .title = "Camera at φ = 0 and 180",
         .input = "8 values of φ and of θ",
         .naive = "lookAt: two cross products, in float",
         .stable = "the axes from sines and cosines",
         .measure = "largest angle of an axis",
         .unit = "°",
         // Each entry is a product of two sines within 1.5 units: 4 units of 2^-52 in radians.
         .reference = "long double sines and cosines",
         .bound = 5.1e-14,
         .run = runPole,
         .scene = atThePole,
         .naiveWith = "numerics.camera_basis=cross-product",
         .knob = {.label = "φ from +z, degrees",
                  .setting = "camera.phi",
                  .low = 1e-6,
                  .high = 90,
                  .naive = lookAtError,
                  .ours = basisError}},
        {.id = "T8",
         .group = Group::Camera,
         .title = "Sine and cosine of right angles",
         .input = "−720° to 720°",
         .naive = "radians in float",
         .stable = "reduced in degrees, where 90 is exact",
         .measure = "largest error",
         .reference = "0, 1 and −1",
         .bound = 0,
         .run = runRightAngles},
        {.id = "T9",
         .group = Group::Camera,
         .title = "Camera in its target",
         .input = "ρ = 0",
         .naive = "(target − eye), divided by its length",
         .stable = "the axes from θ and φ, without ρ",
         .measure = "distance from orthonormal",
         .unit = "eps",
         .reference = "orthonormal axes",
         .bound = 4,
         .run = runInItsTarget,
         .scene = inItsTarget},
        {.id = "T10",
         .group = Group::Camera,
         .title = "Angles far beyond a turn",
         .input = "θ, φ up to ±10⁶°; 10⁹°; ρ < 0",
         .naive = "float radians of a large angle",
         .stable = "fmod in degrees, exact; more is refused",
         .measure = "views that differ",
         .reference = "the angle within a turn, bit for bit",
         .bound = 0,
         .run = runWildAngles},
        {.id = "T12",
         .group = Group::Camera,
         .title = "Up along the viewing direction",
         .input = "up = (0, 0, 1), (0, 0, −3), (0, 0, 0)",
         .naive = "forward × up, divided by its length",
         .stable = "the least aligned axis takes its place, with a remark",
         .measure = "distance from orthonormal",
         .unit = "eps",
         .reference = "orthonormal axes",
         .bound = 4,
         .run = runUpAlongView,
         .scene = upAlongView},
        {.id = "T16",
         .group = Group::Camera,
         .title = "Rotation by 90° about y",
         .input = "1000 angles about x and z",
         .naive = "sines of float radians",
         .stable = "sines in degrees; x and z then turn about one axis",
         .measure = "distance from orthonormal",
         .unit = "eps",
         .reference = "orthonormal axes",
         .bound = 8,
         .run = runEuler},
    };
    return cases;
}

}  // namespace pipeline::check
