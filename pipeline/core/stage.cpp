#include "pipeline/core/stage.h"

#include <algorithm>

namespace pipeline {

namespace {

constexpr std::array<StageInfo, kStageCount> kTable{{
    {StageId::Transform, "transform", "Transform", "Transforms every vertex from its object to the screen.",
     "meshes, object transforms, camera", "world, view and screen coordinates of every vertex"},
    {StageId::Cull, "cull", "Cull", "Drops polygons that cannot be visible.", "polygons in view and screen space",
     "a verdict per polygon"},
    {StageId::Normals, "normals", "Normals", "Computes the normals of polygons and vertices.", "polygons, vertices",
     "polygon normals, vertex normals"},
    {StageId::ShadowBuffer, "shadow-buffer", "Shadow buffer", "Draws the depth as each light with shadows sees it.",
     "polygons, lights", "Z' of each casting light"},
    {StageId::ZBuffer, "z-buffer", "Z-buffer", "Finds the nearest polygon at every pixel.",
     "kept polygons in screen space", "depth, object, polygon and barycentrics of every pixel, counts of fragments"},
    {StageId::Shading, "shading", "Shading", "Evaluates the illumination model and fills the frame buffer.",
     "all of the above, materials, lights", "vectors, dot products, terms and intensities, the frame buffer"},
}};

}  // namespace

const StageInfo& stageInfo(StageId stage) { return kTable[index(stage)]; }

std::optional<StageId> findStage(std::string_view name) {
    const auto found = std::ranges::find(kTable, name, &StageInfo::name);
    return found == kTable.end() ? std::nullopt : std::optional(found->id);
}

}  // namespace pipeline
