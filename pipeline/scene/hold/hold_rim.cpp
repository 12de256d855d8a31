#include <algorithm>
#include <cmath>
#include <numbers>

#include "pipeline/core/angles.h"
#include "pipeline/core/elementary.h"
#include "pipeline/core/numerics.h"
#include "pipeline/scene/hold/hold_kinds.h"
#include "pipeline/scene/object_matrix.h"

// The rim of a highlight has no closed form where the eye is near: R·V changes with N and with the place.

namespace pipeline {

namespace {

constexpr int kSteps = 12;                    // Newton's, from a guess that is right for a far eye
constexpr double kLeast = 1e-3, kMost = 1.3;  // radians of the ball between the middle of the highlight and its rim
constexpr double kBeside = 1e-6;
constexpr double kWholeUpTo = 64;

// A ball with the direction of the normal in the middle of its highlight, in the first light.
class HighlightOfBall {
public:
    HighlightOfBall(const Scene& scene, const Hold& hold)
        : m_scene(scene), m_view(makeView(scene)), m_object(scene.objects[hold.index]) {
        const ObjectMatrix matrix = makeObjectMatrix(m_object.transform);
        m_middle = matrix.translation, m_radius = glm::length(matrix.linear[0]);
        m_isHalfway = usesHalfway(scene.settings.model, m_object.material);
        m_peak = -m_view.forward;
        if (scene.lights.empty()) return;
        // In the middle N is halfway between L and V.
        for (int i = 0; i < kSteps; ++i) m_peak = normalized(light(m_peak) + viewer(m_peak));
        m_aside = normalized(m_view.right - glm::dot(m_view.right, m_peak) * m_peak);
    }
    double factor() const {
        return effectiveExponent(m_scene.settings.model, m_scene.settings.exponentFactor, {.exponent = 1});
    }
    Vec3d normalAt(double t) const {
        const double degrees = t * 180 / std::numbers::pi;
        return cosDegrees(degrees) * m_peak + sinDegrees(degrees) * m_aside;
    }
    std::optional<glm::dvec2> placeAt(double t) const { return projected(m_view, m_middle + m_radius * normalAt(t)); }
    // ln of R·V or N·H.
    double logAt(double t) const {
        const Vec3d N = normalAt(t), L = light(N), V = viewer(N);
        const double cosine = m_isHalfway ? glm::dot(N, normalized(L + V)) : glm::dot(2 * glm::dot(N, L) * N - L, V);
        return log(std::max(cosine, 1e-300));
    }
    bool isLit() const { return !m_scene.lights.empty() && glm::dot(m_peak, light(m_peak)) > 0; }
    // The guess: R turns twice as far as N, H not at all, and -ln cos φ is φ²/2.
    double guess(double n) const { return std::sqrt(2 * std::numbers::ln2 / n) / (m_isHalfway ? 1 : 2); }

private:
    Vec3d light(const Vec3d& N) const {
        const Light& light = m_scene.lights[0];
        return normalized(light.kind == LightKind::AtInfinity ? light.position : light.position - at(N));
    }
    Vec3d viewer(const Vec3d& N) const {
        const Viewer kind = modelFacts(m_scene.settings.model).viewer;
        const bool isFar = !m_view.perspective || (kind == Viewer::Setting && !m_scene.settings.localViewer);
        return isFar ? -m_view.forward : normalized(m_view.eye - at(N));
    }
    Vec3d at(const Vec3d& N) const { return m_middle + m_radius * N; }

    const Scene& m_scene;
    const View m_view;
    const Object& m_object;
    Vec3d m_middle{0.0}, m_peak{0.0}, m_aside{0.0};
    double m_radius = 1;
    bool m_isHalfway = false;
};

// The angle at which cos^n is a half, by Newton's method.
double rimAngle(const HighlightOfBall& highlight, double n) {
    double t = std::clamp(highlight.guess(n), kLeast, kMost);
    for (int i = 0; i < kSteps; ++i) {
        const double off = n * highlight.logAt(t) + std::numbers::ln2;
        const double slope = n * (highlight.logAt(t + kBeside) - highlight.logAt(t - kBeside)) / (2 * kBeside);
        if (!(slope < 0)) break;
        t = std::clamp(t - off / slope, kLeast, kMost);
    }
    return t;
}

double exponentOf(const Scene& scene, const Hold& hold) { return scene.objects[hold.index].material.exponent; }

// n is whole up to 64, and has two digits from there on.
double exponentNear(const Hold& hold, double n, bool coarse) {
    if (coarse) n = pow(2.0, std::round(log(std::max(n, 1e-9)) / std::numbers::ln2));
    return std::clamp(roundedTo(n, n <= kWholeUpTo ? 1 : powerBelow(n) / 10), hold.low, hold.high);
}

// The rim's point to the right of the highlight's middle. Nothing where the ball is unlit or outside the picture.
std::optional<HoldPlace> rimPlace(const Scene& scene, const Hold& hold) {
    const HighlightOfBall highlight(scene, hold);
    if (!highlight.isLit()) return {};
    const double n = highlight.factor() * std::max(exponentOf(scene, hold), hold.low);
    const auto at = highlight.placeAt(rimAngle(highlight, n));
    return at ? std::optional(HoldPlace{*at}) : std::nullopt;
}
// The n with which the rim is nearest to the pointer.
Assignments rimDragged(const Scene& scene, const Hold& hold, const Drag& drag) {
    const HighlightOfBall highlight(scene, hold);
    double t = rimAngle(highlight, highlight.factor() * std::max(exponentOf(scene, hold), hold.low));
    for (int i = 0; i < kSteps; ++i) {
        const auto now = highlight.placeAt(t), beside = highlight.placeAt(t + kBeside);
        if (!now || !beside) break;
        const glm::dvec2 move = (*beside - *now) / kBeside;
        t = std::clamp(t + glm::dot(drag.target() - *now, move) / glm::dot(move, move), kLeast, kMost);
    }
    const double n = -std::numbers::ln2 / highlight.logAt(t) / highlight.factor();
    return {{hold.keys[0], exponentNear(hold, std::isfinite(n) ? n : exponentOf(scene, hold), drag.isCoarse)}};
}
// Outwards n falls.
Assignments rimNudged(const Scene& scene, const Hold& hold, glm::ivec2 by, bool coarse) {
    const double n = exponentOf(scene, hold), way = onward(by);
    return {{hold.keys[0], exponentNear(hold, coarse ? n * pow(0.5, way) : n - way, false)}};
}

}  // namespace

const HoldKindRow kRim{"rim", rimPlace, rimDragged, rimNudged, numberWords, false, true};

}  // namespace pipeline
