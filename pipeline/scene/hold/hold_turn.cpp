#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "pipeline/core/angles.h"
#include "pipeline/core/elementary.h"
#include "pipeline/core/numerics.h"
#include "pipeline/core/text.h"
#include "pipeline/scene/hold/hold_solve.h"

// What turns or pushes: the eye around the scene, an object.

namespace pipeline {

namespace {

constexpr double kTurnOfEye = 180;  // degrees for a drag over the whole width

// θ, φ and the distance of the eye, degrees, around z.
Vec3d eyeAround(const Camera& camera) {
    if (camera.kind == CameraKind::Spherical) return {camera.theta, camera.phi, camera.rho};
    const Vec3d d = camera.eye - camera.target;
    const double length = glm::length(d);
    if (!(length > 0)) return {0, 90, 0};
    return {atan2(d.y, d.x) * kDegrees, acos(std::clamp(d.z / length, -1.0, 1.0)) * kDegrees, length};
}
double wrapped(double degrees) { return degrees - 360 * std::floor((degrees + 180) / 360); }
Assignments eyeAt(const Scene& scene, const Hold& hold, double theta, double phi) {
    theta = wrapped(theta), phi = std::clamp(phi, 1.0, 179.0);
    if (scene.camera.kind == CameraKind::Spherical) return {{hold.keys[0], theta}, {hold.keys[1], phi}};
    const double distance = eyeAround(scene.camera).z, step = powerBelow(distance / 1000);
    const Vec3d away{sinDegrees(phi) * cosDegrees(theta), sinDegrees(phi) * sinDegrees(theta), cosDegrees(phi)};
    Assignments values;
    for (int i = 0; i < 3; ++i)
        values.emplace_back(hold.keys[std::size_t(i)], roundedTo(scene.camera.target[i] + distance * away[i], step));
    return values;
}
Assignments eyeDragged(const Scene& start, const Hold& hold, const Drag& drag) {
    const double step = drag.isCoarse ? 15 : 1, rate = kTurnOfEye / start.settings.width;
    const Vec3d now = eyeAround(start.camera);
    const auto to = [&](double value) { return std::round(value / step) * step; };
    return eyeAt(start, hold, to(now.x - drag.moved().x * rate), to(now.y - drag.moved().y * rate));
}
Assignments eyeNudged(const Scene& scene, const Hold& hold, glm::ivec2 by, bool coarse) {
    const Vec3d now = eyeAround(scene.camera);
    const double step = coarse ? 15 : 2;
    return eyeAt(scene, hold, now.x + by.x * step, now.y + by.y * step);
}
std::optional<HoldPlace> eyePlace(const Scene&, const Hold&) { return HoldPlace{}; }
std::string eyeWords(const Scene& scene, const Hold&) {
    const Vec3d eye = eyeAround(scene.camera);
    return fmt::format("θ {:.0f}°  φ {:.0f}°", eye.x + 0.0, eye.y);
}

// Pixels that the front of an object moves by for a degree of its turn: across its middle.
glm::dvec2 motionOfTurn(const Scene& scene, const Hold& hold) {
    const View view = makeView(scene);
    const Vec3d towards = view.perspective ? normalized(view.eye - hold.point) : -view.forward;
    Vec3d way = glm::cross(hold.axis, towards);
    // Seen along its axis an object turns in the picture, and its right side moves upwards.
    if (!(glm::length(way) > 0.2)) return {0, -1 / (radiusAround(scene, view, hold.point, hold.index) / kDegrees)};
    way = normalized(way);
    const glm::dvec2 across{glm::dot(way, view.right), -glm::dot(way, view.up)};
    return across * (radiusAround(scene, view, hold.point, hold.index) / kDegrees);
}
Assignments turnedTo(const Hold& hold, double degrees, double step) {
    return {{hold.keys[0], wrapped(std::round(degrees / step) * step)}};
}
std::optional<HoldPlace> turnPlace(const Scene& scene, const Hold& hold) {
    auto place = placeInPicture(scene, hold.point);
    if (place) place->at.y += radiusAround(scene, makeView(scene), hold.point, hold.index);
    return place;
}
Assignments turnDragged(const Scene& start, const Hold& hold, const Drag& drag) {
    const glm::dvec2 rate = motionOfTurn(start, hold);
    return turnedTo(hold, valueOf(start, hold.keys[0]) + glm::dot(drag.moved(), rate) / glm::dot(rate, rate),
                    drag.isCoarse ? 10 : 1);
}
Assignments turnNudged(const Scene& scene, const Hold& hold, glm::ivec2 by, bool coarse) {
    return turnedTo(hold, valueOf(scene, hold.keys[0]) + onward(by) * (coarse ? 10 : 1), 1);
}
std::string turnWords(const Scene& scene, const Hold& hold) { return valueText(scene, hold, 0) + "°"; }

double alongOf(const Scene& scene, const Hold& hold) {
    return glm::dot(scene.objects[hold.index].transform.translation - hold.point, hold.axis);
}
double stepAlong(const Hold& hold) { return powerBelow((hold.high - hold.low) / 40); }
// step 0: to all digits.
Assignments alongAt(const Hold& hold, double t, double step) {
    if (step > 0) t = std::clamp(roundedTo(t, step), hold.low, hold.high);
    const Vec3d at = hold.point + t * hold.axis;
    Assignments values;
    for (int i = 0; i < 3; ++i)
        values.emplace_back(hold.keys[std::size_t(i)], step > 0 ? roundedTo(at[i], step / 1000) : at[i]);
    return values;
}
std::optional<HoldPlace> alongPlace(const Scene& scene, const Hold& hold) {
    return placeInPicture(scene, middleOf(scene, hold.index));
}
Assignments alongDragged(const Scene& start, const Hold& hold, const Drag& drag) {
    const double step = stepAlong(hold) * (drag.isCoarse ? 10 : 1), range = hold.high - hold.low;
    const auto t = solved<1>(start, hold, drag.target(), {alongOf(start, hold)}, range,
                             [&](const auto& at) { return alongAt(hold, at[0], 0); });
    // Along the line of sight nothing moves sideways: up is farther away.
    const double away = glm::dot(hold.axis, makeView(start).forward) < 0 ? -1 : 1;
    const double pushed = alongOf(start, hold) + away * -drag.moved().y / start.settings.height * range;
    return alongAt(hold, t ? (*t)[0] : pushed, step);
}
Assignments alongNudged(const Scene& scene, const Hold& hold, glm::ivec2 by, bool coarse) {
    const double step = stepAlong(hold);
    return alongAt(hold, alongOf(scene, hold) + onward(by) * step * (coarse ? 10 : 1), step);
}
std::string alongWords(const Scene& scene, const Hold& hold) {
    return fmt::format("{} {}", hold.symbol.empty() ? hold.name : hold.symbol,
                       shortestText(roundedTo(alongOf(scene, hold), stepAlong(hold))));
}

}  // namespace

const HoldKindRow kEye{"eye", eyePlace, eyeDragged, eyeNudged, eyeWords};
const HoldKindRow kTurn{"turn", turnPlace, turnDragged, turnNudged, turnWords, true};
const HoldKindRow kAlong{"along", alongPlace, alongDragged, alongNudged, alongWords, true, true};

}  // namespace pipeline
