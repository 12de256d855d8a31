#include "pipeline/inspect/shadow_events.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "pipeline/core/number.h"
#include "pipeline/inspect/pixel_report.h"
#include "pipeline/scene/area_light.h"
#include "pipeline/stages/texel_test.h"

namespace pipeline {
namespace {

// Where a triangle's surface is at a pixel that it covers, world space.
template <class Real>
Vec3<Real> worldAt(const FrameData<Real>& data, std::uint32_t triangle, glm::ivec2 pixel) {
    const TransformOutput<Real>& in = *data.transform;
    const auto& v = in.topology->triangles[triangle].vertices;
    Vec3<Real> position(0);
    setUpTriangle<Real>(in.view, {in.viewSpace(v[0]), in.viewSpace(v[1]), in.viewSpace(v[2])}, triangle,
                        [&](const RasterTriangle<Real>& piece) {
                            forEachCovered(piece.snapped, {pixel, pixel + 1}, [&](glm::ivec2, const auto& e) {
                                const Fragment<Real> fragment = interpolate(piece, pixel, e, in.view.perspective);
                                position = interpolated(in.world, v, fragment.barycentric);
                            });
                        });
    return position;
}

double numberIn(const std::string& text) { return readNumber(text).value_or(0); }

// "z' 120.3 > Z'[12][44] 120.3 + 0.02" in as many digits as the relation needs to be seen in them.
std::string comparisonOf(const ShadowDepths& depths) {
    const auto& [z, stored, bias, texel, shadowed] = depths;
    constexpr int kMostDigits = 17;  // what tells any two doubles apart
    for (int digits = 7;; ++digits) {
        const std::string left = depthText(z, digits), right = depthText(stored, digits);
        const std::string added = fmt::format("{:.{}g}", bias, digits == 7 ? 3 : digits);
        // Infinity stands where nothing is stored: everything is below it.
        const bool seen = !std::isfinite(stored) || (numberIn(left) > numberIn(right) + numberIn(added)) == shadowed;
        if (seen || digits == kMostDigits)
            return fmt::format("z' {} {} Z'[{}][{}] {} + {}", left, shadowed ? ">" : "≤", texel.x, texel.y, right,
                               added);
    }
}

template <class Real>
ShadowDepths compare(const LightView<Real>& light, const ShadowSettings& settings, Vec3<Real> position,
                     Vec3<Real> normal) {
    const ShadowTest<Real> test = shadowTest(light, settings, position, normal);
    const glm::ivec2 at = test.texel, size = light.depth[test.face]->size;
    const bool inside = at.x >= 0 && at.y >= 0 && at.x < size.x && at.y < size.y;
    TexelTest<Real> found{std::numeric_limits<Real>::infinity(), test.bias, false};
    if (inside) found = testTexel(light, settings, test, at, test.offset);
    return {double(test.z), double(found.stored), double(found.bias), at, found.shadowed};
}

template <class Real>
Vec3<Real> litNormal(const FrameData<Real>& data, std::uint32_t triangle) {
    const ShadingSources<Real> in = data.shadingSources();
    const Vec3<Real> front = in.planeNormal(triangle);
    return showsBack(data.keys.shading, in, in.transform.topology->polygonOf(triangle)) ? -front : front;
}

bool isMean(const ShadingInputs& inputs, std::size_t light) {
    return sampleGrid(inputs.lights[light]).count() > 1 || inputs.shadow.filter > 0;
}

template <class Real>
bool looksUp(const FrameData<Real>& data, std::size_t light) {
    return data.shadowBuffer && !data.shadowBuffer->lights[light].empty();
}

}  // namespace

template <class Real>
std::optional<ShadowDepths> shadowDepths(const FrameData<Real>& data, std::size_t light, std::uint32_t triangle,
                                         Vec3<Real> position) {
    const ShadingInputs& inputs = data.keys.shading;
    const Vec3<Real> normal = litNormal(data, triangle);
    if (isMean(inputs, light) || !looksUp(data, light) ||
        !(glm::dot(normal, towardsLight(inputs.lights[light], position)) > 0))
        return std::nullopt;
    return compare(data.shadowBuffer->lights[light][0], inputs.shadow, position, normal);
}

template <class Real>
std::optional<std::string> shadowComparison(const FrameData<Real>& data, std::size_t light, std::uint32_t triangle,
                                            Vec3<Real> position) {
    const auto depths = shadowDepths(data, light, triangle, position);
    return depths ? std::optional(comparisonOf(*depths)) : std::nullopt;
}

template <class Real>
std::vector<std::string> shadowEvents(const FrameData<Real>& data, std::uint32_t triangle, glm::ivec2 pixel) {
    const ShadingInputs& inputs = data.keys.shading;
    std::vector<std::string> events;
    if (!data.shading || inputs.outlines || !modelFacts(inputs.illumination.model).shadows) return events;
    // Without a shadow nobody has asked which way polygons face.
    if (std::ranges::none_of(inputs.lights, &Light::castsShadow)) return events;
    const ShadingSources<Real> sources = data.shadingSources();
    const Vec3<Real> position = worldAt(data, triangle, pixel);
    const Vec3<Real> normal = litNormal(data, triangle);
    for (std::size_t k = 0; k < inputs.lights.size(); ++k) {
        const Light& light = inputs.lights[k];
        if (!light.castsShadow) continue;
        const double factor = double(shadowAt(inputs, sources, k, triangle, position));
        std::string text;
        if (!(glm::dot(normal, towardsLight(light, position)) > 0)) {
            text = "the polygon faces away: only the ambient term";
        } else if (isMean(inputs, k)) {
            text = shadowPlace(light, factor);
        } else if (looksUp(data, k)) {
            const ShadowDepths found = compare(data.shadowBuffer->lights[k][0], inputs.shadow, position, normal);
            text = comparisonOf(found) + (found.shadowed ? ": in shadow, only the ambient term" : ": lit");
        } else if (!inputs.parts.of(Part::Light, k)) {
            text = kNotLookedFor;
        } else {
            text = "lit, without a shadow buffer";
        }
        events.push_back(fmt::format("light {}: {}", k, text));
    }
    return events;
}

std::string placeInLight(const std::vector<Evaluation>& evaluations, const Light& light, std::size_t k, double factor) {
    const auto isTurnedAway = [k](const Evaluation& e) { return !(e.lights[k].nDotL > 0); };
    return !evaluations.empty() && std::ranges::all_of(evaluations, isTurnedAway) ? "turned away"
                                                                                  : shadowPlace(light, factor);
}

#define SHADESCOPE_INSTANTIATE(Real)                                                                                   \
    template std::vector<std::string> shadowEvents(const FrameData<Real>&, std::uint32_t, glm::ivec2);                 \
    template std::optional<ShadowDepths> shadowDepths(const FrameData<Real>&, std::size_t, std::uint32_t, Vec3<Real>); \
    template std::optional<std::string> shadowComparison(const FrameData<Real>&, std::size_t, std::uint32_t,           \
                                                         Vec3<Real>);
SHADESCOPE_FOR_EVERY_REAL(SHADESCOPE_INSTANTIATE)
#undef SHADESCOPE_INSTANTIATE

}  // namespace pipeline
