#include "app/frames/stage_buffer.h"

#include <algorithm>

#include "pipeline/plan/lit_scene.h"
#include "pipeline/plan/needs.h"

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

BufferName mainBufferInside(StageId stage, const pipeline::Scene& scene) {
    // A scene without lights has no shadow buffer: what the stage before it has computed.
    if (stage == StageId::Normals || (stage == StageId::ShadowBuffer && scene.lights.empty()))
        return {BufferId::PolygonsNormal};
    return mainBuffer(stage, scene);
}

namespace {

// The shadows, where the plan has any computed; else the highlights.
BufferName besideTheFrame(const pipeline::Scene& scene) {
    const pipeline::Needs needs = needsOf(scene, {});
    for (std::size_t k = 0; k < scene.lights.size(); ++k)
        if (needs.of(pipeline::Part::ShadowBuffer, k) && whyUseless(scene, BufferId::Shadow).empty())
            return {BufferId::Shadow, int(k)};
    return scene.lights.empty() ? BufferName{BufferId::Ambient} : BufferName{BufferId::Specular, 0};
}

// What the stage leaves that explains the main one.
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
    return besideTheFrame(scene);
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

// Beside the first two.
std::vector<BufferName> moreBuffers(StageId stage, const pipeline::Scene& scene) {
    const bool lit = !scene.lights.empty();
    std::vector<BufferName> more;
    switch (stage) {
        case StageId::Transform: more = {{BufferId::VerticesView}, {BufferId::PolygonId}}; break;
        case StageId::Cull: more = {{BufferId::VerticesScreen}, {BufferId::VerticesView}}; break;
        case StageId::Normals: more = {{BufferId::PolygonsVerdict}, {BufferId::VerticesNormal}}; break;
        case StageId::ShadowBuffer:
            if (scene.lights.size() > 1) more.push_back({BufferId::ShadowBuffer, 1});
            if (lit) more.push_back({BufferId::NDotL, 0});
            break;
        case StageId::ZBuffer: more = {{BufferId::PolygonId}, {BufferId::DepthWrites}, {BufferId::Barycentric}}; break;
        case StageId::Shading:
            if (lit)
                more = {{BufferId::Specular, 0}, {BufferId::Diffuse, 0}, {BufferId::Ambient}, {BufferId::NDotL, 0}};
            break;
    }
    for (const BufferId id : {BufferId::Color, BufferId::ZView, BufferId::PolygonId, BufferId::Normal,
                              BufferId::PolygonsNormal, BufferId::PolygonsVerdict, BufferId::VerticesScreen})
        more.push_back({id});
    return more;
}

// Zero throughout, whatever the view: nothing to look at.
bool isDark(const pipeline::Scene& scene, const BufferName& name) {
    const auto none = [&](auto part) {
        return std::ranges::all_of(scene.objects,
                                   [&](const pipeline::Object& o) { return part(o.material) == pipeline::Vec3d(0); });
    };
    const bool isGl = pipeline::modelFacts(scene.settings.model).found.glLights;
    if (name.id == BufferId::Ambient) return !isGl && scene.ambient.intensityIn(scene.settings.model) == 0;
    if (name.id != BufferId::Specular && name.id != BufferId::Diffuse) return false;
    const pipeline::Light& light = scene.lights[std::size_t(name.light)];
    if (!pipeline::whyDark(light, scene.settings.model).empty()) return true;
    if (name.id == BufferId::Diffuse) return none([](const pipeline::Material& m) { return m.diffuse; });
    const auto isDull = [&](const pipeline::Object& o) { return !pipeline::shines(scene.settings.model, o.material); };
    return std::ranges::all_of(scene.objects, isDull) || (isGl && light.gl.specular == pipeline::Vec3d(0));
}

}  // namespace

std::vector<BufferName> usefulBuffers(StageId stage, const pipeline::Scene& scene, bool inside) {
    std::vector<BufferName> all{inside ? mainBufferInside(stage, scene) : mainBuffer(stage, scene)};
    std::vector<BufferName> others = moreBuffers(stage, scene);
    others.insert(others.begin(), inside ? secondBufferInside(stage, scene) : secondBuffer(stage, scene));
    for (const BufferName& name : others) {
        const bool isLater = inside && bufferInfo(name.id).stage > stage;
        const bool shows = !isLater && !isDark(scene, name) && whyUseless(scene, name.id).empty();
        if (shows && std::ranges::count(all, name) == 0) all.push_back(name);
    }
    return all;
}

}  // namespace app
