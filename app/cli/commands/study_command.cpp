#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>

#include "app/cli/arguments/error_argument.h"
#include "app/cli/arguments/frame_argument.h"
#include "app/cli/arguments/output_argument.h"
#include "app/cli/arguments/scene_argument.h"
#include "app/cli/commands.h"
#include "app/cli/commands/class_job.h"
#include "app/cli/commands/study_folder.h"
#include "app/cli/commands/study_job.h"
#include "app/cli/message.h"
#include "pipeline/core/text.h"
#include "pipeline/export/study/study_files.h"
#include "pipeline/export/study/study_pictures.h"
#include "pipeline/formats/text/text_scanner.h"
#include "pipeline/scene/shape_stop.h"

namespace app {

namespace {

constexpr std::size_t kPictures = 4;    // of points on the front, in the report
constexpr std::size_t kMostParts = 64;  // of --commands

struct StudyOptions {
    SceneArgument scene;
    std::vector<std::string> sweeps;
    std::string folder, error, shard, commands;
    double errorLimit = 0, timeLimit = 0;
    int threads = 1, warmups = 2, repeats = 20, processes = 3;
    bool restart = false, json = false, partial = false, force = false;
    std::string timesInto, timesOf;  // of a process that takes times for another one
    std::vector<std::string> parts;  // of study merge
};

// "3/16": the third of sixteen.
std::optional<glm::ivec2> parseShard(const std::string& text) {
    if (text.empty()) return glm::ivec2(1, 1);
    const auto pair = parsePair(text, '/');
    if (!pair || pair->x < 1 || pair->y < pair->x || pair->y > int(pipeline::kMaxStudyPoints)) return std::nullopt;
    return pair;
}

// What the same study takes as arguments, for a process that takes its times.
std::vector<std::string> argumentsOf(const StudyOptions& options) {
    std::vector<std::string> arguments{"study", options.scene.scene};
    const auto add = [&](const char* name, const std::string& value) {
        arguments.insert(arguments.end(), {name, value});
    };
    for (const std::string& set : options.scene.set) add("--set", set);
    if (!options.scene.size.empty()) add("--size", options.scene.size);
    if (options.scene.views.camera) add("--camera", std::to_string(*options.scene.views.camera));
    if (options.scene.views.lights) add("--lights", "file");
    if (options.scene.noLeaveOut) arguments.emplace_back("--no-leave-out");
    for (const std::string& sweep : options.sweeps) add("--sweep", sweep);
    if (!options.shard.empty()) add("--shard", options.shard);
    add("-o", options.folder);
    add("--threads", std::to_string(options.threads));
    add("--warm-up", std::to_string(options.warmups));
    add("--repeat", std::to_string(options.repeats));
    return arguments;
}

int wrongUsage(const std::string& message) {
    tell("shadescope study: {}\n", message);
    return kWrongUsage;
}

// Of a part the one file, else all that reportStudy() writes; the index is the last.
std::vector<std::string> filesOf(const pipeline::StudyRequest& request) {
    if (request.shards > 1) return {studyFile({}, request).string()};
    return pipeline::studyFiles();
}

// A command for each part, for GNU parallel or an array of jobs.
int writeStudyCommands(const StudyOptions& options, std::size_t points) {
    const std::size_t parts = std::min(points, kMostParts);
    std::vector<std::vector<std::string>> commands;
    for (std::size_t i = 0; i < parts; ++i) {
        StudyOptions part = options;
        part.shard = fmt::format("{}/{}", i + 1, parts);
        commands.push_back(argumentsOf(part));
        commands.back().insert(commands.back().end(), {"--processes", std::to_string(options.processes)});
        if (!options.error.empty()) commands.back().insert(commands.back().end(), {"--error", options.error});
        if (options.restart) commands.back().emplace_back("--restart");
        if (options.force) commands.back().emplace_back("--force");
    }
    if (const auto written = writeCommands(options.commands, commands); !written) {
        printErrors(written.errors());
        return kCouldNotWrite;
    }
    say("{} in {}; then shadescope study merge {}/study-*-of-{}.json -o {}\n",
        pipeline::plural(std::int64_t(parts), "command"), options.commands, options.folder, parts, options.folder);
    return kDone;
}

int runStudyCommand(const StudyOptions& options) {
    if (options.scene.scene.empty()) return wrongUsage("SCENE is missing");
    if (options.folder.empty()) return wrongUsage("-o needs the name of a folder");
    if (options.sweeps.empty()) {
        std::string names;
        for (const pipeline::NamedSweep& named : pipeline::namedSweeps())
            names += fmt::format("\n  {:<12} {}", named.name, named.meaning);
        return wrongUsage("--sweep is missing: KEY=VALUE,VALUE,... or one of" + names);
    }
    const auto shard = parseShard(options.shard);
    if (!shard)
        return wrongUsage(
            fmt::format("--shard is {}, expected I/N with I from 1 to N", pipeline::inQuotes(options.shard)));
    const char* const ofReport = options.json             ? "--json"
                                 : options.errorLimit > 0 ? "--within"
                                 : options.timeLimit > 0  ? "--in"
                                                          : nullptr;
    if (shard->y > 1 && ofReport)
        return wrongUsage(fmt::format(
            "{} does not go with --shard: a part of a study has no report; give it to study merge", ofReport));

    const Interrupt interrupt;
    int status = kDone;
    StudyOrder job;
    job.request.scene = loadScene(options.scene, interrupt.token(), status);
    if (!job.request.scene) return status;
    const pipeline::ShapeStop shapes(interrupt.token());  // of points, whose settings make theirs
    auto sweep = parseSweeps(*job.request.scene, options.sweeps);
    if (interrupt.asked()) {
        tell("Cancelled.\n");
        return kInterrupted;
    }
    if (!sweep) {
        printErrors(sweep.errors());
        return kWrongUsage;
    }
    job.request.sweep = std::move(sweep).value();
    if (!options.error.empty()) {
        job.request.choice = parseChoice(options.error);
        if (!job.request.choice)
            return wrongUsage(fmt::format("--error is {}, expected BUFFER:MEASURE or BUFFER:MEASURE:KIND",
                                          pipeline::inQuotes(options.error)));
        if (const std::string why = whyNoError(*job.request.scene, *job.request.choice); !why.empty())
            return wrongUsage(fmt::format("--error {}: {}", pipeline::inQuotes(options.error), why));
    }
    if (!options.commands.empty()) return writeStudyCommands(options, pointCount(job.request.sweep.axes));
    job.request.threads = options.threads, job.request.warmups = options.warmups, job.request.repeats = options.repeats;
    job.request.shard = std::size_t(shard->x - 1), job.request.shards = std::size_t(shard->y);
    if (!options.timesInto.empty()) return takeTimes(job.request, options.timesInto, options.timesOf, interrupt);

    job.processes = options.processes, job.folder = options.folder, job.restart = options.restart;
    job.arguments = argumentsOf(options);
    if (const auto files = filesOf(job.request); !mayWriteInto(options.folder, files, files.back(), options.force))
        return kCouldNotWrite;
    auto report = runStudy(job, interrupt, status);
    if (!report) return status;
    if (job.request.shards > 1) {
        const auto file = studyFile(job.folder, job.request);
        if (const auto written = writeJson(*report, file); !written) {
            printErrors(written.errors());
            return kCouldNotWrite;
        }
        tell("{} of {} points are in {}\n", report->points.size(), pointCount(report->axes), file.string());
    } else {
        const auto pictures = frontPictures(job.request, *report, kPictures, interrupt.token());
        if (interrupt.asked()) return studyCancelled(job);
        status = reportStudy(*report, {options.errorLimit, options.timeLimit}, pictures, options.folder, options.json);
    }
    std::error_code ignored;
    if (status == kDone || status == kAnswerIsNo) std::filesystem::remove(partFile(job.folder, job.request), ignored);
    return status;
}

int runMerge(const StudyOptions& options) {
    if (options.folder.empty()) return wrongUsage("-o needs the name of a folder");
    const std::vector<std::string> files = pipeline::studyFiles();
    if (!mayWriteInto(options.folder, files, files.back(), options.force)) return kCouldNotWrite;
    std::vector<pipeline::StudyReport> parts;
    for (const std::string& file : options.parts) {
        auto part = readStudy(file);
        if (!part) {
            printErrors(part.errors());
            return kBadInput;
        }
        parts.push_back(std::move(part).value());
    }
    const auto merged = mergeStudies(std::move(parts));
    if (!merged) {
        printErrors(merged.errors());
        return kBadInput;
    }
    const std::size_t missing = missingPoints(*merged);
    if (missing > 0)
        tell("{} of {} points are missing: a part of the study has not been given.{}\n", missing,
             pointCount(merged->axes), options.partial ? "" : " With --partial the exit status does not say so.");
    const int status = reportStudy(*merged, {options.errorLimit, options.timeLimit}, {}, options.folder, options.json);
    return status == kDone && missing > 0 && !options.partial ? kAnswerIsNo : status;
}

// What is wrong with a limit, if anything.
std::string refuseLimit(const std::string& text) {
    const auto limit = pipeline::parseNumber(text);  // NaN and infinity are none
    if (limit && *limit > 0) return {};
    return fmt::format("found {}, expected a number above 0", pipeline::inQuotes(text));
}

void declareReport(CLI::App& command, StudyOptions& options) {
    declareFolder(command, options.folder, "The folder to write into; made when it is missing")->required();
    declareForce(command, options.force);
    command
        .add_option("--within", options.errorLimit,
                    "Name the cheapest setting with at most this error; status 1 where there is none")
        ->type_name("ERROR")
        ->check(refuseLimit);
    command
        .add_option("--in", options.timeLimit, "Name the best setting within this time; status 1 where there is none")
        ->type_name("MS")
        ->check(refuseLimit);
    command.add_flag("--json", options.json, "Print the whole study as JSON instead of a table");
}

}  // namespace

void declareStudy(CLI::App& program, const CliHost&, int& status) {
    const auto options = std::make_shared<StudyOptions>();
    CLI::App* command = program.add_subcommand("study", "Measure error against run time over a sweep of settings");
    declareSceneArgument(*command, options->scene, SceneArgument::Need::Maybe);  // merge stands in its place
    declareReport(*command, *options);
    std::vector<std::string_view> names;
    for (const pipeline::NamedSweep& named : pipeline::namedSweeps()) names.push_back(named.name);
    command
        ->add_option("--sweep", options->sweeps,
                     fmt::format("KEY=VALUE,VALUE,... or KEY=FIRST..LAST*FACTOR, once for each setting; or a "
                                 "ready-made sweep: {}",
                                 fmt::join(names, ", ")))
        ->type_name("SWEEP REQUIRED")  // said in words of its own, with the ready-made ones, where it is missing
        ->allow_extra_args(false);
    command->add_option("--error", options->error, "The error to plot, as in \"normal:mean angle:model\"")
        ->type_name("BUFFER:MEASURE:KIND");
    command->add_option("--threads", options->threads, "Threads of the frames whose time is taken; 0: all")
        ->type_name("N")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
    const auto number = [&](const char* name, int& value, int least, const char* meaning) {
        command->add_option(name, value, meaning)
            ->type_name("N")
            ->check(CLI::Range(least, 100000))
            ->capture_default_str();
    };
    number("--repeat", options->repeats, 1, "Frames of every point that are measured, in each process");
    number("--warm-up", options->warmups, 0, "Frames before them that are not");
    number("--processes", options->processes, 1, "Processes that take the times one after the other");
    command->add_option("--shard", options->shard, "Only the I-th of N parts of the points; join them by study merge")
        ->type_name("I/N");
    command
        ->add_option("--commands", options->commands,
                     "Write one command a line instead of running, each a part of the study; join them by study merge")
        ->type_name("FILE")
        ->excludes("--shard");
    command->add_flag("--restart", options->restart,
                      "Begin anew where an earlier study of this folder was interrupted");
    command->add_option("--times-into", options->timesInto)->group("");  // of the processes that take times
    command->add_option("--times-of", options->timesOf)->group("");

    const auto mergeOptions = std::make_shared<StudyOptions>();
    CLI::App* merge = command->add_subcommand("merge", "Join the parts of a study that was shared out");
    merge->add_option("FILE", mergeOptions->parts, "study-I-of-N.json, or study.json of the same study")
        ->required()
        ->type_name("");
    declareReport(*merge, *mergeOptions);
    merge->add_flag("--partial", mergeOptions->partial, "Allow parts to be missing, which otherwise is status 1");
    // The folder is this one's then.
    merge->preparse_callback([command](std::size_t) { command->get_option("--output")->required(false); });
    merge->callback([mergeOptions, &status] { status = runMerge(*mergeOptions); });
    command->callback([command, merge, options, &status] {
        if (!command->got_subcommand(merge)) status = runStudyCommand(*options);
    });
}

}  // namespace app
