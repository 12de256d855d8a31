#include <cmath>

#include "pipeline/core/elementary.h"
#include "pipeline/core/text.h"
#include "pipeline/scene/hold/hold_kinds.h"

// Values of a hold as settings and people read them.

namespace pipeline {

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

double valueOf(const Scene& scene, const std::string& key) {
    const auto ref = findSetting(scene, key);
    return ref ? ref->get(scene) : 0;
}
std::string valueText(const Scene& scene, const Hold& hold, std::size_t key) {
    return shortestText(roundedTo(valueOf(scene, hold.keys[key]), 1e-6));
}
int onward(glm::ivec2 by) { return by.x != 0 ? by.x : -by.y; }

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

}  // namespace pipeline
