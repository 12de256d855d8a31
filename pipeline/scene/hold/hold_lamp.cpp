#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "pipeline/core/angles.h"
#include "pipeline/core/elementary.h"
#include "pipeline/core/numerics.h"
#include "pipeline/scene/hold/hold_solve.h"

namespace pipeline {

namespace {

constexpr double kFarthestLamp = 178;  // degrees from the line of sight

// The direction to a light at infinity along the view's axes: right, up, towards the eye. Unit.
Vec3d towardsInView(const Scene& scene, const View& view, const Hold& hold) {
    const Light& light = scene.lights[hold.index];
    const Vec3d L = normalized(light.position);
    if (light.gl.space == LightSpace::Eye) return L;
    return {glm::dot(L, view.right), glm::dot(L, view.up), -glm::dot(L, view.forward)};
}

std::optional<HoldPlace> lampPlace(const Scene& scene, const Hold& hold) {
    const View view = makeView(scene);
    const auto middle = projected(view, hold.point);
    if (!middle) return {};
    const Vec3d L = towardsInView(scene, view, hold);
    const double angle = acos(std::clamp(L.z, -1.0, 1.0)) * kDegrees, across = glm::length(glm::dvec2(L.x, L.y));
    const glm::dvec2 way = across > 0 ? glm::dvec2(L.x, -L.y) / across : glm::dvec2(1, 0);
    return HoldPlace{*middle + way * (radiusAround(scene, view, hold.point) * angle / 90), L.z < 0};
}
Assignments lampAt(const Scene& scene, const Hold& hold, glm::dvec2 to, bool coarse) {
    const View view = makeView(scene);
    const auto middle = projected(view, hold.point);
    if (!middle) return valuesOf(scene, hold);
    const glm::dvec2 off = to - *middle;
    const double distance = glm::length(off);
    double angle = std::min(kFarthestLamp, distance / radiusAround(scene, view, hold.point) * 90);
    if (coarse) angle = std::round(angle / 15) * 15;
    const glm::dvec2 way = distance > 0 ? off / distance : glm::dvec2(1, 0);
    const double s = sinDegrees(angle);
    Vec3d L{s * way.x, -s * way.y, cosDegrees(angle)};
    if (scene.lights[hold.index].gl.space != LightSpace::Eye) L = L.x * view.right + L.y * view.up - L.z * view.forward;
    const double length = glm::length(scene.lights[hold.index].position);
    const double step = powerBelow((length > 0 ? length : 1) / 1000);
    Assignments values;
    for (int i = 0; i < 3; ++i) values.emplace_back(hold.keys[std::size_t(i)], roundedTo(L[i] * length, step));
    return values;
}

Assignments lampDragged(const Scene& start, const Hold& hold, const Drag& drag) {
    return lampAt(start, hold, drag.target(), drag.isCoarse);
}
Assignments lampNudged(const Scene& scene, const Hold& hold, glm::ivec2 by, bool coarse) {
    const auto place = lampPlace(scene, hold);
    if (!place) return valuesOf(scene, hold);
    const double degree = radiusAround(scene, makeView(scene), hold.point) / 90;
    return lampAt(scene, hold, place->at + glm::dvec2(by) * (coarse ? 15.0 : 2.0) * degree, false);
}
std::string lampWords(const Scene& scene, const Hold& hold) {
    return fmt::format("x {}  y {}  z {}", valueText(scene, hold, 0), valueText(scene, hold, 1),
                       valueText(scene, hold, 2));
}

// A power of ten at or below a pixel's size where the lamp is.
double lampStep(const Scene& scene, const Hold& hold) {
    const View view = makeView(scene);
    const double depth = view.perspective ? std::abs(toView(view, scene.lights[hold.index].position).z) : 1;
    return powerBelow(std::max(depth / view.scale.y, std::numeric_limits<double>::min()));
}
// Of n keys, each with its unknown.
template <std::size_t n>
Assignments lampPut(const Scene& start, const Hold& hold, const Drag& drag) {
    const double reach = reachOf(start), step = lampStep(start, hold) * (drag.isCoarse ? 100 : 1);
    Assignments values = valuesOf(start, hold);
    std::array<double, n> now;
    for (std::size_t i = 0; i < n; ++i) now[i] = values[i].second;
    const auto found = solved<n>(start, hold, drag.target(), now, reach, [&](const std::array<double, n>& t) {
        Assignments tried;
        for (std::size_t i = 0; i < n; ++i) tried.emplace_back(hold.keys[i], t[i]);
        return tried;
    });
    for (std::size_t i = 0; found && i < n; ++i)
        values[i].second = std::clamp(roundedTo((*found)[i], step), -reach, reach);
    return values;
}
Assignments lampMoved(const Scene& scene, const Hold& hold, std::array<int, 2> by, bool coarse) {
    const double reach = reachOf(scene), unit = powerBelow(reach / 200), step = unit * (coarse ? 10 : 1);
    Assignments values = valuesOf(scene, hold);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i].second = std::clamp(roundedTo(values[i].second + by[i] * step, unit), -reach, reach);
    return values;
}
Assignments footNudged(const Scene& scene, const Hold& hold, glm::ivec2 by, bool coarse) {
    return lampMoved(scene, hold, {by.x, -by.y}, coarse);
}
Assignments topNudged(const Scene& scene, const Hold& hold, glm::ivec2 by, bool coarse) {
    return lampMoved(scene, hold, {-by.y}, coarse);
}

std::optional<HoldPlace> footPlace(const Scene& scene, const Hold& hold) {
    const Vec3d& at = scene.lights[hold.index].position;
    return placeInPicture(scene, {at.x, at.y, 0});
}
std::optional<HoldPlace> topPlace(const Scene& scene, const Hold& hold) {
    return placeInPicture(scene, scene.lights[hold.index].position);
}
std::string footWords(const Scene& scene, const Hold& hold) {
    return fmt::format("x {}  y {}", valueText(scene, hold, 0), valueText(scene, hold, 1));
}
std::string topWords(const Scene& scene, const Hold& hold) { return "z " + valueText(scene, hold, 0); }

}  // namespace

const HoldKindRow kLampAtInfinity{"lamp", lampPlace, lampDragged, lampNudged, lampWords};
const HoldKindRow kLampFoot{"foot", footPlace, lampPut<2>, footNudged, footWords};
const HoldKindRow kLampTop{"top", topPlace, lampPut<1>, topNudged, topWords};

}  // namespace pipeline
