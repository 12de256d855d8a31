#include <array>
#include <cmath>

#include "pipeline/core/text.h"
#include "pipeline/scene/hold.h"
#include "pipeline/scene/view.h"

// Values of a hold as settings take them, and places as pictures have them.

namespace pipeline {

std::string_view name(Hold::Kind kind) {
    static constexpr std::array<std::string_view, 7> kNames{"lamp", "foot", "top", "eye", "turn", "along", "number"};
    return kNames[std::size_t(kind)];
}

constexpr double kLogarithmicFrom = 50;  // high / low
bool isLogarithmic(const Hold& hold) { return hold.low > 0 && hold.high / hold.low >= kLogarithmicFrom; }

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
