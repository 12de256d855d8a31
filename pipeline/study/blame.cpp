#include "pipeline/study/blame.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "pipeline/scene/mesh/topology.h"
#include "pipeline/study/errors.h"
#include "pipeline/study/ray_light.h"

namespace pipeline {
namespace {

// What goes into the intensity of a pixel.
struct Ingredients {
    int object = -1;
    Vec3d position{0.0}, normal{0.0};
    std::vector<double> shadow;
};

void take(const Picture& picture, std::size_t i, Ingredients& out) {
    out.object = picture.object.pixels[i];
    out.position = picture.position.pixels[i];
    out.normal = picture.normal.pixels[i];
    out.shadow.clear();
    for (const Buffer2D<double>& shadow : picture.shadow) out.shadow.push_back(shadow.pixels[i]);
}

bool isComplete(const Picture& picture, std::size_t lights) {
    return !picture.object.empty() && !picture.position.empty() && !picture.normal.empty() &&
           !picture.intensity.empty() && picture.shadow.size() == lights &&
           std::ranges::none_of(picture.shadow, [](const Buffer2D<double>& shadow) { return shadow.empty(); });
}

class Sum {
public:
    void add(Vec3d difference) {
        const Vec3<long double> wide(difference);
        m_squares += glm::dot(wide, wide) / 3;
    }
    double rmse(double count, double white) const { return double(std::sqrt(m_squares / count) / white); }

private:
    long double m_squares = 0;  // wide enough for squares of any double
};

}  // namespace

std::vector<StageBlame> blame(const Scene& scene, const Picture& ours, const Picture& reference) {
    const bool twoSided = lightsBacks(scene.settings);
    const bool hasBacks =
        std::ranges::any_of(scene.objects, [](const Object& o) { return o.backMaterial.has_value(); });
    const std::size_t lights = scene.lights.size();
    const double white = whiteOf(scene);
    if (hasVertexColors(scene) || (twoSided && hasBacks) || !isComplete(ours, lights) ||
        !isComplete(reference, lights) || !(white > 0))
        return {};

    const auto lighting = rays::makeLighting<double>(scene);
    const auto shade = [&](int object, Vec3d position, Vec3d normal, const std::vector<double>& shadow) {
        return rays::shade<double>(lighting, lighting.material(object, false), {position, normal}, shadow);
    };
    Sum own, normals, shadowBuffer, zBuffer, shading;
    double count = 0;
    Ingredients a, b;
    for (std::size_t i = 0; i < ours.object.pixels.size(); ++i) {
        take(ours, i, a);
        take(reference, i, b);
        if (a.object < 0 && b.object < 0) continue;
        ++count;
        const Vec3d right = reference.intensity.pixels[i], error = ours.intensity.pixels[i] - right;
        own.add(error);
        if (a.object < 0) {  // only seeing it helps
            for (Sum* sum : {&normals, &shadowBuffer, &shading}) sum->add(error);
            continue;
        }
        const Vec3d formula = shade(a.object, a.position, a.normal, a.shadow),
                    delta = ours.intensity.pixels[i] - formula;
        shading.add(formula - right);
        if (a.object != b.object) {
            for (Sum* sum : {&normals, &shadowBuffer}) sum->add(error);
            continue;
        }
        normals.add(shade(a.object, a.position, b.normal, a.shadow) + delta - right);
        shadowBuffer.add(shade(a.object, a.position, a.normal, b.shadow) + delta - right);
        zBuffer.add(shade(a.object, b.position, a.normal, a.shadow) + delta - right);
    }
    if (count == 0) return {};
    const double whole = own.rmse(count, white);
    const auto left = [&](StageId stage, const Sum& sum) {
        const double error = sum.rmse(count, white);
        return StageBlame{stage, error, whole > 0 ? 1 - error / whole : 0};
    };
    return {left(StageId::Normals, normals), left(StageId::ShadowBuffer, shadowBuffer), left(StageId::ZBuffer, zBuffer),
            left(StageId::Shading, shading)};
}

}  // namespace pipeline
