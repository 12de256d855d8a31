#include <fmt/format.h>
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>
#include <thread>

#include "app/cli/arguments/frame_argument.h"
#include "app/cli/arguments/scene_argument.h"
#include "app/cli/commands.h"
#include "app/cli/commands/leave_out_bench.h"
#include "app/cli/commands/scaling_bench.h"
#include "app/cli/interrupt.h"
#include "app/cli/message.h"
#include "pipeline/core/sample.h"
#include "pipeline/export/json/json.h"
#include "pipeline/formats/scene_reader.h"
#include "pipeline/run/runner.h"
#include "pipeline/study/memory_share.h"

namespace app {

namespace {

struct BenchOptions {
    SceneArgument scene;
    FrameArgument frame{{"color"}, {}, 0};
    int warmups = 3;
    std::optional<int> repeated;  // --repeat
    bool json = false, leaveOut = false, scaling = false;
    int repeats() const { return repeated.value_or(scaling ? 5 : 20); }  // the frames of --scaling are many and long
};

// Milliseconds of every repetition.
struct Times {
    std::vector<double> frame;
    std::array<std::vector<double>, pipeline::kStageCount> stages;  // empty where a stage was left out
    pipeline::FramePtr last;
    double peakBytes = 0;  // of the process, before bandwidth was measured
    double bandwidth = 0;  // bytes a second, of a memset by as many threads
};

double peakMemory() {  // bytes
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return double(usage.ru_maxrss) * 1024;
}

// Each frame is computed from nothing. Nothing when interrupted.
std::optional<Times> measure(const std::shared_ptr<const pipeline::Scene>& scene, const pipeline::FrameRequest& request,
                             const BenchOptions& options) {
    Times times;
    for (int i = -options.warmups; i < options.repeats(); ++i) {
        times.last = runFrame(scene, request, nullptr);
        if (!times.last) return std::nullopt;
        if (i < 0) continue;
        times.frame.push_back(times.last->milliseconds());
        for (const pipeline::StageId stage : pipeline::kStages)
            if (times.last->plan()[index(stage)].action == pipeline::Action::Run)
                times.stages[index(stage)].push_back(times.last->run(stage).milliseconds);
    }
    times.peakBytes = peakMemory();
    times.bandwidth = pipeline::memsetBandwidth(request.threads);
    return times;
}

int threadsUsed(const BenchOptions& options) {
    return options.frame.threads > 0 ? options.frame.threads : static_cast<int>(std::thread::hardware_concurrency());
}

// share: of the frame's median.
std::string row(std::string_view what, const std::vector<double>& times, double share, const std::string& counts) {
    const pipeline::SampleSummary s = pipeline::summarize(times);
    const std::string interval =
        s.medianInterval ? fmt::format("{:.3f} to {:.3f}", s.medianInterval->first, s.medianInterval->second) : "";
    return fmt::format("{:<14} {:>9.3f} {:>9.3f} {:>9.3f} {:>6.1f} %   {:<20} {}\n", what, s.min, s.median, s.p95,
                       100 * share, interval, counts);
}

double shareOf(const std::vector<double>& stage, const Times& times) {
    const double frame = pipeline::summarize(times.frame).median;
    return frame > 0 ? pipeline::summarize(stage).median / frame : 0;
}

// A memset of the frame's buffers, as a part of the frame's time. Above 1 where tiles that nothing covers stay unwritten.
double shareOfMemset(const Times& times) {
    const double seconds = pipeline::summarize(times.frame).median / 1000, most = times.bandwidth * seconds;
    return most > 0 ? pipeline::bufferBytes(*times.last) / most : 0;
}

std::string tallyText(const pipeline::Tally& tally) {
    const std::string left = tally.leftOut > 0 ? fmt::format(", {} left out", tally.leftOut) : "";
    return fmt::format("    {:<20} {}{}\n", tally.what, tally.done, left);
}

void printTable(const Times& times, const BenchOptions& options) {
    const pipeline::Scene& scene = times.last->scene();
    say("{}, {} × {}, {} threads; {} frames from nothing after {} to warm up; ms\n\n", scene.name, scene.settings.width,
        scene.settings.height, threadsUsed(options), options.repeats(), options.warmups);
    say("{:<14} {:>9} {:>9} {:>9} {:>8}   {:<20} {}\n", "", "min", "median", "p95", "share", "median, 95 %", "");
    for (const pipeline::StageId stage : pipeline::kStages) {
        const std::string_view label = stageInfo(stage).name;
        const std::vector<double>& taken = times.stages[index(stage)];
        if (taken.empty()) {
            say("{:<14} {}: {}\n", label, name(pipeline::Action::LeaveOut), times.last->plan()[index(stage)].why);
            continue;
        }
        const pipeline::StageRun& run = times.last->run(stage);
        say("{}", row(label, taken, shareOf(taken, times), run.counts));
        for (const pipeline::Tally& tally : run.tallies) say("{}", tallyText(tally));
    }
    say("{}", row("frame", times.frame, 1, fmt::format("peak memory {:.1f} MB", times.peakBytes / 1e6)));
    const double bytes = pipeline::bufferBytes(*times.last);
    say("\nThe frame's buffers take {:.1f} MB. memset writes as much in {:.3f} ms ({:.1f} GB/s), {:.0f} % of the "
        "frame's "
        "time.\n",
        bytes / 1e6, 1000 * bytes / times.bandwidth, times.bandwidth / 1e9, 100 * shareOfMemset(times));
}

pipeline::Json summaryJson(const std::vector<double>& times) {
    const pipeline::SampleSummary s = pipeline::summarize(times);
    pipeline::Json json{{"min", s.min}, {"median", s.median}, {"p95", s.p95}, {"median_interval", nullptr}};
    if (s.medianInterval) json["median_interval"] = {s.medianInterval->first, s.medianInterval->second};
    return json;
}

void printJson(const Times& times, const BenchOptions& options) {
    pipeline::Json stages = pipeline::Json::array();
    for (const pipeline::StageId stage : pipeline::kStages) {
        const pipeline::PlanStep& step = times.last->plan()[index(stage)];
        pipeline::Json entry{{"stage", stageInfo(stage).name}, {"action", name(step.action)}, {"why", step.why}};
        if (!times.stages[index(stage)].empty()) {
            entry["milliseconds"] = summaryJson(times.stages[index(stage)]);
            entry["share"] = shareOf(times.stages[index(stage)], times);
            entry["counts"] = times.last->run(stage).counts;
            entry["tallies"] = pipeline::Json::array();
            for (const pipeline::Tally& tally : times.last->run(stage).tallies)
                entry["tallies"].push_back({{"what", tally.what}, {"done", tally.done}, {"left_out", tally.leftOut}});
        }
        stages.push_back(entry);
    }
    const pipeline::Json json{{"scene", sceneToJson(times.last->scene())},
                              {"settings", settingsToJson(times.last->scene())},
                              {"threads", threadsUsed(options)},
                              {"warmups", options.warmups},
                              {"repeats", options.repeats()},
                              {"milliseconds", summaryJson(times.frame)},
                              {"stages", stages},
                              {"peak_memory_bytes", times.peakBytes},
                              {"buffer_bytes", pipeline::bufferBytes(*times.last)},
                              {"memset_bytes_per_second", times.bandwidth},
                              {"share_of_memset", shareOfMemset(times)}};
    say("{}\n", json.dump(2));
}

// The scene that is named, or every built-in one.
int runLeaveOutBench(const BenchOptions& options) {
    const Interrupt interrupt;
    std::vector<std::string> names{options.scene.scene};
    if (options.scene.scene.empty()) {
        names.clear();
        for (const pipeline::BuiltInScene& scene : pipeline::builtInScenes()) names.push_back(scene.name);
    }
    std::vector<std::shared_ptr<const pipeline::Scene>> scenes;
    std::size_t nameWidth = 0;
    for (const std::string& name : names) {
        SceneArgument argument = options.scene;
        argument.scene = name;
        int status = kDone;
        scenes.push_back(loadScene(argument, interrupt.token(), status));
        if (!scenes.back()) return status;
        nameWidth = std::max(nameWidth, scenes.back()->name.size());
    }
    pipeline::Json rows = pipeline::Json::array();
    if (!options.json) printLeaveOutHead(nameWidth);
    for (const auto& scene : scenes) {
        const auto wanted = wantedFrame(*scene, options.frame);
        if (!wanted) {
            printErrors(wanted.errors());
            return kWrongUsage;
        }
        LeaveOutOptions measured{wanted->request, options.warmups, options.repeats()};
        measured.request.stop = interrupt.token();
        pipeline::Scene whole = *scene;
        whole.settings.leaveOut = false;
        int status = kDone;
        if (!fits(whole, measured.request, options.scene, status)) return status;
        const auto times = measureLeavingOut(*scene, measured);
        if (!times) {
            tell("Cancelled.\n");
            return kInterrupted;
        }
        if (options.json)
            rows.push_back(leaveOutJson(*times));
        else
            printLeaveOutRow(*times, nameWidth);
    }
    if (options.json) say("{}\n", rows.dump(2));
    return kDone;
}

int runScalingBench(const BenchOptions& options) {
    const Interrupt interrupt;
    const auto series = measureScaling({options.repeats(), options.frame.threads, interrupt.token()});
    if (!series) {
        tell("Cancelled.\n");
        return kInterrupted;
    }
    if (options.json)
        say("{}\n", scalingJson(*series).dump(2));
    else
        printScaling(*series);
    return kDone;
}

// What of a command line says nothing to --scaling, or null.
const char* notForScaling(const CLI::App& command) {
    for (const char* name :
         {"SCENE", "--set", "--size", "--no-leave-out", "--leave-out", "--buffers", "--until", "--warm-up"})
        if (command.count(name) > 0) return name;
    return nullptr;
}

// A frame without --buffers is timed up to its picture, or up to an end before it.
void endEarly(BenchOptions& options, const CLI::App& command) {
    const auto until = pipeline::findStage(options.frame.until);
    if (until && *until < pipeline::StageId::Shading && command.count("--buffers") == 0) options.frame.buffers.clear();
}

int runBench(BenchOptions options, const CLI::App& command) {
    if (const char* name = options.scaling ? notForScaling(command) : nullptr) {
        tell("{} does not go with --scaling, which measures whole frames of spheres of its own.\n", name);
        return kWrongUsage;
    }
    if (options.scaling) return runScalingBench(options);
    endEarly(options, command);
    if (options.leaveOut) return runLeaveOutBench(options);
    if (options.scene.scene.empty()) {
        tell("SCENE is required; --leave-out takes every built-in scene without it, --scaling its own.\n");
        return kWrongUsage;
    }
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
    if (!fits(*scene, request, options.scene, status)) return status;
    const auto times = measure(scene, request, options);
    if (!times) {
        tell("Cancelled.\n");
        return kInterrupted;
    }
    (options.json ? printJson : printTable)(*times, options);
    tellRemarks(*times->last);
    return kDone;
}

}  // namespace

void declareBench(CLI::App& program, const CliHost&, int& status) {
    const auto options = std::make_shared<BenchOptions>();
    CLI::App* command =
        program.add_subcommand("bench", "Measure the time of every stage and the frame, and the memory");
    declareSceneArgument(*command, options->scene);
    command->get_option("SCENE")->required(false);
    declareFrameArgument(*command, options->frame);
    command->add_option("--repeat", options->repeated, "Frames that are measured [20, with --scaling 5]")
        ->type_name("N")
        ->check(CLI::Range(1, 100000));
    command->add_option("--warm-up", options->warmups, "Frames before them that are not")
        ->type_name("N")
        ->check(CLI::Range(0, 100000))
        ->capture_default_str();
    command
        ->add_flag("--leave-out", options->leaveOut,
                   "Compare leaving out with running everything, in turns; without SCENE for every built-in scene")
        ->excludes("--no-leave-out");
    command->add_flag("--scaling", options->scaling,
                      "How time grows with polygons and with pixels: spheres of its own, no SCENE");
    command->add_flag("--json", options->json, "Print JSON");
    command->callback([options, command, &status] { status = runBench(*options, *command); });
}

}  // namespace app
