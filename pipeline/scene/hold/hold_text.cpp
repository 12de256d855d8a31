#include <algorithm>
#include <array>
#include <cmath>

#include "pipeline/core/elementary.h"
#include "pipeline/core/text.h"
#include "pipeline/scene/hold/hold_kinds.h"
#include "pipeline/scene/view.h"

// Values of a hold as settings take them, and places as pictures have them.

namespace pipeline {

std::string_view name(Hold::Kind kind) {
    static constexpr std::array<std::string_view, 9> kNames{"lamp",  "foot",   "top", "eye",   "turn",
                                                            "along", "vertex", "rim", "number"};
    return kNames[std::size_t(kind)];
}

double powerBelow(double unit) {
    if (!(unit > 0 && std::isfinite(unit))) return 1;
    double power = std::floor(log(unit) / log(10.0));
    while (pow(10.0, power) > unit) --power;
    while (pow(10.0, power + 1) <= unit) ++power;
    return pow(10.0, power);
}
double roundedTo(double value, double step) {
    // Below 1 the inverse is whole: 3 · 0.1 is not 0.3, and 3 / 10 is.
    const double parts = step < 1 ? std::round(1 / step) : 1 / step;
    return std::round(value * parts) / parts;
}

constexpr double kLogarithmicFrom = 50;  // high / low
bool isLogarithmic(const Hold& hold) { return hold.low > 0 && hold.high / hold.low >= kLogarithmicFrom; }

double shareOf(const Hold& hold, double value) {
    const double share = isLogarithmic(hold) ? log(value / hold.low) / log(hold.high / hold.low)
                                             : (value - hold.low) / (hold.high - hold.low);
    return std::clamp(share, 0.0, 1.0);
}
double numberNear(const Scene& scene, const Hold& hold, double value, bool coarse) {
    const auto ref = findSetting(scene, hold.keys[0]);
    double step = isLogarithmic(hold) ? powerBelow(std::abs(value)) / (coarse ? 1 : 10)
                                      : powerBelow((hold.high - hold.low) / (coarse ? 10 : 100));
    if (ref && ref->setting->kind == SettingKind::Integer) step = std::max(step, 1.0);
    return std::clamp(roundedTo(value, step), hold.low, hold.high);
}

std::string toText(const Assignments& assignments) {
    std::string text;
    for (const auto& [key, value] : assignments)
        text += (text.empty() ? "" : "; ") + key + '=' + shortestText(value == 0 ? 0 : value);
    return text;
}

Result<Scene> withSettings(Scene scene, std::string_view assignments) {
    for (std::string_view rest = assignments;;) {
        const std::size_t end = rest.find("; ");
        auto changed = withSetting(std::move(scene), rest.substr(0, end));
        if (!changed || end == rest.npos) return changed;
        scene = std::move(changed).value();
        rest.remove_prefix(end + 2);
    }
}

std::optional<glm::dvec2> projected(const View& view, Vec3d world) {
    const Vec3d p = toView(view, world);
    if (view.perspective && !(p.z > 0)) return {};
    const double w = view.perspective ? p.z : 1;
    const glm::dvec2 at{view.centre.x + view.scale.x * p.x / w, view.centre.y - view.scale.y * p.y / w};
    return std::isfinite(at.x) && std::isfinite(at.y) ? std::optional(at) : std::nullopt;
}

}  // namespace pipeline
