#include "pipeline/plan/shadow_reach.h"

#include <algorithm>
#include <vector>

#include "pipeline/core/numerics.h"
#include "pipeline/stages/shadow_buffer.h"

namespace pipeline {
namespace {

// Every pair is compared: beyond this many objects deciding could cost more than it saves.
constexpr std::size_t kMostObjects = 64;

struct Box {
    glm::dvec2 low, high;
};

// Around an object as the light sees it; around the corners of its box, which is never too small.
Box boxFromLight(const View& axes, const Object& object) {
    const ObjectMatrix matrix = makeObjectMatrix(object.transform);
    const Vec3d sides[2]{object.mesh->facts.low, object.mesh->facts.high};
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    Box box{glm::dvec2(kInfinity), glm::dvec2(-kInfinity)};
    for (unsigned corner = 0; corner < 8; ++corner) {
        const Vec3d p = toWorld(matrix, {sides[corner & 1].x, sides[corner >> 1 & 1].y, sides[corner >> 2].z});
        const glm::dvec2 seen{glm::dot(axes.right, p), glm::dot(axes.up, p)};
        box.low = glm::min(box.low, seen), box.high = glm::max(box.high, seen);
    }
    return box;
}

bool allConvex(const Scene& scene) {
    return std::ranges::all_of(scene.objects, [](const Object& object) { return object.mesh->facts.convex; });
}

// Which polygons face a light is known beforehand of normals in their stable form alone, and where none is turned round
// for an eye within the body.
bool trustsNormals(const Settings& settings) {
    return !lightsBacks(settings) && settings.forms.polygonNormal == PolygonNormalForm::Newell &&
           settings.forms.unit != UnitForm::Direct;
}

}  // namespace

std::string whyNoSelfShadow(const Scene& scene) {
    if (scene.objects.size() != 1 || !allConvex(scene) || scene.settings.shadowBias != ShadowBias::Automatic ||
        !trustsNormals(scene.settings))
        return {};
    return "The only object is convex: it cannot shadow itself.";
}

std::string whyNoShadowBetween(const Scene& scene, const Light& light) {
    const Settings& settings = scene.settings;
    if (light.kind != LightKind::AtInfinity || settings.shadowBias != ShadowBias::Automatic ||
        scene.objects.size() < 2 || scene.objects.size() > kMostObjects || !allConvex(scene) ||
        !trustsNormals(settings))
        return {};
    View axes;
    axes.forward = -normalized(light.position);
    placeAxes(axes);
    std::vector<Box> boxes;
    for (const Object& object : scene.objects) boxes.push_back(boxFromLight(axes, object));
    Box all = boxes[0];
    for (const Box& box : boxes) all.low = glm::min(all.low, box.low), all.high = glm::max(all.high, box.high);

    // A point reads the texels around its own, and a texel holds what lies at its centre. The share
    // of the whole covers the rounding of a float run.
    const glm::dvec2 extent = all.high - all.low;
    const double texels = settings.shadowFilter + 2.0;
    const glm::dvec2 apart = extent * (texels / std::max(1, settings.shadowSize - 2) + 0x1p-16);
    for (std::size_t i = 0; i < boxes.size(); ++i)
        for (std::size_t j = i + 1; j < boxes.size(); ++j)
            if (!glm::any(glm::greaterThan(boxes[j].low - boxes[i].high, apart)) &&
                !glm::any(glm::greaterThan(boxes[i].low - boxes[j].high, apart)))
                return {};
    return "All objects are convex and, seen from the light, apart.";
}

}  // namespace pipeline
