#include "app/cli/derived_argument.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "lessons/condition.h"
#include "pipeline/inspect/term_mix.h"
#include "pipeline/study/shadow_verdict.h"

namespace app {

using pipeline::BufferSet;
using pipeline::Error;
using pipeline::Errors;
using pipeline::ExportRequest;
using pipeline::Result;

void declareDerived(CLI::App& command, DerivedArgument& argument) {
    command.add_flag(
        "--shadow-verdicts", argument.shadowVerdicts,
        "Write shadow_verdict.k of every light that casts a shadow: lit, shadowed, acne, leak against rays");
    command.add_option("--where", argument.where, "Write condition: 1 where it holds, such as \"n_dot_l.0 < 0.5\"")
        ->type_name("CONDITION");
    command
        .add_option("--mix", argument.mix, "Write mix: the picture with other gains, such as ambient=0,specular.0=2")
        ->type_name("TERM=GAIN,...");
}

Result<BufferSet> buffersFor(const DerivedArgument& argument, const pipeline::Scene& scene) {
    BufferSet buffers;
    if (argument.shadowVerdicts) buffers |= pipeline::setOf({pipeline::BufferId::Shadow});
    if (!argument.where.empty()) {
        const auto condition = lessons::parseCondition(argument.where, {"--where", 1, 1}, scene);
        if (!condition) return condition.errors();
        buffers |= condition->buffers;
    }
    if (!argument.mix.empty()) {
        const auto mix = pipeline::parseMix(argument.mix, scene.lights.size());
        if (!mix) {
            Error error = mix.errors().front();
            error.where = {"--mix", 1, 1};
            return error;
        }
        if (const std::string why = whyNoMix(scene); !why.empty()) return Error{{"--mix", 1, 1}, why, {}};
        buffers |= pipeline::mixBuffers();
    }
    return buffers;
}

Result<std::vector<ExportRequest::Derived>> derivedOf(const DerivedArgument& argument, const pipeline::Frame& frame,
                                                      int threads, std::stop_token stop) {
    const pipeline::Scene& scene = frame.scene();
    std::vector<ExportRequest::Derived> made;
    bool anyMap = false;
    std::string why = "The scene has no lights.";
    for (std::size_t k = 0; argument.shadowVerdicts && k < scene.lights.size(); ++k) {
        if (why = whyNoShadowVerdicts(scene, k); !why.empty()) continue;
        const auto exact = exactShadows(scene, k, threads, stop);
        if (!exact) return made;
        const auto verdicts = judgeShadows(frame, *exact);
        if (!verdicts) return Error{{"--shadow-verdicts", 0, 0}, fmt::format("no shadow.{} in this frame", k), {}};
        anyMap = true;
        made.push_back({fmt::format("shadow_verdict.{}", k),
                        "Of the shadow factor against exact rays: 0 lit, 1 shadowed, 2 acne, 3 leak; -1 none.",
                        numbersOf(*verdicts), pictureOf(*verdicts)});
    }
    if (argument.shadowVerdicts && !anyMap) return Error{{"--shadow-verdicts", 0, 0}, why, {}};
    if (!argument.where.empty()) {
        const auto condition = lessons::parseCondition(argument.where, {"--where", 1, 1}, scene);
        const auto mask = lessons::evaluate(*condition, frame);
        if (!mask) return mask.errors();
        made.push_back({"condition", fmt::format("1 where {} holds, else 0.", condition->text),
                        lessons::numbersOf(*mask), lessons::pictureOf(*mask)});
    }
    if (!argument.mix.empty()) {
        const auto mix = pipeline::parseMix(argument.mix, scene.lights.size());
        const auto mixed = mixTerms(frame, *mix, stop);
        if (!mixed) return mixed.errors();
        made.push_back({"mix", fmt::format("The frame buffer of the terms mixed so: {}.", describe(*mix)), mixed->color,
                        std::nullopt});
    }
    return made;
}

}  // namespace app
