#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <sstream>

#include "app/cli/commands.h"
#include "app/cli/compare_report.h"
#include "app/cli/foreign_program.h"
#include "app/cli/interrupt.h"
#include "app/cli/message.h"
#include "app/cli/output_argument.h"
#include "app/cli/scene_argument.h"
#include "app/cli/stage_starter.h"
#include "app/cli/watch.h"
#include "pipeline/compare/compare_html.h"
#include "pipeline/compare/compare_text.h"
#include "pipeline/compare/own_blocks.h"
#include "pipeline/compare/own_report.h"
#include "pipeline/compare/stage_blocks.h"
#include "pipeline/core/text.h"
#include "pipeline/export/staging.h"

namespace app {

namespace {

namespace foreign = pipeline::foreign;
namespace fs = std::filesystem;

struct StageArguments {
    std::string function;
    SceneArgument scene;
    std::string with, starter, output;
    bool json = false, watch = false;
};

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

// At most 160 pixels wide, with all that the picture shows.
pipeline::Scene smaller(pipeline::Scene scene) {
    constexpr int kWidth = 160;
    const int width = scene.settings.width;
    if (width <= kWidth) return scene;
    scene.settings.width = kWidth;
    scene.settings.height = std::max(1, scene.settings.height * kWidth / width);
    scene.camera.pixelsPerUnit *= double(kWidth) / width;
    return scene;
}

// Runs the program. Nothing after the reason went to standard error.
std::optional<ProgramOutput> output(const StageArguments& arguments, const std::string& input,
                                    const Interrupt& interrupt) {
    auto run = runProgram(arguments.with, input, {}, interrupt.token());
    if (!run) return printErrors(run.errors()), std::nullopt;
    if (run->failure.empty()) return std::move(run).value();
    if (!interrupt.asked()) tell("{}\n{}", run->failure, run->messages);
    return {};
}

// The program's results for some calls; nothing likewise.
std::optional<pipeline::OwnResults> ask(const StageArguments& arguments, const pipeline::OwnContract& contract,
                                        const std::vector<pipeline::OwnElement>& calls, const Interrupt& interrupt,
                                        ProgramOutput& run) {
    auto ran = output(arguments, foreign::callsText(contract, calls), interrupt);
    if (!ran) return {};
    run = std::move(*ran);
    auto results = foreign::readResults(contract, calls.size(), run.output);
    if (results) return std::move(results).value();
    tell("{}", run.messages);
    printErrors(results.errors());
    return {};
}

// Results that change what is stored lead to calls that the right function does not make, such as those of a z-buffer that is
// never written: they are asked in further runs.
constexpr int kRuns = 8;

int judgeOnce(const StageArguments& arguments, pipeline::OwnFunction function, const pipeline::Scene& scene,
              const Interrupt& interrupt) {
    const pipeline::OwnContract& contract = pipeline::ownContract(function);
    const auto record = std::make_shared<pipeline::OwnRecord>();
    pipeline::OwnFrame right = ownFrame(scene, function, record, interrupt.token());
    if (interrupt.asked()) return tellCancelled();
    if (right.unknown.empty()) {
        tell("{} is never called in this scene. It is called {}.\n", signatureOf(contract), contract.asked);
        return kBadInput;
    }
    foreign::OwnReport report;
    report.function = function, report.scene = arguments.scene.scene, report.command = arguments.with;
    report.elements = std::move(right.unknown);
    report.right = right.frame, report.isCut = right.isCut;
    ProgramOutput run;
    auto answered = ask(arguments, contract, report.elements, interrupt, run);
    if (interrupt.asked()) return tellCancelled();
    if (!answered) return kBadInput;
    report.mine = std::move(*answered);
    report.seconds = run.seconds, report.messages = run.messages;
    report.verdict = judgeOwn(contract, report.elements, report.mine);
    for (std::size_t i = 0; i < report.elements.size(); ++i) record->add(report.elements[i], report.mine[i]);
    for (int runs = 1; contract.picture && !arguments.output.empty(); ++runs) {
        pipeline::OwnFrame yours = ownFrame(scene, function, record, interrupt.token());
        if (interrupt.asked()) return tellCancelled();
        report.yours = yours.frame, report.notAsked = yours.unknown.size();
        if (yours.unknown.empty() || runs == kRuns || report.isCut) break;
        const auto more = ask(arguments, contract, yours.unknown, interrupt, run);
        if (!more) return interrupt.asked() ? tellCancelled() : kBadInput;
        for (std::size_t i = 0; i < yours.unknown.size(); ++i) record->add(yours.unknown[i], (*more)[i]);
    }
    const int status = report.verdict.isRight() ? kDone : kAnswerIsNo;
    if (!arguments.output.empty())
        if (const auto written = pipeline::writeWhole(arguments.output, ownHtml(report)); !written)
            return printErrors(written.errors()), kCouldNotWrite;
    if (arguments.json) {
        say("{}\n", ownJson(report, status).dump(2));
        return status;
    }
    for (const std::string& line : ownText(report)) say("{}\n", line);
    if (!report.messages.empty()) tell("{}", report.messages);
    return status;
}

// A whole stage: its outputs are compared as those of another renderer, beside the inputs that it was handed.
int compareStage(const StageArguments& arguments, const foreign::StageBlocks& blocks, const pipeline::Scene& scene,
                 const Interrupt& interrupt) {
    const pipeline::FramePtr frame = stageFrame(scene, blocks, interrupt.token());
    if (!frame) return tellCancelled();
    const auto run = output(arguments, stageText(*frame, blocks), interrupt);
    if (interrupt.asked()) return tellCancelled();
    if (!run) return kBadInput;
    tell("{}", run->messages);
    auto in = readStage(*frame, blocks, run->output);
    if (!in) return printErrors(in.errors()), kBadInput;
    foreign::CompareOptions options;
    options.stop = interrupt.token();
    auto reference = foreign::makeReference(scene, {}, options.stop);
    if (!reference) return tellCancelled();
    const auto report = compareRenderer(scene, std::make_shared<const foreign::Reference>(std::move(*reference)),
                                        std::move(in).value(), arguments.with, options);
    if (interrupt.asked()) return tellCancelled();
    if (!report) return printErrors(report.errors()), kBadInput;
    const int status = report->agrees() ? kDone : kAnswerIsNo;
    if (!arguments.output.empty())
        if (const auto written = pipeline::writeWhole(arguments.output, reportHtml(*report, arguments.with)); !written)
            return printErrors(written.errors()), kCouldNotWrite;
    if (arguments.json)
        say("{}\n", reportJson(*report, status).dump(2));
    else
        sayReport(*report);
    return status;
}

int runStage(const StageArguments& arguments) {
    const auto function = pipeline::findOwn(arguments.function);
    const auto stage = pipeline::findStage(arguments.function);
    const foreign::StageBlocks* const blocks = stage ? foreign::stageBlocks(*stage) : nullptr;
    if (!function && !blocks)
        return wrongStage(fmt::format("no stage and no function is called {}; the nearest name is {}",
                                      pipeline::inQuotes(arguments.function),
                                      pipeline::nearest(arguments.function, names())));
    if (!function && !arguments.starter.empty()) return wrongStage("--starter writes functions, not whole stages");
    if (!arguments.starter.empty()) {
        if (arguments.output.empty()) return wrongStage("--starter needs -o with the name of a folder");
        const auto written = writeFunctionStarter(ownContract(*function), arguments.starter, arguments.output);
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
    const auto scene = std::make_shared<const pipeline::Scene>(of.size.empty() ? smaller(*whole) : *whole);
    pipeline::FrameRequest request;
    request.wanted = pipeline::setOf({pipeline::BufferId::Color, pipeline::BufferId::Normal});
    if (!fits(*scene, request, of, status)) return status;
    const auto once = [&] {
        return function ? judgeOnce(arguments, *function, *scene, interrupt)
                        : compareStage(arguments, *blocks, *scene, interrupt);
    };
    if (!arguments.watch) return once();
    return watch([&] { return stateOfFiles(foldersOf(arguments.with), arguments.output); }, once, interrupt);
}

}  // namespace

void declareStage(CLI::App& program, const CliHost&, int& status) {
    const auto arguments = std::make_shared<StageArguments>();
    CLI::App* command = program.add_subcommand(
        "stage", "Run your own function in the place of one of the pipeline's, and find its mistake");
    command
        ->add_option("FUNCTION", arguments->function, "A function of the manual's page \"Write the stage\": CalcNormal")
        ->required();
    declareSceneArgument(*command, arguments->scene, SceneArgument::Need::Maybe);
    command->add_option("--with", arguments->with, "Starts your program: \"python3 mine.py\"")->type_name("COMMAND");
    command->add_flag("--watch", arguments->watch, "Run again whenever your files change, until Ctrl+C");
    command->add_option("--starter", arguments->starter, "Write a program to complete into the folder -o")
        ->type_name("LANGUAGE")
        ->check(CLI::IsMember(starterLanguages()));
    declareFolder(*command, arguments->output,
                  "Write a page with your picture beside the right one; the folder of --starter")
        ->type_name("REPORT.html|DIR");
    command->add_flag("--json", arguments->json, "Print JSON");
    command->callback([arguments, &status] { status = runStage(*arguments); });
}

}  // namespace app
