#include "pipeline/scene/framing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "pipeline/core/angles.h"
#include "pipeline/core/text.h"
#include "pipeline/scene/alike_remarks.h"
#include "pipeline/scene/object_matrix.h"
#include "pipeline/scene/opacity.h"

namespace pipeline {
namespace {

struct Box {
    Vec3d low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};
    void add(const Vec3d& p) { low = glm::min(low, p), high = glm::max(high, p); }
    Vec3d middle() const { return 0.5 * (low + high); }
};

// Of all objects, before anything but what turns them upright moves them.
Box boxOf(const Scene& scene) {
    Box box;
    for (const Object& object : scene.objects)
        for (const Vec3d& end : {object.mesh->facts.low, object.mesh->facts.high})
            box.add(upright(object.transform.up, end));
    return box;
}

// With d at four radii away, a sphere's outline appears at d / sqrt(4² - 1) from the picture's centre; it is to fill four
// fifths of the picture's smaller side.
double fittingDistance(const Settings& settings) {
    return 0.8 * std::min(settings.width, settings.height) / 2 * std::sqrt(15.0);
}

// How much of the polygons' area, projected towards the eye, is of fronts: 0 to 1.
double frontShare(const Scene& scene, const Vec3d& eye) {
    double front = 0, all = 0;
    for (const Object& object : scene.objects) {
        if (isTransparent(object, scene.settings)) continue;
        const Mesh& mesh = *object.mesh;
        const ObjectMatrix matrix = makeObjectMatrix(object.transform);
        for (const Triangle& triangle : mesh.triangles) {
            const auto corner = [&](int k) { return toWorld(matrix, mesh.positions[triangle.vertices[k]]); };
            const Vec3d a = corner(0);
            const double side = glm::dot(glm::cross(corner(1) - a, corner(2) - a), eye - a) * (matrix.mirrors ? -1 : 1);
            front += std::max(side, 0.0);
            all += std::abs(side);
        }
    }
    return all > 0 ? front / all : 0;
}

struct Direction {
    double theta, phi;  // degrees
};

Vec3d eyeOf(const Direction& from, double rho) {
    const double sinPhi = sinDegrees(from.phi);
    return rho * Vec3d{sinPhi * cosDegrees(from.theta), sinPhi * sinDegrees(from.theta), cosDegrees(from.phi)};
}

Direction frontOf(const Scene& scene, double rho) {
    const double first = upOf(scene) == UpAxis::Y ? -45 : 45;
    const Direction usual{first, 60};
    const auto isClosed = [](const Object& object) { return object.mesh->facts.closed; };
    // As much of a closed mesh faces the eye as faces away from it.
    if (std::ranges::all_of(scene.objects, isClosed)) return usual;
    constexpr double kEnough = 0.25;
    double most = frontShare(scene, eyeOf(usual, rho));
    if (most >= kEnough) return usual;
    Direction best = usual;
    for (const Direction from : {Direction{first + 90, 60},
                                 {first - 90, 60},
                                 {first + 180, 60},
                                 {first, 120},
                                 {first + 90, 120},
                                 {first - 90, 120},
                                 {first + 180, 120}}) {
        const double share = frontShare(scene, eyeOf(from, rho));
        if (share > most) most = share, best = from;
    }
    return best;
}

struct Framing {
    Camera camera;
    Light light;
};

// Of objects whose middle is the world's origin.
Framing chooseFraming(const Scene& scene, const Box& box) {
    const double halfDiagonal = glm::length(box.high - box.middle());
    Framing framing;
    framing.camera.rho = 4 * (halfDiagonal > 0 ? halfDiagonal : 1);
    framing.camera.screenDistance = fittingDistance(scene.settings);
    const Direction from = frontOf(scene, framing.camera.rho);
    framing.camera.theta = from.theta, framing.camera.phi = from.phi;
    // Beside the eye, as in the example at θ = 45°: seen from there the two sides of a cube would look alike.
    const double s = sinDegrees(from.theta - 45), c = cosDegrees(from.theta - 45);
    const Vec3d beside{500, 200, from.phi < 90 ? 600 : -600};
    framing.light.position = {c * beside.x - s * beside.y, s * beside.x + c * beside.y, beside.z};
    return framing;
}

// Of a camera that was chosen.
void tellOfCamera(Scene& scene) {
    std::erase_if(scene.remarks, [](const Remark& remark) { return remark.about.starts_with("camera.phi="); });
    if (scene.camera.phi < 90) return;
    scene.remarks.push_back({"camera.phi=" + shortestText(scene.camera.phi),
                             "Most polygons face down: the camera looks from below. If they run clockwise in the file, "
                             "cull=none and camera.phi=60 show them from above."});
}

bool isMostlyAmbient(const Material& material) {
    const auto largest = [](const Vec3d& k) { return std::max({k.x, k.y, k.z}); };
    return largest(material.diffuse) < 0.5 * largest(material.ambient);
}

// A model that is chosen here refuses no file.
void clampExponents(Scene& scene) {
    const ModelFacts& model = modelFacts(scene.settings.model);
    AlikeRemarks clamped;
    for (std::size_t i = 0; model.mostExponent && i < scene.objects.size(); ++i) {
        Object& object = scene.objects[i];
        const double n =
            std::exchange(object.material.exponent, std::min(object.material.exponent, *model.mostExponent));
        if (n == object.material.exponent) continue;
        const std::string name = inQuotes(object.name);
        const std::string most = shortestText(*model.mostExponent);
        clamped.add("n", name,
                    {fmt::format("material.{}.n={}", i, most),
                     fmt::format("n of the material of {} is {} in the file; {} takes at most {}, which is set.", name,
                                 shortestText(n), model.name, most)});
    }
    clamped.moveTo(scene.remarks);
}

// Lecture 1's model stands, with its intensities, where it reads what makes the materials visible. It has neither
// emission nor k_a; the others show colours within [0, 1].
void chooseIllumination(Scene& scene) {
    const auto any = [&](auto holds) {
        return std::ranges::any_of(scene.objects, [&](const Object& o) { return holds(o.material); });
    };
    scene.lights[0].intensity = 100;
    scene.ambient.intensity = 50;
    const bool emits = any([](const Material& m) { return m.emission != Vec3d(0); });
    if (!emits && !any(isMostlyAmbient)) return;
    // The first of the table that reads it.
    const auto found = std::ranges::find_if(
        modelTable(), [&](const ModelFacts& model) { return emits ? model.found.emission : model.found.ownAmbient; });
    scene.settings.model = Model(found - modelTable().begin());
    scene.lights[0].intensity = 0.6;
    scene.ambient.intensity = 0.4;
    scene.remarks.push_back({"model=" + std::string(modelFacts(scene.settings.model).word),
                             emits ? "A material gives off light, which only OpenGL's illumination model reads: "
                                     "model=opengl is set."
                                   : "A material reflects ambient light (k_a) and less than half as much "
                                     "diffuse light (k_d). Phong's model reads k_d alone: model=blinn-phong "
                                     "is set."});
    clampExponents(scene);
}

}  // namespace

