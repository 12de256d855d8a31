#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <sstream>

#include "app/cli/arguments/output_argument.h"
#include "app/cli/arguments/scene_argument.h"
#include "app/cli/commands.h"
#include "app/cli/commands/compare_report.h"
#include "app/cli/commands/foreign_program.h"
#include "app/cli/commands/stage_course.h"
#include "app/cli/commands/stage_starter.h"
#include "app/cli/interrupt.h"
#include "app/cli/message.h"
#include "app/cli/watch.h"
#include "pipeline/compare/report/compare_html.h"
#include "pipeline/compare/report/compare_text.h"
#include "pipeline/compare/trial.h"
#include "pipeline/core/text.h"
#include "pipeline/export/folder/staging.h"

namespace app {

namespace {

namespace foreign = pipeline::foreign;
namespace fs = std::filesystem;

struct StageArguments {
    std::string function;
    SceneArgument scene;
    std::string with, starter, output, course;
    bool json = false, watch = false, force = false;
};

// In place of a language: ready assignments for a class.
constexpr const char* kAssignments = "course";

int wrongStage(const std::string& message) {
    tell("shadescope stage: {}\n", message);
    return kWrongUsage;
}

// Of functions and of stages.
std::vector<std::string> names() {
    std::vector<std::string> names;
    for (const pipeline::StageId stage : pipeline::kStages)
        if (foreign::stageBlocks(stage)) names.emplace_back(stageInfo(stage).name);
    for (std::size_t i = 0; i < pipeline::kOwnCount; ++i)
        names.emplace_back(pipeline::ownContract(pipeline::OwnFunction(i)).name);
    return names;
}

// Files that the command names: what somebody changes is one of them, or beside one of them.
std::vector<std::string> foldersOf(const std::string& command) {
    std::vector<std::string> folders;
    std::istringstream words(command);
    std::error_code failed;
    for (std::string word; words >> word;)
        if (fs::is_regular_file(word, failed)) {
            const fs::path parent = fs::path(word).parent_path();
            // An interpreter, such as /usr/bin/python3, is not what changes.
            if (parent.string().starts_with("/usr/") || parent.string().starts_with("/bin")) continue;
            folders.push_back(parent.empty() ? "." : parent.string());
        }
    if (folders.empty()) folders.emplace_back(".");
    return folders;
}

// The program that the command starts. messages: the end of what its last run wrote to standard error.
foreign::Program programOf(const std::string& command, const Interrupt& interrupt, std::string& messages) {
    return [&command, &interrupt, &messages](const std::string& input) {
        auto run = runProgram(command, input, {}, interrupt.token());
        if (run) messages = run->messages;
        return run;
    };
}

// Standard error of the program before what is wrong with it.
int tellWhyNot(const std::string& messages, const pipeline::Errors& errors, const Interrupt& interrupt) {
    if (interrupt.asked()) return tellCancelled();
    tell("{}", messages);
    printErrors(errors);
    return kBadInput;
}

// Writes the page, prints the result, gives the status.
template <class Report, class Html, class Data, class Text>
int show(const StageArguments& arguments, const Report& report, int status, Html html, Data data, Text text) {
    if (!arguments.output.empty())
        if (const auto written = pipeline::writeWhole(arguments.output, html(report)); !written)
            return printErrors(written.errors()), kCouldNotWrite;
    if (arguments.json)
        say("{}\n", data(report, status).dump(2));
    else
        text(report);
    return status;
}

int judgeOnce(const StageArguments& arguments, const foreign::FunctionTrial& trial, const Interrupt& interrupt) {
    std::string messages;
    auto report =
        trial.judge(programOf(arguments.with, interrupt, messages), !arguments.output.empty(), interrupt.token());
    if (!report) return tellWhyNot(messages, report.errors(), interrupt);
    foreign::OwnReport named = std::move(report).value();
    named.scene = arguments.scene.scene, named.command = arguments.with;
    const int status = named.verdict.isRight() ? kDone : kAnswerIsNo;
    return show(arguments, named, status, foreign::ownHtml, foreign::ownJson, [](const foreign::OwnReport& of) {
        for (const std::string& line : ownText(of)) say("{}\n", line);
        if (!of.messages.empty()) tell("{}", of.messages);
    });
}

// A whole stage: its outputs are compared as those of another renderer, beside the inputs that it was handed.
int judgeOnce(const StageArguments& arguments, const foreign::StageTrial& trial, const Interrupt& interrupt) {
    std::string messages;
    foreign::CompareOptions options;
    options.stop = interrupt.token();
    const auto report = trial.judge(programOf(arguments.with, interrupt, messages), arguments.with, options);
    if (!report) return tellWhyNot(messages, report.errors(), interrupt);
    tell("{}", messages);
    return show(
        arguments, *report, report->agrees() ? kDone : kAnswerIsNo,
        [&](const foreign::Report& of) { return reportHtml(of, arguments.with); }, foreign::reportJson, sayReport);
}

int runStage(const StageArguments& arguments) {
    if (!arguments.course.empty())
        return runStageCourse({arguments.course, arguments.function.empty() ? "." : arguments.function,
                               arguments.output, arguments.json, arguments.force});
    if (!arguments.starter.empty() && arguments.output.empty())
        return wrongStage("--starter needs -o with the name of a folder");
    if (arguments.starter == kAssignments) {
        const auto written = writeAssignments(arguments.output);
        if (!written) return printErrors(written.errors()), kCouldNotWrite;
        for (const std::string& file : *written) say("{}\n", file);
        return kDone;
    }
    if (arguments.function.empty()) return wrongStage("FUNCTION is missing");
    const auto function = pipeline::findOwn(arguments.function);
    const auto stage = pipeline::findStage(arguments.function);
    const foreign::StageBlocks* const blocks = stage ? foreign::stageBlocks(*stage) : nullptr;
    if (!function && !blocks)
        return wrongStage(fmt::format("no stage and no function is called {}; the nearest name is {}",
                                      pipeline::inQuotes(arguments.function),
                                      pipeline::nearest(arguments.function, names())));
    if (!arguments.starter.empty()) {
        const auto written = function
                                 ? writeFunctionStarter(ownContract(*function), arguments.starter, arguments.output)
                                 : writeStageStarter(*blocks, arguments.starter, arguments.output);
        if (!written) return printErrors(written.errors()), kCouldNotWrite;
        say("{}\n", *written);
        return kDone;
    }
    if (arguments.scene.scene.empty()) return wrongStage("SCENE is missing");
    if (arguments.with.empty()) return wrongStage("--with is missing: the command that starts your program");
    const SceneArgument& of = arguments.scene;
    const Interrupt interrupt;
    int status = kDone;
    const auto whole = loadScene(of, interrupt.token(), status);
    if (!whole) return status;
    const pipeline::Scene scene = of.size.empty() ? ownScene(*whole) : *whole;
    pipeline::FrameRequest request;
    request.wanted = pipeline::setOf({pipeline::BufferId::Color, pipeline::BufferId::Normal});
    if (!fits(scene, request, of, status)) return status;
    const auto every = [&](const auto& trial) {
        const auto run = [&] { return judgeOnce(arguments, trial, interrupt); };
        if (interrupt.asked()) return tellCancelled();
        if (!arguments.watch) return run();
        return watch([&] { return stateOfFiles(foldersOf(arguments.with), arguments.output); }, run, interrupt);
    };
    return function ? every(foreign::FunctionTrial(scene, *function, interrupt.token()))
                    : every(foreign::StageTrial(scene, *blocks, interrupt.token()));
}

}  // namespace

void declareStage(CLI::App& program, const CliHost&, int& status) {
    const auto arguments = std::make_shared<StageArguments>();
    CLI::App* command = program.add_subcommand(
        "stage", "Run your own function in the place of one of the pipeline's, and find its mistake");
    command->add_option("FUNCTION", arguments->function,
                        "A function of the manual's page \"Write the stage\": CalcNormal; or a stage");
    declareSceneArgument(*command, arguments->scene, SceneArgument::Need::Maybe);
    std::vector<std::string> starters = starterLanguages();
    starters.emplace_back(kAssignments);
    command->add_option("--with", arguments->with, "Starts your program: \"python3 mine.py\"")->type_name("COMMAND");
    command->add_flag("--watch", arguments->watch, "Run again whenever your files change, until Ctrl+C");
    command
        ->add_option("--starter", arguments->starter,
                     "Write a program to complete into the folder -o; course: six assignments for a class")
        ->type_name("LANGUAGE")
        ->check(CLI::IsMember(starters));
    declareFolder(*command, arguments->output,
                  "Write a page with your picture beside the right one; the folder of --starter and --course")
        ->type_name("REPORT.html|DIR");
    command->add_flag("--json", arguments->json, "Print JSON");
    const std::vector<CLI::Option*> notOfCourse = command->get_options([](const CLI::Option* option) {
        return !option->check_name("FUNCTION") && !option->check_name("--help") && !option->check_name("--output") &&
               !option->check_name("--json");
    });
    CLI::Option* course =
        command
            ->add_option("--course", arguments->course,
                         "Mark your programs, in a folder in place of FUNCTION, by the points of this "
                         "file")
            ->type_name("COURSE.toml");
    for (CLI::Option* option : notOfCourse) course->excludes(option);
    declareForce(*command, arguments->force)->needs(course);
    command->callback([arguments, &status] { status = runStage(*arguments); });
}

}  // namespace app
