#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "app/cli/arguments/output_argument.h"
#include "app/cli/arguments/scene_argument.h"
#include "app/cli/commands.h"
#include "app/cli/interrupt.h"
#include "app/cli/message.h"
#include "app/cli/node_lines.h"
#include "app/cli/progress_printer.h"
#include "lessons/grading/grade.h"
#include "pipeline/core/text.h"

namespace app {

namespace {

struct GradeRequest {
    std::vector<std::string> files;
    std::string folder, sheets;
    double pass = 0;  // per cent
    bool force = false;
};

// Hand-ins that cannot be read outweigh students below the mark: they have not been looked at.
int runGrade(const GradeRequest& request) {
    const Interrupt interrupt;
    std::optional<lessons::SheetKeys> keys;
    if (!request.sheets.empty()) {
        auto read = lessons::readSheetKeys(request.sheets);
        if (!read) {
            printErrors(read.errors());
            return kBadInput;
        }
        keys = std::move(read).value();
    }
    const std::vector<std::filesystem::path> named(request.files.begin(), request.files.end());
    std::vector<std::filesystem::path> files = lessons::handInsOf(named);
    const std::vector<std::string> names = lessons::gradedFiles();
    if (!mayWriteInto(request.folder, names, names.back(), request.force)) return kCouldNotWrite;
    std::erase_if(files, [&](const std::filesystem::path& file) {  // the class as it was graded before is no hand-in
        std::error_code ignored;
        return std::ranges::any_of(names, [&](const std::string& name) {
            return std::filesystem::equivalent(file, std::filesystem::path(request.folder) / name, ignored);
        });
    });
    const auto graded = [&] {
        ProgressPrinter progress("grade");
        return lessons::grade(
            files, keys ? &*keys : nullptr, interrupt.token(),
            [&](std::size_t handIn) { progress.show(handIn, files.size(), "hand-ins"); }, nodeLines(interrupt.token()));
    }();
    if (interrupt.asked() || !graded) return tellCancelled();
    printErrors(graded->refused);
    const auto written = writeGraded(*graded, request.folder);
    if (!written) {
        printErrors(written.errors());
        return kCouldNotWrite;
    }
    std::size_t below = 0;
    for (const lessons::Graded::Student& student : graded->students)
        below += 100 * student.points < request.pass * student.full;
    std::string line = pipeline::plural(std::int64_t(graded->students.size()), "hand-in");
    if (request.pass > 0) line += fmt::format(", {} below {} %", below, pipeline::shortestText(request.pass));
    if (!graded->refused.empty()) line += fmt::format(", {} could not be read", graded->refused.size());
    say("{}; {} in {}\n", line, fmt::join(*written, ", "), request.folder);
    const std::vector<lessons::SharedMistake> shared = graded->shared;
    for (std::size_t i = 0; i < std::min<std::size_t>(3, shared.size()); ++i)
        say("  {}: {} of {}\n", shared[i].name, shared[i].students, graded->students.size());
    return !graded->refused.empty() ? kBadInput : below > 0 ? kAnswerIsNo : kDone;
}

}  // namespace

void declareGrade(CLI::App& program, const CliHost&, int& status) {
    CLI::App* command = program.add_subcommand(
        "grade", "Grade a class's hand-ins and name its misconceptions, as a table, JSON and a page");
    const auto request = std::make_shared<GradeRequest>();
    command
        ->add_option("FILES", request->files,
                     "Results of lessons, or answers to sheets, one file a student; its name is the student's. Of a "
                     "folder its files *.json")
        ->required();
    declareFolder(*command, request->folder, "The folder to write into, made when it is missing")->required();
    declareForce(*command, request->force);
    command->add_option("--sheets", request->sheets, "sheets.json, where the answers are to sheets")->type_name("FILE");
    command->add_option("--pass", request->pass, "Exit with 1 where somebody has fewer per cent of the points")
        ->check(CLI::Range(0.0, 100.0))
        ->type_name("PERCENT");
    command->callback([request, &status] { status = runGrade(*request); });
}

}  // namespace app
