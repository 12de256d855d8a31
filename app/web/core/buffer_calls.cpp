#include "app/web/core/core.h"
#include "app/web/core/rays.h"
#include "pipeline/buffers/buffer_table.h"
#include "pipeline/export/json/frame_json.h"
#include "pipeline/inspect/term_mix.h"
#include "pipeline/plan/needs.h"

// Which buffers there are, and those that are made of a finished frame.

namespace web {

using pipeline::AnyBuffer;
using pipeline::BufferName;

namespace {

std::optional<AnyBuffer> derivedNamed(ShownScene& shown, const BufferName& name) {
    const pipeline::FramePtr& frame = shown.atMoment ? shown.atMoment : shown.frame;
    if (shown.derivedOf != frame) shown.derived.clear(), shown.derivedOf = frame;
    const auto known = shown.derived.find(name.text());
    if (known != shown.derived.end()) return known->second.buffer;
    if (name.id == pipeline::BufferId::ShadowVerdict && !castsRays()) {
        refuse("The program alone casts exact rays: open the scene in Shadescope to see the verdicts.");
        return {};
    }
    const auto needed = buffersFor(name, core().recipe, frame->scene());
    auto made = needed ? derive(name, core().recipe, *frame, {.threads = 1})
                       : pipeline::Result<lessons::DerivedBuffer>(needed.errors());
    if (!made) {
        refuse(made.errors());
        return {};
    }
    return shown.derived.emplace(name.text(), std::move(made).value()).first->second.buffer;
}

}  // namespace

std::optional<AnyBuffer> bufferNamed(ShownScene& shown, std::string_view text) {
    const auto name = pipeline::findAnyBuffer(text);
    if (!name) {
        refuse("no buffer \"" + std::string(text) + "\"; " + pipeline::insteadOfAnyBuffer(text));
        return {};
    }
    if (isDerived(name->id)) return derivedNamed(shown, *name);
    auto buffer = shown.now().buffer(*name);
    if (!buffer) refuse(shown.now().whyAbsent(*name));
    return buffer;
}

// Every buffer that the scene can have, and why it has no use for one.
WEB_CALL(buffers) int webBuffers() {
    const pipeline::Scene& scene = core().own.now().scene();
    Json list = Json::array();
    for (const BufferName& name : pipeline::allBuffers(scene.lights.size()))
        list.push_back(bufferToJson(name, pipeline::stageInfo(pipeline::bufferInfo(name.id).stage).label,
                                    whyUseless(scene, name.id)));
    for (const BufferName& name : pipeline::allDerived(scene.lights.size()))
        list.push_back(bufferToJson(name, "Derived", {}));
    return give(list);
}

// What `condition`, `expression` and `mix` are made after: texts as the program's fields take them; empty: none.
WEB_CALL(recipe) int webRecipe(const char* text, int size, const char* mixed, int mixedSize) {
    const auto mix = pipeline::parseMix(textAt(mixed, mixedSize), core().own.scene->lights.size());
    if (!mix && mixedSize > 0) return refuse(mix.errors());
    core().recipe = {std::string(textAt(text, size)), mix ? *mix : pipeline::TermMix()};
    for (ShownScene* shown : {&core().own, core().other ? &*core().other : nullptr})
        if (shown) shown->derived.clear();
    return give(true);
}

}  // namespace web
