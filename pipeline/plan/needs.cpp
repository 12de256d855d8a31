#include "pipeline/plan/needs.h"

#include <algorithm>

#include "pipeline/plan/lit_scene.h"
#include "pipeline/plan/part_rows.h"

namespace pipeline {

Parts Needs::parts(StageId stage) const {
    Parts done;
    for (std::size_t k = 0; k < lights[index(Part::Light)].size(); ++k) done.lights.emplace_back(PartSet::all());
    for (std::size_t i = 0; i < kPartCount; ++i) {
        const Part part = Part(i);
        if (partInfo(part).stage != stage || !partInfo(part).isHanded) continue;
        done.whole.set(part, whole[i].isWhole());
        for (std::size_t k = 0; k < lights[i].size(); ++k) done.lights[k].set(part, lights[i][k].isWhole());
    }
    return done;
}

Needs needsOf(const Scene& scene, BufferSet wanted, StageId until) {
    Needs needs;
    needs.rules = rulesOf(scene.settings);
    needs.buffers = wanted;
    // A shadow buffer is not made for its own sake: its light decides. Where this rule alone is asked for it holds with a
    // planted defect too: it changes no stage, and `compare` draws a hundred such frames.
    const Settings& settings = scene.settings;
    const bool alone = settings.leaveOut && settings.rules == RuleSet().set(index(Rule::UnreadBuffers));
    if (!needs.rules[index(Rule::UnreadBuffers)] && !alone)
        needs.buffers.set().set(index(BufferId::ShadowBuffer), wanted[index(BufferId::ShadowBuffer)]);
    const std::optional<Scene> drawn = withoutTransparent(scene, needs.buffers);
    const Decision decision(scene, drawn ? *drawn : scene, until, needs);
    for (std::size_t part = 0; part < kPartCount; ++part) decision.decide(Part(part));
    needs.buffers.set(index(BufferId::Intensity), bool(needs[Part::Intensity]));
    return needs;
}

namespace {

std::string whyUseless(const Scene& scene, const Needs& needs, BufferId id) {
    const BufferInfo& info = bufferInfo(id);
    if (info.perLight && scene.lights.empty()) return "The scene has no light.";
    const bool atPixels = info.stage == StageId::Shading && info.domain == Domain::Pixel;
    if (outlines(scene)) {
        if (atPixels && id != BufferId::Intensity && id != BufferId::Antialiased && id != BufferId::Color)
            return kOutlines;
    } else if (atPixels && !needs.rules[index(Rule::UnreadBuffers)]) {
        return {};  // all of them are made
    }
    for (std::size_t part = 0; part < kPartCount; ++part) {
        // Intensities read of culling which elements have one: where it is left out, all have.
        if (Part(part) == Part::Culling && info.stage != StageId::Cull) continue;
        if (info.reads[Part(part)])
            if (std::string why = partInfo(Part(part)).useless(scene, needs); !why.empty()) return why;
    }
    return {};
}

}  // namespace

BufferSet normalsOfShading(const Scene& scene) {
    if (scene.settings.visibility == Visibility::None) return {};
    return setOf({scene.settings.shading == Shading::Flat ? BufferId::PolygonsNormal : BufferId::VerticesNormal});
}

std::string whyUseless(const Scene& scene, BufferId id) { return whyUseless(scene, needsOf(scene, {}), id); }

BufferSet usefulBuffers(const Scene& scene) {
    const Needs needs = needsOf(scene, {});
    BufferSet set;
    for (const BufferInfo& info : bufferTable()) set[index(info.id)] = whyUseless(scene, needs, info.id).empty();
    return set;
}

}  // namespace pipeline
