#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/cli/commands.h"
#include "app/cli/cue_check.h"
#include "app/cli/interrupt.h"
#include "app/cli/live_argument.h"
#include "app/cli/message.h"
#include "app/cli/progress_printer.h"
#include "lessons/state/state_scene.h"
#include "lessons/talk_page.h"

namespace app {

namespace {

// What of the cues does not fit their scenes; nobody looks at them before they are given.
pipeline::Errors cueErrors(const lessons::CueList& list, const std::filesystem::path& folder) {
    pipeline::Errors errors;
    for (const lessons::Cue& cue : list.cues) {
        const auto scene = lessons::sceneOf(cue.state, folder);
        for (const pipeline::Error& error : scene ? checkCue(cue.state, *scene, folder) : scene.errors())
            errors.push_back(error);
    }
    return errors;
}

int exportTalk(const std::string& cues, const std::string& file, const CliHost& host) {
    if (!host.drawCueView) {
        tell("shadescope present export: this build has no window, and draws no views\n");
        return kWrongUsage;
    }
    if (isNoFile(file)) {
        tell("shadescope present export: -o needs the name of a file, as talk.html\n");
        return kWrongUsage;
    }
    const Interrupt interrupt;
    const std::filesystem::path folder = std::filesystem::path(cues).parent_path();
    const auto list = lessons::readCueFile(cues, interrupt.token());
    if (!list) {
        printErrors(list.errors());
        return kBadInput;
    }
    if (const pipeline::Errors errors = cueErrors(*list, folder); !errors.empty()) {
        printErrors(errors);
        return kBadInput;
    }
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
    command->add_option("FILE", "A cue list; FILE:CUE begins with another cue than the first, by its name or number")
        ->type_name("[:CUE]");
    struct Options {
        std::string cues, file;
    };
    const auto options = std::make_shared<Options>();
    CLI::App* write = command->add_subcommand(
        "export",
        "Write the talk as one HTML file that any browser shows: pictures, captions, notes, keys of clickers");
    write->add_option("CUES", options->cues, "A cue list")->required();
    write->add_option("-o,--output", options->file, "The HTML file to write")->required()->type_name("FILE");
    write->callback([options, &host, &status] { status = exportTalk(options->cues, options->file, host); });
}

}  // namespace app
