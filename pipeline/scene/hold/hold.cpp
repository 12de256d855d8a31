#include "pipeline/scene/hold/hold.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "pipeline/core/angles.h"
#include "pipeline/core/elementary.h"
#include "pipeline/core/numerics.h"
#include "pipeline/core/text.h"
#include "pipeline/scene/hold/hold_kinds.h"
#include "pipeline/scene/object_matrix.h"
#include "pipeline/scene/view.h"

namespace pipeline {

namespace {

using Kind = Hold::Kind;
constexpr double kDegrees = 180 / std::numbers::pi;
constexpr double kFarthestLamp = 178;  // degrees from the line of sight
constexpr double kLeastMotion = 24;    // pixels over the whole range: less has no direction in the picture
constexpr double kTurnOfEye = 180;     // degrees for a drag over the whole width
constexpr double kLeastRadius = 24, kMostRadius = 0.45;  // of a lamp's 90°: pixels, and of the picture's height

double valueOf(const Scene& scene, const std::string& key) {
    const auto ref = findSetting(scene, key);
    return ref ? ref->get(scene) : 0;
}
Scene with(Scene scene, const Assignments& assignments) {
    for (const auto& [key, value] : assignments)
        if (const auto ref = findSetting(scene, key)) ref->set(scene, value);
    return scene;
}

// Of the objects' vertices, or of one object's.
template <class Visit>
void eachVertex(const Scene& scene, std::optional<std::size_t> only, Visit visit) {
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        if (only && *only != i) continue;
        const ObjectMatrix matrix = makeObjectMatrix(scene.objects[i].transform);
        for (const Vec3d& position : scene.objects[i].mesh->positions) visit(toWorld(matrix, position));
    }
}
Vec3d middleOf(const Scene& scene, std::size_t object) {
    Vec3d low(std::numeric_limits<double>::infinity()), high = -low;
    eachVertex(scene, object, [&](const Vec3d& p) { low = glm::min(low, p), high = glm::max(high, p); });
    return low.x <= high.x ? low + (high - low) / 2.0 : scene.objects[object].transform.translation;
}
// How far the vertices reach around a point, in the picture.
double radiusAround(const Scene& scene, const View& view, Vec3d point, std::optional<std::size_t> only = {}) {
    const auto middle = projected(view, point);
    double radius = kLeastRadius;
    if (middle)
        eachVertex(scene, only, [&](const Vec3d& p) {
            if (const auto at = projected(view, p)) radius = std::max(radius, glm::length(*at - *middle));
        });
    return std::min(radius, kMostRadius * view.size.y);
}

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
Assignments eyeDragged(const Scene& start, const Hold& hold, glm::dvec2 moved, bool coarse) {
    const double step = coarse ? 15 : 1, rate = kTurnOfEye / start.settings.width;
    const Vec3d now = eyeAround(start.camera);
    const auto to = [&](double value) { return std::round(value / step) * step; };
    return eyeAt(start, hold, to(now.x - moved.x * rate), to(now.y - moved.y * rate));
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

Assignments numberAt(const Scene& scene, const Hold& hold, double share, bool coarse) {
    share = std::clamp(share, 0.0, 1.0);
    const double value =
        isLogarithmic(hold) ? hold.low * pow(hold.high / hold.low, share) : hold.low + share * (hold.high - hold.low);
    return {{hold.keys[0], numberNear(scene, hold, value, coarse)}};
}

// The unknowns with which placeOf is nearest to `to`, by Newton's method. Nothing where the picture does not move with them.
template <std::size_t n, class AsValues>
std::optional<std::array<double, n>> solved(const Scene& scene, const Hold& hold, glm::dvec2 to,
                                            std::array<double, n> t, double reach, AsValues asValues) {
    const auto place = [&](const std::array<double, n>& at) -> std::optional<glm::dvec2> {
        const auto found = placeOf(with(scene, asValues(at)), hold);
        return found ? std::optional(found->at) : std::nullopt;
    };
    auto now = place(t);
    for (int round = 0; now && round < 8 && glm::length(to - *now) > 0.01; ++round) {
        std::array<glm::dvec2, n> moves;  // by one unit of each unknown
        for (std::size_t i = 0; i < n; ++i) {
            std::array<double, n> beside = t;
            beside[i] += reach * 1e-5;
            const auto at = place(beside);
            if (!at) return {};
            moves[i] = (*at - *now) / (reach * 1e-5);
        }
        const glm::dvec2 missing = to - *now;
        std::array<double, n> step;
        if constexpr (n == 1) {
            const double square = glm::dot(moves[0], moves[0]);
            if (std::sqrt(square) * reach < kLeastMotion) return {};
            step[0] = glm::dot(moves[0], missing) / square;
        } else {
            const double determinant = moves[0].x * moves[1].y - moves[1].x * moves[0].y;
            if (std::abs(determinant) * reach * reach < kLeastMotion * kLeastMotion) return {};
            step[0] = (missing.x * moves[1].y - moves[1].x * missing.y) / determinant;
            step[1] = (moves[0].x * missing.y - missing.x * moves[0].y) / determinant;
        }
        // A step that leads away, or behind the eye, is halved.
        double share = 1;
        std::optional<glm::dvec2> next;
        std::array<double, n> there = t;
        for (int tries = 0; tries < 12; ++tries, share /= 2) {
            for (std::size_t i = 0; i < n; ++i) there[i] = t[i] + share * step[i];
            next = place(there);
            if (next && glm::length(to - *next) < glm::length(missing)) break;
            next.reset();
        }
        if (!next) break;  // as near as it gets
        t = there, now = next;
    }
    return now ? std::optional(t) : std::nullopt;
}

double reachOf(const Scene& scene) {
    Vec3d low(-1.0), high(1.0);
    eachVertex(scene, {}, [&](const Vec3d& p) { low = glm::min(low, p), high = glm::max(high, p); });
    return 2 * glm::length(high - low);
}
// A power of ten at or below a pixel's size where the lamp is.
double lampStep(const Scene& scene, const Hold& hold) {
    const View view = makeView(scene);
    const double depth = view.perspective ? std::abs(toView(view, scene.lights[hold.index].position).z) : 1;
    return powerBelow(std::max(depth / view.scale.y, std::numeric_limits<double>::min()));
}
Assignments lampPut(const Scene& start, const Hold& hold, glm::dvec2 to, bool coarse) {
    const double reach = reachOf(start), step = lampStep(start, hold) * (coarse ? 100 : 1);
    const Assignments now = valuesOf(start, hold);
    Assignments values = now;
    const auto put = [&](const auto& found) {
        for (std::size_t i = 0; found && i < found->size(); ++i)
            values[i].second = std::clamp(roundedTo((*found)[i], step), -reach, reach);
    };
    if (hold.kind == Kind::LampTop)
        put(solved<1>(start, hold, to, {now[0].second}, reach, [&](const auto& t) {
            return Assignments{{hold.keys[0], t[0]}};
        }));
    else
        put(solved<2>(start, hold, to, {now[0].second, now[1].second}, reach, [&](const auto& t) {
            return Assignments{{hold.keys[0], t[0]}, {hold.keys[1], t[1]}};
        }));
    return values;
}
Assignments pushedTo(const Scene& start, const Hold& hold, glm::dvec2 from, glm::dvec2 to, bool coarse) {
    const double step = coarse ? 10 * stepAlong(hold) : stepAlong(hold), range = hold.high - hold.low;
    const auto place = placeOf(start, hold);
    const auto t = place ? solved<1>(start, hold, place->at + to - from, {alongOf(start, hold)}, range,
                                     [&](const auto& at) { return alongAt(hold, at[0], 0); })
                         : std::nullopt;
    // Along the line of sight nothing moves sideways: up is farther away.
    const double away = glm::dot(hold.axis, makeView(start).forward) < 0 ? -1 : 1;
    const double pushed = alongOf(start, hold) + away * (from.y - to.y) / start.settings.height * range;
    return alongAt(hold, t ? (*t)[0] : pushed, step);
}

std::string minusSigns(std::string text) {
    for (std::size_t at = 0; (at = text.find('-', at)) != text.npos; at += 3) text.replace(at, 1, "−");
    return text;
}

}  // namespace

std::optional<HoldPlace> placeOf(const Scene& scene, const Hold& hold) {
    const auto inPicture = [&](const Vec3d& world) -> std::optional<HoldPlace> {
        const auto at = projected(makeView(scene), world);
        return at ? std::optional(HoldPlace{*at}) : std::nullopt;
    };
    switch (hold.kind) {
        case Kind::LampAtInfinity: return lampPlace(scene, hold);
        case Kind::LampFoot: {
            const Vec3d& at = scene.lights[hold.index].position;
            return inPicture({at.x, at.y, 0});
        }
        case Kind::LampTop: return inPicture(scene.lights[hold.index].position);
        case Kind::Eye: return HoldPlace{};
        case Kind::Turn: {
            auto place = inPicture(hold.point);
            if (place) place->at.y += radiusAround(scene, makeView(scene), hold.point, hold.index);
            return place;
        }
        case Kind::Along: return inPicture(middleOf(scene, hold.index));
        case Kind::Vertex: return inPicture(vertexInWorld(scene, hold));
        case Kind::Rim: {
            const auto at = rimPlace(scene, hold);
            return at ? std::optional(HoldPlace{*at}) : std::nullopt;
        }
        case Kind::Number: return HoldPlace{glm::dvec2(shareOf(hold, valueOf(scene, hold.keys[0])))};
    }
    return {};
}

Assignments valuesOf(const Scene& scene, const Hold& hold) {
    Assignments values;
    for (const std::string& key : hold.keys) values.emplace_back(key, valueOf(scene, key));
    return values;
}

Assignments valuesAt(const Scene& start, const Hold& hold, glm::dvec2 from, glm::dvec2 to, bool coarse) {
    const auto place = placeOf(start, hold);
    const bool isFinite = std::isfinite(from.x) && std::isfinite(from.y) && std::isfinite(to.x) && std::isfinite(to.y);
    if (!place || !isFinite) return valuesOf(start, hold);
    const glm::dvec2 moved = to - from;
    switch (hold.kind) {
        case Kind::LampAtInfinity: return lampAt(start, hold, place->at + moved, coarse);
        case Kind::LampFoot:
        case Kind::LampTop: return lampPut(start, hold, place->at + moved, coarse);
        case Kind::Eye: return eyeDragged(start, hold, moved, coarse);
        case Kind::Turn: {
            const glm::dvec2 rate = motionOfTurn(start, hold);
            return turnedTo(hold, valueOf(start, hold.keys[0]) + glm::dot(moved, rate) / glm::dot(rate, rate),
                            coarse ? 10 : 1);
        }
        case Kind::Along: return pushedTo(start, hold, from, to, coarse);
        case Kind::Vertex: return vertexAt(start, hold, place->at + moved, coarse);
        case Kind::Rim: return rimAt(start, hold, place->at + moved, coarse);
        case Kind::Number: return numberAt(start, hold, place->at.x + moved.x, coarse);
    }
    return {};
}

Assignments nudged(const Scene& scene, const Hold& hold, glm::ivec2 by, bool coarse) {
    const double onward = by.x != 0 ? by.x : -by.y;
    switch (hold.kind) {
        case Kind::LampAtInfinity: {
            const auto place = placeOf(scene, hold);
            if (!place) return valuesOf(scene, hold);
            const double degree = radiusAround(scene, makeView(scene), hold.point) / 90;
            return lampAt(scene, hold, place->at + glm::dvec2(by) * (coarse ? 15.0 : 2.0) * degree, false);
        }
        case Kind::LampFoot:
        case Kind::LampTop: {
            const double reach = reachOf(scene), unit = powerBelow(reach / 200), step = unit * (coarse ? 10 : 1);
            Assignments values = valuesOf(scene, hold);
            for (auto& [key, value] : values) {
                const double way = hold.kind == Kind::LampTop || key.ends_with('y') ? -by.y : by.x;
                value = std::clamp(roundedTo(value + way * step, unit), -reach, reach);
            }
            return values;
        }
        case Kind::Eye: {
            const Vec3d now = eyeAround(scene.camera);
            const double step = coarse ? 15 : 2;
            return eyeAt(scene, hold, now.x + by.x * step, now.y + by.y * step);
        }
        case Kind::Turn: return turnedTo(hold, valueOf(scene, hold.keys[0]) + onward * (coarse ? 10 : 1), 1);
        case Kind::Along:
            return alongAt(hold, alongOf(scene, hold) + onward * stepAlong(hold) * (coarse ? 10 : 1), stepAlong(hold));
        case Kind::Vertex: {
            const auto place = placeOf(scene, hold);
            const double half = radiusAround(scene, makeView(scene), middleOf(scene, hold.index), hold.index);
            return place ? vertexAt(scene, hold, place->at + glm::dvec2(by) * (coarse ? 0.4 : 0.1) * half, false)
                         : valuesOf(scene, hold);
        }
        case Kind::Rim: {  // outwards n falls
            const double n = valueOf(scene, hold.keys[0]), next = coarse ? n * pow(0.5, onward) : n - onward;
            return {{hold.keys[0], exponentNear(hold, next, false)}};
        }
        case Kind::Number: break;
    }
    const double now = valueOf(scene, hold.keys[0]);
    const auto ref = findSetting(scene, hold.keys[0]);
    if (ref && ref->setting->kind == SettingKind::Integer)
        return {{hold.keys[0], std::clamp(now + onward * (coarse ? 10 : 1), hold.low, hold.high)}};
    if (isLogarithmic(hold))
        return {{hold.keys[0], numberNear(scene, hold, now * pow(coarse ? 2.0 : 1.12, onward), false)}};
    const double step = powerBelow((hold.high - hold.low) / 100) * (coarse ? 10 : 1);
    return {{hold.keys[0], numberNear(scene, hold, now + onward * step, false)}};
}

std::string wordsOf(const Scene& scene, const Hold& hold) {
    const auto value = [&](std::size_t i) { return shortestText(roundedTo(valueOf(scene, hold.keys[i]), 1e-6)); };
    std::string words;
    switch (hold.kind) {
        case Kind::LampAtInfinity: words = fmt::format("x {}  y {}  z {}", value(0), value(1), value(2)); break;
        case Kind::LampFoot: words = fmt::format("x {}  y {}", value(0), value(1)); break;
        case Kind::LampTop: words = fmt::format("z {}", value(0)); break;
        case Kind::Eye: {
            const Vec3d eye = eyeAround(scene.camera);
            words = fmt::format("θ {:.0f}°  φ {:.0f}°", eye.x + 0.0, eye.y);
            break;
        }
        case Kind::Turn: words = value(0) + "°"; break;
        case Kind::Along:
            words = fmt::format("{} {}", hold.symbol.empty() ? hold.name : hold.symbol,
                                shortestText(roundedTo(alongOf(scene, hold), stepAlong(hold))));
            break;
        case Kind::Vertex:
            if (hold.axis == Vec3d(0)) words = fmt::format("{}: ", hold.vertex);
            for (std::size_t i = 0; i < 3; ++i)
                if (hold.axis[int(i)] == 0) words += value(i) + ", ";
            words.resize(words.size() - 2);
            break;
        case Kind::Rim:
        case Kind::Number: {
            std::string lower = hold.name;
            if (!lower.empty() && lower[0] >= 'A' && lower[0] <= 'Z') lower[0] = char(lower[0] + 32);
            words = hold.symbol.empty() ? value(0) + ' ' + lower : hold.symbol + " = " + value(0);
            break;
        }
    }
    return minusSigns(words);
}

}  // namespace pipeline
