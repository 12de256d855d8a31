#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "app/cli/commands.h"
#include "app/cli/frame_argument.h"
#include "app/cli/interrupt.h"
#include "app/cli/message.h"
#include "app/cli/scene_argument.h"
#include "pipeline/export/json.h"
#include "pipeline/plan/memory_limit.h"
#include "pipeline/plan/needs.h"
#include "pipeline/plan/scene_remarks.h"
#include "pipeline/run/frame_remarks.h"
#include "pipeline/run/runner.h"
#include "pipeline/scene/settings_table.h"

namespace app {

namespace {

struct PlanOptions {
    SceneArgument scene;
    FrameArgument frame;
    bool json = false, counts = false;
};

// "k_s is 0 in every material. Saves a power a point. [specular]"
std::string reason(std::string text, const std::string& saves, std::optional<pipeline::Rule> rule) {
    if (!saves.empty()) text += fmt::format(" Saves {}.", saves);
    if (rule) text += fmt::format(" [{}]", name(*rule));
    return text;
}

// What the stages did, and what rules left out while they ran.
void printCounts(const pipeline::Frame& frame) {
    say("\nCounts\n");
    for (const pipeline::StageId stage : pipeline::kStages) {
        if (!frame.run(stage).counts.empty())
            say("{} {:<22} {}\n", index(stage) + 1, stageInfo(stage).name, frame.run(stage).counts);
        for (const pipeline::Tally& tally : frame.run(stage).tallies) {
            say("    {:<20} {}", tally.what, tally.done);
            if (tally.leftOut > 0) say(", {} left out [{}]", tally.leftOut, name(*tally.rule));
            say("\n");
        }
    }
}

// Buffers that are not there after this plan, with the reason.
std::vector<std::pair<std::string, std::string>> buffersLeftOut(const pipeline::Scene& scene,
                                                                const WantedFrame& wanted) {
    std::vector<std::pair<std::string, std::string>> left;
    if (!wanted.buffers.empty()) return left;  // what was named is computed
    for (const pipeline::BufferInfo& info : pipeline::bufferTable())
        if (const std::string why = whyUseless(scene, info.id); !why.empty())
            left.emplace_back(fmt::format("{}{}", info.name, info.perLight ? ".k" : ""), why);
    return left;
}

// All names of buffers, of stages and derived ones.
pipeline::Json buffersToJson(std::size_t lights) {
    pipeline::Json all = pipeline::Json::array();
    const auto add = [&](const std::vector<pipeline::BufferName>& names) {
        for (const pipeline::BufferName& name : names)
            all.push_back({{"name", name.text()}, {"meaning", bufferInfo(name.id).meaning}});
    };
    add(pipeline::allBuffers(lights));
    add(pipeline::allDerived(lights));
    return all;
}

// frame: nothing where none was run; counts: whether what it did is printed.
void printPlan(const pipeline::Scene& scene, const pipeline::Plan& plan, const WantedFrame& wanted,
               const pipeline::Frame* frame, bool counts) {
    const pipeline::Settings& settings = scene.settings;
    const auto choice = [&](const char* key) {
        const auto ref = findSetting(scene, key).value();
        return formatSetting(ref, ref.get(scene));
    };
    say("{}, {} × {}, {}, {}\n\n", scene.name, settings.width, settings.height, choice("precision"), choice("shading"));
    for (const pipeline::PlanStep& step : plan) {
        say("{} {:<22} {:<9} {}\n", index(step.stage) + 1, stageInfo(step.stage).name, name(step.action),
            reason(step.why, {}, step.rule));
        for (const pipeline::PlanPart& part : step.parts)
            say("    {:<20} {:<9} {}\n", part.name, name(part.action), reason(part.why, part.saves, part.rule));
    }
    const auto left = buffersLeftOut(scene, wanted);
    if (!left.empty()) say("\nBuffers left out unless asked for by name\n");
    for (const auto& [buffer, why] : left) say("    {:<20} {}\n", buffer, why);
    const auto remarks = frame ? frameRemarks(*frame) : sceneRemarks(scene);
    if (!remarks.empty()) say("\nRemarks\n");
    for (const pipeline::Remark& remark : remarks) say("    {:<20} {}\n", remark.about, remark.text);
    if (frame && counts) printCounts(*frame);
}

void printPlanAsJson(const pipeline::Scene& scene, const pipeline::Plan& plan, const WantedFrame& wanted,
                     const pipeline::Frame* frame, bool counts) {
    pipeline::Json left = pipeline::Json::array();
    for (const auto& [buffer, why] : buffersLeftOut(scene, wanted)) left.push_back({{"name", buffer}, {"why", why}});
    pipeline::Json json{{"scene", sceneToJson(scene)},
                        {"settings", settingsToJson(scene)},
                        {"remarks", frame ? remarksToJson(*frame) : remarksToJson(scene)},
                        {"plan", toJson(plan)},
                        {"absent", left},
                        {"buffers", buffersToJson(scene.lights.size())}};
    if (frame && counts)
        for (const pipeline::StageId stage : pipeline::kStages) {
            json["plan"][index(stage)]["counts"] = frame->run(stage).counts;
            json["plan"][index(stage)]["tallies"] = toJson(frame->run(stage).tallies);
        }
    say("{}\n", json.dump(2));
}

// The frame up to its polygons' verdicts, which say why nothing would be seen; null where it does not fit into memory.
pipeline::FramePtr culledFrame(const std::shared_ptr<const pipeline::Scene>& scene, pipeline::FrameRequest request) {
    request.wanted = pipeline::setOf({pipeline::BufferId::PolygonsVerdict});
    request.until = pipeline::StageId::Cull;
    return checkMemory(*scene, request.wanted, request.until).empty() ? runFrame(scene, request, nullptr) : nullptr;
}

int runPlan(const PlanOptions& options) {
    const Interrupt interrupt;
    int status = kDone;
    const auto scene = loadScene(options.scene, interrupt.token(), status);
    if (!scene) return status;
    const auto wanted = wantedFrame(*scene, options.frame);
    if (!wanted) {
        printErrors(wanted.errors());
        return kWrongUsage;
    }
    pipeline::FrameRequest request = wanted->request;
    request.stop = interrupt.token();
    const auto print = options.json ? printPlanAsJson : printPlan;
    if (options.counts && !fits(*scene, request, options.scene, status)) return status;
    const pipeline::FramePtr frame = options.counts ? runFrame(scene, request, nullptr) : culledFrame(scene, request);
    if (request.stop.stop_requested()) {
        tell("Cancelled.\n");
        return kInterrupted;
    }
    print(*scene, options.counts ? frame->plan() : makePlan(*scene, wanted->request, nullptr), *wanted, frame.get(),
          options.counts);
    return kDone;
}

}  // namespace

void declarePlan(CLI::App& program, const CliHost&, int& status) {
    const auto options = std::make_shared<PlanOptions>();
    CLI::App* command = program.add_subcommand("plan", "Print what will run, what is left out, and why");
    declareSceneArgument(*command, options->scene);
    declareFrameArgument(*command, options->frame);
    auto* counts =
        command->add_flag("--counts", options->counts, "Run the frame, and print what it did and left out in counts");
    command->get_option("--threads")->needs(counts);
    command->add_flag("--json", options->json, "Print JSON, also all settings and the names of all buffers");
    command->callback([options, &status] { status = runPlan(*options); });
}

}  // namespace app
