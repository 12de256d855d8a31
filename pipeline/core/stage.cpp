#include "pipeline/core/stage.h"

#include <algorithm>

namespace pipeline {

namespace {

constexpr std::array<StageInfo, kStageCount> kTable{{
    {StageId::Transform, "transform", "Transform", "Takes every vertex from its object to the screen.",
     "meshes, object transforms, camera", "world, view and screen coordinates of every vertex"},
    {StageId::Cull, "cull", "Cull", "Drops the polygons that cannot be seen.", "polygons in view and screen space",
     "a verdict per polygon"},
    {StageId::Normals, "normals", "Normals", "Finds which way polygons and vertices face.", "polygons, vertices",
     "polygon normals, vertex normals"},
    {StageId::ShadowBuffer, "shadow-buffer", "Shadow buffer", "Draws the depth that each casting light sees.",
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
