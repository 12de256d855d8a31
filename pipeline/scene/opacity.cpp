#include "pipeline/scene/opacity.h"

#include <algorithm>

namespace pipeline {
double opacity(const Material& material) { return std::clamp(material.alpha, 0.0, 1.0); }

bool isTransparent(const Object& object, const Settings& settings) {
    return opacity(object.material) == 0 && opacity(effectiveMaterial(object, settings, true)) == 0;
}

std::vector<TranslucentSides> translucentSides(const Scene& scene) {
    std::vector<TranslucentSides> sides;
    bool any = false;
    for (const Object& object : scene.objects) {
        sides.push_back({opacity(object.material) < 1, opacity(effectiveMaterial(object, scene.settings, true)) < 1});
        any = any || ((sides.back().front || sides.back().back) && !isTransparent(object, scene.settings));
    }
    if (!any) sides.clear();
    return sides;
}

std::vector<std::uint8_t> transparentObjects(const Scene& scene) {
    std::vector<std::uint8_t> transparent;
    for (const Object& object : scene.objects) transparent.push_back(isTransparent(object, scene.settings));
    if (std::ranges::find(transparent, 1) == transparent.end()) transparent.clear();
    return transparent;
}

}  // namespace pipeline
