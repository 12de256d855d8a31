#include "app/core/stage_buffer.h"

namespace app {

using pipeline::BufferId;
using pipeline::BufferName;
using pipeline::StageId;

BufferName mainBuffer(StageId stage, const pipeline::Scene& scene) {
    switch (stage) {
        case StageId::Transform: return {BufferId::VerticesScreen};
        case StageId::Cull: return {BufferId::PolygonsVerdict};
        case StageId::Normals:
            return {scene.settings.shading == pipeline::Shading::Flat ? BufferId::PolygonsNormal : BufferId::Normal};
        case StageId::ShadowBuffer:
            return scene.lights.empty() ? BufferName{BufferId::Depth} : BufferName{BufferId::ShadowBuffer, 0};
        case StageId::ZBuffer: return {BufferId::ZView};
        case StageId::Shading: break;
    }
    return {BufferId::Color};
}

BufferName secondBuffer(StageId stage, const pipeline::Scene& scene) {
    switch (stage) {
        case StageId::Transform: return {BufferId::VerticesWorld};
        case StageId::Cull: return {BufferId::PolygonId};
        case StageId::Normals:
            return {scene.settings.shading == pipeline::Shading::Flat ? BufferId::Normal : BufferId::PolygonsNormal};
        case StageId::ShadowBuffer:
            return scene.lights.empty() ? BufferName{BufferId::Color} : BufferName{BufferId::Shadow, 0};
        case StageId::ZBuffer: return {BufferId::Overdraw};
        case StageId::Shading: break;
    }
    return scene.lights.empty() ? BufferName{BufferId::Ambient} : BufferName{BufferId::Specular, 0};
}

BufferName mainBufferInside(StageId stage, const pipeline::Scene& scene) {
    if (stage == StageId::Normals) return {BufferId::PolygonsNormal};
    return mainBuffer(stage, scene);
}

BufferName secondBufferInside(StageId stage, const pipeline::Scene& scene) {
    switch (stage) {
        case StageId::Cull: return {BufferId::VerticesScreen};
        case StageId::Normals:
            return {scene.settings.shading == pipeline::Shading::Flat ? BufferId::PolygonsVerdict
                                                                      : BufferId::VerticesNormal};
        case StageId::ShadowBuffer: return {BufferId::PolygonsNormal};
        default: return secondBuffer(stage, scene);
    }
}

}  // namespace app
