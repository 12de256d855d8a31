#include "app/headless/wanted_frame.h"

#include <fmt/format.h>

#include <algorithm>

#include "pipeline/core/text.h"
#include "pipeline/plan/needs.h"
#include "pipeline/run/frame_remarks.h"

namespace app {

using pipeline::BufferName;
using pipeline::StageId;

namespace {

pipeline::Result<StageId> stageNamed(const std::string& text) {
    if (const auto stage = pipeline::findStage(text)) return *stage;
    std::vector<std::string> names;
    for (const StageId stage : pipeline::kStages) names.emplace_back(pipeline::stageInfo(stage).name);
    return pipeline::Error{
        {}, fmt::format("no stage {}; {}", pipeline::inQuotes(text), pipeline::insteadOf(text, names)), {}};
}

}  // namespace

std::string remarksText(const pipeline::Frame& frame) {
    std::string text;
    const auto add = [&](const std::optional<pipeline::Remark>& remark) {
        if (remark) text += fmt::format("{}{}{}\n", remark->about, remark->about.empty() ? "" : ": ", remark->text);
    };
    for (const StageId stage : pipeline::kStages) add(frame.run(stage).remark);
    add(whyNothingIsSeen(frame));
    return text;
}

pipeline::Result<BufferName> bufferNamed(const pipeline::Scene& scene, const std::string& text, bool makesDerived) {
    const auto name = pipeline::findBuffer(text);
    if (!name && pipeline::findDerived(text))
        return pipeline::Error{{}, text + " is derived from a finished frame: export writes it, no stage leaves it"};
    if (!name)
        return pipeline::Error{
            {},
            fmt::format("no buffer {}; {}", pipeline::inQuotes(text),
                        makesDerived ? pipeline::insteadOfAnyBuffer(text) : pipeline::insteadOfBuffer(text))};
    if (const auto none = noSuchLight(scene, *name)) return *none;
    return *name;
}

std::optional<pipeline::Error> noSuchLight(const pipeline::Scene& scene, const BufferName& name) {
    const std::size_t lights = scene.lights.size();
    if (name.light < static_cast<int>(lights)) return std::nullopt;
    return pipeline::Error{
        {},
        fmt::format("no buffer \"{}\": this scene has {} light{}", name.text(), lights, lights == 1 ? "" : "s"),
        {}};
}

StageId lastStageOf(const pipeline::BufferSet& buffers) {
    auto last = StageId::Transform;
    for (const pipeline::BufferInfo& info : pipeline::bufferTable())
        if (buffers.test(index(info.id))) last = std::max(last, info.stage);
    return last;
}

std::optional<pipeline::Error> comesTooLate(const BufferName& name, StageId from, StageId until) {
    if (from <= until) return std::nullopt;
    return pipeline::Error{{},
                           fmt::format("{} comes from {}, and the run ends after {}", name.text(),
                                       pipeline::stageInfo(from).name, pipeline::stageInfo(until).name),
                           {}};
}

pipeline::Result<WantedFrame> wantedFrame(const pipeline::Scene& scene, const FrameArgument& argument) {
    WantedFrame wanted;
    wanted.request.threads = argument.threads;
    const bool all = std::ranges::find(argument.buffers, "all") != argument.buffers.end();
    StageId last = StageId::Transform;
    for (const std::string& text : argument.buffers) {
        if (text == "all") continue;
        const auto name = bufferNamed(scene, text, argument.makesDerived);
        if (!name) return name.errors();
        wanted.request.wanted.set(index(name->id));
        last = std::max(last, pipeline::bufferInfo(name->id).stage);
        if (std::ranges::find(wanted.buffers, *name) == wanted.buffers.end()) wanted.buffers.push_back(*name);
    }
    if (all) {
        wanted.request.wanted |= pipeline::usefulBuffers(scene);
        wanted.buffers.clear();
    } else {
        wanted.request.until = last;
    }
    if (argument.until.empty()) return wanted;
    const auto until = stageNamed(argument.until);
    if (!until) return until.errors();
    for (const BufferName& buffer : wanted.buffers)
        if (const auto late = comesTooLate(buffer, pipeline::bufferInfo(buffer.id).stage, *until)) return *late;
    wanted.request.until = *until;
    return wanted;
}

}  // namespace app
