#include "app/headless/derived_wanted.h"

#include <algorithm>

#include "app/headless/wanted_frame.h"
#include "pipeline/study/shadow_verdict.h"

namespace app {

using pipeline::BufferId;
using pipeline::BufferName;
using pipeline::Error;
using pipeline::Errors;
using pipeline::ExportRequest;
using pipeline::Result;

namespace {

constexpr const char* kVerdicts = "--shadow-verdicts";

// With the option that a buffer's words stand in, and their place; a buffer of no words is named itself.
Errors at(Errors errors, const BufferName& name) {
    const bool isText = name.id == BufferId::Condition || name.id == BufferId::Expression;
    const bool hasWords = isText || name.id == BufferId::Mix;
    for (Error& error : errors) {
        error.where.file = isText ? "--where" : hasWords ? "--mix" : name.text();
        error.where.line = hasWords ? 1 : 0;
        error.where.column = std::max(error.where.column, 1);
    }
    return errors;
}

}  // namespace

Errors noShadowVerdicts(const pipeline::Scene& scene) {
    std::string all;
    for (std::size_t light = 0; light < scene.lights.size(); ++light) {
        const std::string why = whyNoShadowVerdicts(scene, light);
        if (why.empty()) return {};
        if (all.find(why) == all.npos) all += (all.empty() ? "" : " ") + why;
    }
    return {Error{{kVerdicts}, all.empty() ? "The scene has no lights." : all, {}}};
}

Result<DerivedWanted> derivedWanted(const DerivedArgument& argument, const std::vector<BufferName>& named,
                                    const pipeline::Scene& scene, std::optional<pipeline::StageId> until) {
    DerivedWanted wanted;
    wanted.recipe.text = argument.where;
    const auto mix = pipeline::parseMix(argument.mix, scene.lights.size());
    if (!mix) return at(mix.errors(), {BufferId::Mix});
    wanted.recipe.mix = *mix;
    if (argument.shadowVerdicts)
        if (Errors none = noShadowVerdicts(scene); !none.empty()) return none;
    for (const BufferName& name : named)
        if (const auto none = noSuchLight(scene, name)) return *none;
    for (const BufferName& name : pipeline::allDerived(scene.lights.size())) {
        const bool isNamed = std::ranges::find(named, name) != named.end();
        const bool isVerdict = name.id == BufferId::ShadowVerdict && argument.shadowVerdicts;
        const bool isMix = name.id == BufferId::Mix && !argument.mix.empty();
        // Text that gives numbers is no condition.
        const bool isText = name.id == BufferId::Condition && !argument.where.empty() &&
                            std::ranges::find(named, BufferName{BufferId::Expression}) == named.end();
        if (!isNamed && !isVerdict && !isMix && !isText) continue;
        const auto buffers = buffersFor(name, wanted.recipe, scene);
        if (!buffers && isVerdict && !isNamed) continue;  // of another light
        if (!buffers) return at(buffers.errors(), name);
        if (until)
            if (const auto late = comesTooLate(name, lastStageOf(*buffers), *until)) return *late;
        wanted.names.push_back(name);
        wanted.buffers |= *buffers;
    }
    return wanted;
}

Result<std::vector<ExportRequest::Derived>> derivedOf(const DerivedWanted& wanted, const pipeline::Frame& frame,
                                                      int threads, const pipeline::Stop& stop) {
    std::vector<ExportRequest::Derived> made;
    for (const BufferName& name : wanted.names) {
        auto derived = derive(name, wanted.recipe, frame, {.threads = threads, .stop = stop});
        if (stop.stop_requested()) return std::vector<ExportRequest::Derived>();
        if (!derived) return at(derived.errors(), name);
        made.push_back({derived->buffer, derived->meaning});
    }
    return made;
}

}  // namespace app
