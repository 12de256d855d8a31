#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/cli/arguments/output_argument.h"
#include "app/cli/arguments/scene_argument.h"
#include "app/cli/commands.h"
#include "app/cli/interrupt.h"
#include "app/cli/message.h"
#include "app/cli/progress_printer.h"
#include "lessons/grading/sheet.h"
#include "lessons/library.h"
#include "pipeline/core/text.h"

namespace app {

namespace {

struct SheetRequest {
    std::string lesson, folder;
    lessons::SheetOptions options;
    bool force = false;
};

int runSheet(const SheetRequest& request) {
    const std::filesystem::path folder = lessons::sheetTemplateAt(request.lesson);
    if (folder.empty()) {
        tell("{}: no lesson.md there, expected the folder of a lesson with \"vary\" in its header, or {}\n",
             request.lesson, fmt::join(lessons::sheetTemplateNames(), ", "));
        return kBadInput;
    }
    const auto made = lessons::readSheetTemplate(folder);
    if (!made) {
        printErrors(made.errors());
        return kBadInput;
    }
    if (!mayWriteInto(request.folder, lessons::sheetFiles(request.options.count), lessons::kSheetIndex, request.force))
        return kCouldNotWrite;
    const Interrupt interrupt;
    const auto sheets = [&] {
        ProgressPrinter progress("sheets");
        return makeSheets(*made, request.options, interrupt.token(),
                          [&](std::size_t sheet) { progress.show(sheet, request.options.count, "sheets"); });
    }();
    if (interrupt.asked()) return tellCancelled();
    if (!sheets) {
        printErrors(sheets.errors());
        return kBadInput;
    }
    const auto written = writeSheets(*sheets, *made, request.options, request.folder);
    if (!written) {
        printErrors(written.errors());
        return kCouldNotWrite;
    }
    printErrors(sheets->leftOut);
    tell("{} in {}, their keys in {}\n", pipeline::plural(std::int64_t(sheets->sheets.size()), "sheet"), request.folder,
         (std::filesystem::path(request.folder) / "keys").string());
    return kDone;
}

}  // namespace

void declareSheet(CLI::App& program, const CliHost&, int& status) {
    CLI::App* command = program.add_subcommand(
        "sheet", "Write variants of a lesson for paper, each with other numbers, and their keys");
    const auto request = std::make_shared<SheetRequest>();
    command->add_option("LESSON", request->lesson, "The folder of a lesson whose header says what varies, or light")
        ->required();
    declareFolder(*command, request->folder, "The folder to write into, made when it is missing")->required();
    declareForce(*command, request->force);
    command->add_option("--variants", request->options.count, "How many sheets")
        ->check(CLI::Range(1, 500))
        ->capture_default_str()
        ->type_name("N");
    command->add_option("--seed", request->options.seed, "Another seed gives other sheets; the same gives the same")
        ->capture_default_str()
        ->type_name("N");
    command
        ->add_option("--blank", request->options.blanks,
                     "How many numbers of tables and equations each page leaves blank")
        ->check(CLI::Range(0, 100))
        ->capture_default_str()
        ->type_name("N");
    command->callback([request, &status] { status = runSheet(*request); });
}

}  // namespace app
