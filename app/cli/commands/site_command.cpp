#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/cli/arguments/live_argument.h"
#include "app/cli/arguments/output_argument.h"
#include "app/cli/commands.h"
#include "app/cli/interrupt.h"
#include "app/cli/message.h"
#include "app/cli/progress_printer.h"
#include "lessons/pages/site.h"
#include "pipeline/core/text.h"
#include "pipeline/export/folder/size_text.h"
#include "pipeline/export/folder/staging.h"

namespace app {

namespace {

int exportSite(const std::string& folder, bool force, const CliHost& host) {
    constexpr const char* kIndex = "index.html";
    if (!mayWriteInto(folder, {kIndex}, kIndex, force)) return kCouldNotWrite;
    const Interrupt interrupt;
    const auto parts = lessons::liveParts(lessons::LiveKind::Site);
    if (!parts) {
        printErrors(parts.errors());
        return kCouldNotWrite;
    }
    ProgressPrinter progress("pages");
    const auto site = lessons::makeSite(
        *parts, host.drawCueView, interrupt.token(),
        [&](std::size_t done, std::size_t all, const std::string& what) { progress.show(done, all, what); });
    progress.end();
    if (interrupt.asked()) return tellCancelled();
    if (!site) {
        printErrors(site.errors());
        return kBadInput;
    }
    for (const std::string& line : site->leftOut) tell("left out: {}\n", line);
    std::vector<std::string> names;
    for (const auto& [name, text] : site->files) names.push_back(name);
    if (!mayWriteInto(folder, names, kIndex, force)) return kCouldNotWrite;
    const auto written = pipeline::writeFiles(site->files, folder);
    if (!written) {
        printErrors(written.errors());
        return kCouldNotWrite;
    }
    std::size_t bytes = 0;
    for (const auto& [name, text] : site->files) bytes += text.size();
    tell("{}: {}, {}. Open {} in a browser.\n", folder, pipeline::plural(std::int64_t(site->files.size()), "file"),
         pipeline::sizeText(bytes), (std::filesystem::path(folder) / kIndex).string());
    return kDone;
}

// The program in one page, for readers without Linux.
int exportOne(const std::string& file) {
    if (isNoFile(file)) {
        tell("shadescope site: with --one, -o needs the name of a file, as shadescope.html\n");
        return kWrongUsage;
    }
    if (!mayWriteTo(file)) return kCouldNotWrite;
    const Interrupt interrupt;
    const auto parts = lessons::liveParts(lessons::LiveKind::Whole);
    if (!parts) {
        printErrors(parts.errors());
        return kCouldNotWrite;
    }
    ProgressPrinter progress("pages");
    const auto page = lessons::makeWholePage(
        *parts, interrupt.token(),
        [&](std::size_t done, std::size_t all, const std::string& what) { progress.show(done, all, what); });
    progress.end();
    return writePage(page, file, interrupt);
}

}  // namespace

void declareSite(CLI::App& program, const CliHost& host, int& status) {
    CLI::App* command = program.add_subcommand("site", "Write everything that a browser can show, for a course");
    command->require_subcommand(1);
    CLI::App* write = command->add_subcommand(
        "export", "Write an index, all lessons and scenes live, the lectures and the manual into a folder");
    const auto folder = std::make_shared<std::string>();
    declareFolder(*write, *folder, "The folder to write into, made when it is missing")
        ->type_name("DIR|PAGE.html")
        ->required();
    const auto force = std::make_shared<bool>(false), one = std::make_shared<bool>(false);
    declareForce(*write, *force);
    write->add_flag("--one", *one, "Write one page that is the program in any browser, into the file -o");
    write->callback([=, &host, &status] { status = *one ? exportOne(*folder) : exportSite(*folder, *force, host); });
}

}  // namespace app
