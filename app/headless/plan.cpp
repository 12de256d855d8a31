#include "app/headless/plan.h"

#include "pipeline/export/json/json.h"
#include "pipeline/plan/memory_limit.h"
#include "pipeline/plan/needs.h"
#include "pipeline/plan/scene_remarks.h"
#include "pipeline/run/frame_remarks.h"
#include "pipeline/run/runner.h"
#include "pipeline/scene/settings_table.h"

namespace app {

namespace {

// "k_s is 0 in every material. Saves a power a point. [specular]"
std::string reason(std::string text, const std::string& saves, std::optional<pipeline::Rule> rule) {
    if (!saves.empty()) text += fmt::format(" Saves {}.", saves);
    if (rule) text += fmt::format(" [{}]", name(*rule));
    return text;
}

// What the stages did, and what rules left out while they ran.
void printCounts(const pipeline::Frame& frame, const CommandHost& host) {
    host.say("\nCounts\n");
    for (const pipeline::StageId stage : pipeline::kStages) {
        if (!frame.run(stage).counts.empty())
            host.say("{} {:<22} {}\n", index(stage) + 1, stageInfo(stage).name, frame.run(stage).counts);
        for (const pipeline::Tally& tally : frame.run(stage).tallies) {
            host.say("    {:<20} {}", tally.what, tally.done);
            if (tally.leftOut > 0) host.say(", {} left out [{}]", tally.leftOut, name(*tally.rule));
            host.say("\n");
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
               const pipeline::Frame* frame, bool counts, const CommandHost& host) {
    const pipeline::Settings& settings = scene.settings;
    const auto choice = [&](const char* key) {
        const auto ref = findSetting(scene, key).value();
        return formatSetting(ref, ref.get(scene));
    };
    host.say("{}, {} × {}, {}, {}\n\n", scene.name, settings.width, settings.height, choice("precision"),
             choice("shading"));
    for (const pipeline::PlanStep& step : plan) {
        host.say("{} {:<22} {:<9} {}\n", index(step.stage) + 1, stageInfo(step.stage).name, name(step.action),
                 reason(step.why, {}, step.rule));
        for (const pipeline::PlanPart& part : step.parts)
            host.say("    {:<20} {:<9} {}\n", part.name, name(part.action), reason(part.why, part.saves, part.rule));
    }
    const auto left = buffersLeftOut(scene, wanted);
    if (!left.empty()) host.say("\nBuffers left out unless asked for by name\n");
    for (const auto& [buffer, why] : left) host.say("    {:<20} {}\n", buffer, why);
    const auto remarks = frame ? frameRemarks(*frame) : sceneRemarks(scene);
    if (!remarks.empty()) host.say("\nRemarks\n");
    for (const pipeline::Remark& remark : remarks) host.say("    {:<20} {}\n", remark.about, remark.text);
    if (frame && counts) printCounts(*frame, host);
}

void printPlanAsJson(const pipeline::Scene& scene, const pipeline::Plan& plan, const WantedFrame& wanted,
                     const pipeline::Frame* frame, bool counts, const CommandHost& host) {
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
    host.say("{}\n", json.dump(2));
}

// The frame up to its polygons' verdicts, which say why nothing would be seen; null where it does not fit into memory.
pipeline::FramePtr culledFrame(const std::shared_ptr<const pipeline::Scene>& scene, pipeline::FrameRequest request) {
    request.wanted = pipeline::setOf({pipeline::BufferId::PolygonsVerdict});
    request.until = pipeline::StageId::Cull;
    return checkMemory(*scene, request.wanted, request.until).empty() ? runFrame(scene, request, nullptr) : nullptr;
}

}  // namespace

int plan(const std::shared_ptr<const pipeline::Scene>& scene, const PlanOptions& options, const CommandHost& host) {
    const auto wanted = wantedFrame(*scene, options.frame);
    if (!wanted) return host.refuse(wanted.errors(), kWrongUsage);
    pipeline::FrameRequest request = wanted->request;
    request.stop = host.stop;
    const auto print = options.json ? printPlanAsJson : printPlan;
    if (int status = kDone; options.counts && !host.fits(*scene, request, status)) return status;
    const pipeline::FramePtr frame = options.counts ? runFrame(scene, request, nullptr) : culledFrame(scene, request);
    if (request.stop.stop_requested()) return host.cancelled();
    print(*scene, options.counts ? frame->plan() : makePlan(*scene, wanted->request, nullptr), *wanted, frame.get(),
          options.counts, host);
    return kDone;
}

}  // namespace app
