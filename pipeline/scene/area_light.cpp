#include "pipeline/scene/area_light.h"

#include <fmt/format.h>

#include "pipeline/core/numerics.h"

namespace pipeline {

SampleGrid sampleGrid(const Light& light) {
    if (light.kind != LightKind::Area) return {};
    return {light.area.width > 0 ? light.area.samples : 1, light.area.height > 0 ? light.area.samples : 1};
}

AreaSides sidesOf(const Light& light) {
    if (light.kind != LightKind::Area) return {};
    const Vec3d normal = normalized(light.area.facing);
    Vec3d across = normalized(glm::cross(Vec3d(0, 0, 1), normal));
    if (across == Vec3d(0)) across = {1, 0, 0};
    return {light.area.width * across, light.area.height * glm::cross(normal, across)};
}

Vec3d samplePlace(const Light& light, SampleGrid grid, const AreaSides& sides, int i) {
    if (grid.count() == 1) return light.position;
    // From the centre, so that the grid lies evenly about it.
    const auto along = [](int cell, int cells) { return (cell + 0.5) / cells - 0.5; };
    return light.position + along(i % grid.columns, grid.columns) * sides.width +
           along(i / grid.columns, grid.rows) * sides.height;
}

std::vector<Vec3d> samplePlaces(const Light& light) {
    const SampleGrid grid = sampleGrid(light);
    const AreaSides sides = sidesOf(light);
    std::vector<Vec3d> places;
    for (int i = 0; i < grid.count(); ++i) places.push_back(samplePlace(light, grid, sides, i));
    return places;
}

std::string shadowPlace(const Light& light, double shadowFactor) {
    if (shadowFactor >= 1) return light.castsShadow ? "lit" : "lit, casts no shadow";
    if (!(shadowFactor > 0)) return "umbra";
    return fmt::format("{} (S = {:.2f})", light.kind == LightKind::Area ? "penumbra" : "filtered edge", shadowFactor);
}

}  // namespace pipeline
