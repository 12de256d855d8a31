#include "app/drawing3d/lobe_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "app/look/numbers.h"
#include "pipeline/core/text.h"

namespace app {

namespace {

constexpr int kMeridians = 12, kPointsAround = 36, kSteps = 28;

}  // namespace

std::vector<glm::dvec2> lobeProfile(double exponent, int steps) {
    constexpr double kLeast = 0.01;
    const double widest = exponent > 0 ? std::acos(std::pow(kLeast, 1 / exponent)) : std::numbers::pi / 2;
    std::vector<glm::dvec2> profile;
    for (int i = 0; i <= steps; ++i) {
        const double a = widest * i / steps;
        profile.emplace_back(a, exponent > 0 ? std::pow(std::cos(a), exponent) : 1.0);
    }
    if (exponent > 0) profile.emplace_back(widest, 0.0);
    return profile;
}

void addLobe(const SpecularLobe& lobe, double length, Drawing& drawing) {
    const Ink ink = inkOf(lobe.code);
    const Vec3d u = across(lobe.axis), v = glm::cross(lobe.axis, u);
    const auto at = [&](glm::dvec2 p, double around) {
        return lobe.base +
               length * p.y *
                   (std::cos(p.x) * lobe.axis + std::sin(p.x) * (std::cos(around) * u + std::sin(around) * v));
    };
    const auto profile = lobeProfile(lobe.exponent, kSteps);
    constexpr float kStrength = 0.75f;
    for (int m = 0; m < kMeridians; ++m) {
        const double around = 2 * std::numbers::pi * m / kMeridians;
        for (std::size_t i = 0; i + 1 < profile.size(); ++i)
            drawing.lines.push_back({at(profile[i], around), at(profile[i + 1], around), ink, kStrength, kStrength});
    }
    for (std::size_t i = 4; i < profile.size(); i += 4)
        for (int k = 0; k < kPointsAround; ++k)
            drawing.lines.push_back({at(profile[i], 2 * std::numbers::pi * k / kPointsAround),
                                     at(profile[i], 2 * std::numbers::pi * (k + 1) / kPointsAround), ink, kStrength,
                                     kStrength});
    if (!lobe.main) return;
    // From the foot to where the probe leaves the surface: its length is the factor.
    const Vec3d cut = lobe.base + length * lobe.power * lobe.probe;
    drawing.solids.push_back({Ink::Text, ball(cut, 0.022 * length, 12), 0.004 * length});
    if (lobe.power > 0) drawing.solids.push_back({Ink::Text, tube(lobe.base, cut, 0.009 * length), 0.004 * length});
    const std::string power = dotProduct(lobe.power).toStdString();
    const char* name = lobe.code == VectorCode::H ? "(N·H)" : "(R·V)";
    drawing.labels.push_back({.kind = Label::Kind::Plane,
                              .at = cut,
                              .foot = cut - lobe.axis,
                              .text = name + std::string("^") + pipeline::shortestText(lobe.exponent) + " = " + power,
                              .distance = {},
                              .ink = Ink::Text});
}

}  // namespace app
