#pragma once
#include <memory>
#include <optional>
#include <variant>

#include "pipeline/plan/stage_keys.h"
#include "pipeline/run/frame.h"
#include "pipeline/stages/shading.h"

namespace pipeline {

// The outputs of the stages. Each is immutable and shared by every frame that it is valid for. Null if the plan left
// the stage out.
template <class Real>
struct FrameData {
    StageKeys keys;
    std::shared_ptr<const TransformOutput<Real>> transform;
    std::shared_ptr<const CullOutput> cull;
    std::shared_ptr<const NormalsOutput<Real>> normals;
    std::shared_ptr<const ShadowBufferOutput<Real>> shadowBuffer;
    std::shared_ptr<const ZBufferOutput<Real>> zBuffer;
    std::shared_ptr<const ShadingOutput<Real>> shading;

    bool has(StageId stage) const {
        switch (stage) {
            case StageId::Transform: return transform != nullptr;
            case StageId::Cull: return cull != nullptr;
            case StageId::Normals: return normals != nullptr;
            case StageId::ShadowBuffer: return shadowBuffer != nullptr;
            case StageId::ZBuffer: return zBuffer != nullptr;
            case StageId::Shading: return shading != nullptr;
        }
        return false;
    }
    const RawVector<Verdict>& verdicts() const {
        static const RawVector<Verdict> kNone;
        return cull ? cull->verdicts : kNone;
    }
    // Whether `visibility none` draws a polygon's outline. With cull = none it draws every polygon, degenerate ones
    // too, except those of transparent objects.
    bool hasOutline(std::uint32_t polygon) const {
        const std::vector<std::uint8_t>& transparent = transform->transparent;
        if (!transparent.empty() && transparent[transform->topology->objectOfPolygon(polygon)] != 0) return false;
        return keys.cull.mode == CullMode::None || goesOn(cull->verdicts[polygon]);
    }
    ShadingSources<Real> shadingSources() const {
        static const NormalsOutput<Real> kNone;  // outlines need no normals
        return {*transform, normals ? *normals : kNone, shadowBuffer.get(), *zBuffer, cull.get()};
    }
};

// The outputs of a frame, in its precision.
struct FrameStages {
    std::variant<FrameData<float>, FrameData<double>, FrameData<long double>, FrameData<Quad>> data;
};

// Calls read(FrameData) in the frame's precision.
template <class Read>
auto readStages(const Frame& frame, Read read) {
    return std::visit(read, frame.stages().data);
}
// Null if the frame has another precision.
template <class Real>
const FrameData<Real>* dataOf(const Frame& frame) {
    return std::get_if<FrameData<Real>>(&frame.stages().data);
}

// The topology of the scene's meshes; that of `before` if the meshes are the same.
std::shared_ptr<const Topology> topologyOf(const Scene& scene, const FramePtr& before);

}  // namespace pipeline