void frameModel(Scene& scene) {
    const Box box = boxOf(scene);
    for (Object& object : scene.objects) object.transform.translation = -box.middle();
    const Framing framing = chooseFraming(scene, box);
    scene.camera = framing.camera;
    scene.lights = {framing.light};
    tellOfCamera(scene);
    chooseIllumination(scene);
    scene.framed = true;
}

UpAxis upOf(const Scene& scene) { return scene.objects.empty() ? UpAxis::Z : scene.objects[0].transform.up; }

void setUp(Scene& scene, UpAxis up) {
    const Framing before = chooseFraming(scene, boxOf(scene));
    Box file;
    for (const Object& object : scene.objects) file.add(object.mesh->facts.low), file.add(object.mesh->facts.high);
    for (Object& object : scene.objects) {
        ObjectTransform& transform = object.transform;
        // Without a rounding where the translation is the one that frameModel has chosen.
        const Vec3d offset = transform.translation + makeObjectMatrix(transform).linear * file.middle();
        transform.up = up;
        transform.translation = offset - makeObjectMatrix(transform).linear * file.middle();
    }
    const Framing after = chooseFraming(scene, boxOf(scene));
    if (scene.camera == before.camera) scene.camera = after.camera, tellOfCamera(scene);
    if (scene.lights.size() == 1 && scene.lights[0].position == before.light.position)
        scene.lights[0].position = after.light.position;
}

void setSize(Scene& scene, glm::ivec2 size) {
    const bool fits = scene.framed && scene.camera.screenDistance == fittingDistance(scene.settings);
    scene.settings.width = size.x, scene.settings.height = size.y;
    if (fits) scene.camera.screenDistance = fittingDistance(scene.settings);
}

}  // namespace pipeline
