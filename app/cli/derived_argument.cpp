#include "app/cli/derived_argument.h"

#include <CLI/CLI.hpp>
#include <algorithm>

namespace app {

using pipeline::BufferId;
using pipeline::BufferName;
using pipeline::Error;
using pipeline::Errors;
using pipeline::ExportRequest;
using pipeline::Result;

void declareDerived(CLI::App& command, DerivedArgument& argument) {
    command.add_flag(
        "--shadow-verdicts", argument.shadowVerdicts,
        "Write shadow_verdict.k of every light that casts a shadow: lit, shadowed, acne, leak against rays");
    command
        .add_option("--where", argument.where,
                    "Write condition: 1 where it holds, such as \"n_dot_l.0 < 0.5\"; with --buffers expression its "
                    "numbers, such as \"2 * n_dot_l.0\"")
        ->type_name("CONDITION");
    command
        .add_option("--mix", argument.mix,
                    "Write mix: the picture with other gains, such as ambient=0,specular.0=2; also =solo, =muted")
        ->type_name("TERM=GAIN,...");
}

namespace {

// Which option a buffer's words stand in.
std::string optionOf(const BufferName& name) {
    switch (name.id) {
        case BufferId::Mix: return "--mix";
        case BufferId::ShadowVerdict: return "--shadow-verdicts";
        default: return "--where";
    }
}

Errors at(Errors errors, const BufferName& name) {
    for (Error& error : errors) {
        error.where.file = optionOf(name);
        error.where.line = 1;
        error.where.column = std::max(error.where.column, 1);
    }
    return errors;
}

}  // namespace

Result<DerivedWanted> derivedWanted(const DerivedArgument& argument, const std::vector<BufferName>& named,
                                    const pipeline::Scene& scene) {
    DerivedWanted wanted;
    wanted.recipe.text = argument.where;
    const auto mix = pipeline::parseMix(argument.mix, scene.lights.size());
    if (!mix) return at(mix.errors(), {BufferId::Mix});
    wanted.recipe.mix = *mix;
    bool anyMap = false;
    Errors noMap{Error{{}, "The scene has no lights.", {}}};
    for (const BufferName& name : pipeline::allDerived(scene.lights.size())) {
        const bool isNamed = std::ranges::find(named, name) != named.end();
        const bool isMap = name.id == BufferId::ShadowVerdict && argument.shadowVerdicts && !isNamed;
        const bool isMix = name.id == BufferId::Mix && !argument.mix.empty();
        // Text that gives numbers is no condition.
        const bool isText = name.id == BufferId::Condition && !argument.where.empty() &&
                            std::ranges::find(named, BufferName{BufferId::Expression}) == named.end();
        if (!isNamed && !isMap && !isMix && !isText) continue;
        const auto buffers = buffersFor(name, wanted.recipe, scene);
        if (!buffers && isMap) {
            noMap = buffers.errors();
            continue;
        }
        if (!buffers) return at(buffers.errors(), name);
        anyMap = anyMap || isMap;
        wanted.names.push_back(name);
        wanted.buffers |= *buffers;
    }
    if (argument.shadowVerdicts && !anyMap && named.empty()) return at(noMap, {BufferId::ShadowVerdict});
    return wanted;
}

Result<std::vector<ExportRequest::Derived>> derivedOf(const DerivedWanted& wanted, const pipeline::Frame& frame,
                                                      int threads, std::stop_token stop) {
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
