#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <optional>

#include "app/cli/arguments/cue_check.h"
#include "app/cli/arguments/live_argument.h"
#include "app/cli/arguments/output_argument.h"
#include "app/cli/arguments/scene_argument.h"
#include "app/cli/commands.h"
#include "app/cli/interrupt.h"
#include "app/cli/message.h"
#include "app/cli/progress_printer.h"
#include "lessons/pages/talk_page.h"
#include "lessons/state/state_scene.h"
#include "pipeline/core/printable.h"
#include "pipeline/core/text.h"

namespace app {

namespace {

// What of the cues does not fit their scenes, each with its cue's name; nobody looks at them before they are given.
pipeline::Errors cueErrors(const lessons::CueList& list, const std::filesystem::path& file,
                           const pipeline::Stop& stop) {
    const std::filesystem::path folder = file.parent_path();
    pipeline::Errors errors;
    for (const lessons::Cue& cue : list.cues) {
        if (stop.stop_requested()) return errors;
        const auto scene = lessons::sceneOf(cue.state, folder, {{}, stop});
        pipeline::Errors found = scene ? checkCue(cue.state, *scene, folder) : scene.errors();
        if (cue.ask && &cue == &list.cues.back())
            found.push_back({{}, "asks and is the last cue", "a cue after it, which is the answer"});
        for (pipeline::Error& error : found) {
            if (error.where.file.empty()) error.where.file = file.string();
            error.found = "cue " + pipeline::inQuotes(cue.name) + ": " + error.found;
            errors.push_back(std::move(error));
        }
    }
    return errors;
}

// The list, all of whose cues fit their scenes; nothing, told of and with the status, where some do not or it was stopped.
std::optional<lessons::CueList> rightTalk(const std::string& cues, const Interrupt& interrupt, int& status) {
    auto list = lessons::readCueFile(cues, interrupt.token());
    const pipeline::Errors errors = list ? cueErrors(*list, cues, interrupt.token()) : list.errors();
    if (interrupt.asked()) {
        status = tellCancelled();
        return {};
    }
    if (errors.empty()) return std::move(list).value();
    printErrors(errors);
    status = kBadInput;
    return {};
}

int checkTalk(const std::string& named) {
    const Interrupt interrupt;
    const std::string cues = lessons::cueFileAt(named).string();
    int status = kDone;
    const auto list = rightTalk(cues, interrupt, status);
    if (!list) return status;
    for (std::size_t i = 0; i < list->cues.size(); ++i)
        if (list->cues[i].state.algorithm && asking(*list, i))
            say("cue {}: the algorithm stays hidden; the choices are in its place.\n",
                pipeline::inQuotes(pipeline::escapedControls(list->cues[i].name)));
    const auto questions = std::ranges::count_if(list->cues, [](const auto& cue) { return cue.ask.has_value(); });
    say("{}: {} and {} are right.\n", pipeline::escapedControls(list->title.empty() ? cues : list->title),
        pipeline::plural(std::int64_t(list->cues.size()), "cue"), pipeline::plural(questions, "question"));
    return kDone;
}

int exportTalk(const std::string& named, const std::string& file, const CliHost& host) {
    if (!host.drawCueView) {
        tell("shadescope present export: this build has no window, and draws no views\n");
        return kWrongUsage;
    }
    if (isNoFile(file)) {
        tell("shadescope present export: -o needs the name of a file, as talk.html\n");
        return kWrongUsage;
    }
    if (!mayWriteTo(file)) return kCouldNotWrite;
    const Interrupt interrupt;
    const std::filesystem::path cues = lessons::cueFileAt(named);
    const std::filesystem::path folder = cues.parent_path();
    int status = kDone;
    const auto list = rightTalk(cues.string(), interrupt, status);
    if (!list) return status;
    const auto parts = lessons::talkParts();
    if (!parts) {
        printErrors(parts.errors());
        return kCouldNotWrite;
    }
    ProgressPrinter progress("cues");
    const auto page = lessons::makeTalkPage(*list, folder, *parts, host.drawCueView, interrupt.token(),
                                            [&](std::size_t done) { progress.show(done, list->cues.size()); });
    progress.end();
    if (page)
        for (const std::string& line : page->leftOut) tell("left out: {}\n", line);
    return writePage(page ? pipeline::Result<std::string>(page->html) : page.errors(), file, interrupt);
}

}  // namespace

// Without a subcommand its help alone: main opens the window.
void declarePresent(CLI::App& program, const CliHost& host, int& status) {
    CLI::App* command =
        program.add_subcommand("present", "Open a cue list in the window, as a talk, or write it as a page");
    struct Options {
        std::string cues, file;
        bool check = false;
    };
    const auto options = std::make_shared<Options>();
    auto* list = command->add_option("FILE", options->cues,
                                     "A cue list, or lecture1, lecture2 or tour; FILE:CUE begins with another cue than "
                                     "the first, by its name or number");
    list->type_name("[:CUE]");
    command
        ->add_flag("--check", options->check,
                   "Check every cue against its scene, and that each question has an answer; opens no window")
        ->needs(list);
    command->callback([options, &status] {
        if (options->check) status = checkTalk(options->cues);
    });
    CLI::App* write = command->add_subcommand(
        "export",
        "Write the talk as one HTML file that any browser shows: pictures, captions, notes, keys of clickers");
    write->add_option("CUES", options->cues, "A cue list")->required();
    write->add_option("-o,--output", options->file, "The HTML file to write")->required()->type_name("FILE");
    write->callback([options, &host, &status] { status = exportTalk(options->cues, options->file, host); });
}

}  // namespace app
