#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cstdlib>
#include <filesystem>

#include "app/cli/arguments/output_argument.h"
#include "app/cli/arguments/scene_argument.h"
#include "app/cli/commands.h"
#include "app/cli/commands/class_job.h"
#include "app/cli/commands/compare_report.h"
#include "app/cli/interrupt.h"
#include "app/cli/message.h"
#include "app/cli/progress_printer.h"
#include "app/cli/watch.h"
#include "pipeline/compare/compare_options.h"
#include "pipeline/compare/report/compare_html.h"
#include "pipeline/compare/report/compare_text.h"
#include "pipeline/core/text.h"
#include "pipeline/export/buffers/byte_file.h"
#include "pipeline/export/buffers/obj_kit.h"
#include "pipeline/export/folder/staging.h"
#include "pipeline/formats/built_in_scenes.h"
#include "pipeline/formats/scene_folder.h"
#include "pipeline/formats/scene_reader.h"
#include "pipeline/formats/text/text_scanner.h"
#include "pipeline/scene/any_exponent.h"

namespace app {

namespace foreign = pipeline::foreign;

namespace {

struct CompareArguments {
    SceneArgument scene;
    std::vector<std::string> paths, tolerances, without;
    std::string stage, output;
    int hints = 3;
    std::string starter;
    ClassRequest ofClass;
    bool strict = false, noKnown = false, json = false, watch = false;
};

int wrongCompare(const std::string& message) {
    tell("shadescope compare: {}\n", message);
    return kWrongUsage;
}

// Whether a terminal shows more than ASCII.
bool hasOnlyAscii() {
    for (const char* name : {"LC_ALL", "LC_CTYPE", "LANG"})
        if (const char* const value = std::getenv(name); value && *value) {
            const std::string_view text(value);
            return text == "C" || text == "POSIX";
        }
    return false;
}

std::size_t terminalColumns() {
    winsize size{};
    return ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 100;
}

}  // namespace

void sayReport(const foreign::Report& report) {
    const bool terminal = isatty(STDOUT_FILENO) == 1;
    for (const foreign::TextLine& line :
         reportText(report, terminal && hasOnlyAscii(), terminal ? terminalColumns() : 100)) {
        if (line.bold && terminal)
            sayBold(line.text + "\n");
        else
            say("{}\n", line.text);
    }
}

namespace {

// What was typed, for the page.
std::string commandOf(const CompareArguments& arguments) {
    std::string command = "shadescope compare " + arguments.scene.scene;
    for (const std::string& path : arguments.paths) command += " " + path;
    for (const std::string& set : arguments.scene.set) command += " --set " + set;
    return command + " -o " + arguments.output;
}

// What a renderer's author begins with: a scene in which nothing is symmetrical, and a writer of files.
struct Starter {
    std::string_view language, file;
};
constexpr std::array kStarters{Starter{"cpp", "writer.cpp"}, Starter{"python", "writer.py"}, Starter{"c", "writer.c"},
                               Starter{"java", "Writer.java"}, Starter{"js", "writer.js"}};

int writeStarter(const CompareArguments& arguments) {
    if (arguments.output.empty()) return wrongCompare("--starter needs -o with the name of a folder");
    const auto* const starter = std::ranges::find(kStarters, arguments.starter, &Starter::language);
    const std::filesystem::path target(arguments.output);
    std::error_code failed;
    std::filesystem::create_directories(target, failed);
    std::vector<std::pair<std::string, std::string>> files;
    for (const std::string_view name : {std::string_view("check_me.toml"), starter->file}) {
        auto text = pipeline::readFile(pipeline::resourceFolder() / "starter" / name);
        if (!text) return printErrors(text.errors()), kBadInput;
        files.emplace_back(name, std::move(text).value());
    }
    const auto scene = pipeline::readScene(pipeline::resourceFolder() / "starter" / "check_me.toml");
    if (!scene) return printErrors(scene.errors()), kBadInput;
    std::ranges::move(pipeline::objKit(*scene, "check_me"), std::back_inserter(files));
    for (const auto& [name, text] : files) {
        if (std::filesystem::exists(target / name, failed)) {
            tell("{} is there already: it stays as it is\n", (target / name).string());
            continue;
        }
        pipeline::ByteFile file(target / name);
        file.write(text);
        if (const auto written = file.close(); !written) return printErrors(written.errors()), kCouldNotWrite;
        say("{}\n", (target / name).string());
    }
    say("Draw check_me.toml, write your buffers into {0}, then: shadescope compare {0}/check_me.toml {0}\n",
        target.string());
    return kDone;
}

// One comparison, printed and written.
int compareOnce(const CompareArguments& arguments, const pipeline::Scene& scene, foreign::CompareOptions options,
                const Interrupt& interrupt) {
    ProgressPrinter progress("compare");
    options.progress = [&](std::string_view what, std::size_t done, std::size_t all) {
        if (what == "known errors") progress.show(done, all, what);
    };
    const auto report = compareRenderer(scene, arguments.paths, options);
    progress.end();
    if (interrupt.asked()) {
        tell("Cancelled.\n");
        return kInterrupted;
    }
    if (!report) {
        printErrors(report.errors());
        return kBadInput;
    }
    const int status = exitStatus(*report);
    if (!arguments.output.empty()) {
        // A report of the comparison before is written over: one mends and compares again.
        if (const auto written = pipeline::writeWhole(arguments.output, reportHtml(*report, commandOf(arguments)));
            !written) {
            printErrors(written.errors());
            return kCouldNotWrite;
        }
    }
    if (arguments.json)
        say("{}\n", reportJson(*report, status).dump(2));
    else
        sayReport(*report);
    return status;
}

// Stages at once, names follow.
int watchRenderer(const CompareArguments& arguments, const pipeline::Scene& scene,
                  const foreign::CompareOptions& options, const Interrupt& interrupt) {
    const auto again = [&] {
        foreign::CompareOptions stages = options;
        stages.known = false;
        const int status = compareOnce(arguments, scene, stages, interrupt);
        if (status == kAnswerIsNo && options.known) compareOnce(arguments, scene, options, interrupt);
    };
    return watch([&] { return stateOfFiles(arguments.paths, arguments.output); }, again, interrupt);
}

int runCompare(const CompareArguments& arguments) {
    const pipeline::AnyExponent any;
    if (!arguments.ofClass.course.empty()) {
        ClassRequest request = arguments.ofClass;
        request.handedIn = arguments.scene.scene, request.folder = arguments.output;
        return runClass(request);
    }
    if (!arguments.starter.empty()) return writeStarter(arguments);
    if (arguments.scene.scene.empty()) return wrongCompare("SCENE is missing");
    if (arguments.paths.empty()) return wrongCompare("FOLDER is missing: where your renderer has written its buffers");
    foreign::CompareOptions options;
    for (const std::string& text : arguments.tolerances)
        if (const auto wrong = foreign::readTolerance(text, options.tolerances)) return wrongCompare(*wrong);
    if (!arguments.stage.empty())
        if (const auto wrong = foreign::readUntil(arguments.stage, options.until)) return wrongCompare(*wrong);
    options.known = !arguments.noKnown && arguments.hints >= 3;
    options.strict = arguments.strict, options.hints = arguments.hints;
    const Interrupt interrupt;
    options.stop = interrupt.token();
    int status = kDone;
    const auto scene = loadScene(arguments.scene, options.stop, status);
    if (!scene) return status;
    for (const std::string& id : arguments.without)
        if (const auto wrong = foreign::readWithout(id, *scene, options.without)) return wrongCompare(*wrong);
    pipeline::FrameRequest request;
    for (const foreign::Tolerance& row : foreign::toleranceTable()) request.wanted.set(index(row.buffer));
    if (!fits(*scene, request, arguments.scene, status)) return status;
    if (!arguments.output.empty() && !mayWriteTo(arguments.output)) return kCouldNotWrite;
    return arguments.watch ? watchRenderer(arguments, *scene, options, interrupt)
                           : compareOnce(arguments, *scene, options, interrupt);
}

}  // namespace

void declareCompare(CLI::App& program, const CliHost&, int& status) {
    const auto arguments = std::make_shared<CompareArguments>();
    CLI::App* command =
        program.add_subcommand("compare", "Find the first wrong stage of another renderer by its files");
    declareSceneArgument(*command, arguments->scene, SceneArgument::Need::Maybe);  // --starter takes none
    command->add_option("FOLDER", arguments->paths, "A folder with the buffers of a renderer, or files by themselves")
        ->type_name("|FILE ...");
    declareFolder(*command, arguments->output, "Write the report as an HTML page; the folder of --starter")
        ->type_name("REPORT.html|DIR");
    std::vector<std::string> languages;
    for (const Starter& starter : kStarters) languages.emplace_back(starter.language);
    command
        ->add_option("--starter", arguments->starter,
                     "Write a scene, also as OBJ, and a writer of files into the folder -o")
        ->type_name("LANGUAGE")
        ->check(CLI::IsMember(languages));
    command->add_flag("--watch", arguments->watch, "Compare again whenever the files change, until Ctrl+C");
    command->add_option("--stage", arguments->stage, "Compare no further than this stage")->type_name("STAGE");
    command->add_option("--tolerance", arguments->tolerances, "What is still called the same: color=2, depth=0.001")
        ->type_name("BUFFER=NUMBER")
        ->delimiter(',')
        ->allow_extra_args(false);
    command
        ->add_option("--hints", arguments->hints,
                     "How much is given away: 1 the stage, 2 the place, 3 the error's name")
        ->type_name("0..3")
        ->check(CLI::Range(0, 3))
        ->capture_default_str();
    command->add_flag("--strict", arguments->strict, "Conventions other than the program's count as errors");
    command->add_flag("--no-known", arguments->noKnown, "Do not look for known errors");
    command->add_option("--without", arguments->without, "Do not try this known error; may be given several times")
        ->type_name("ID")
        ->allow_extra_args(false);
    command->add_flag("--json", arguments->json, "Print JSON");
    const std::vector<CLI::Option*> notOfClass = command->get_options([](const CLI::Option* option) {
        return !option->check_name("SCENE") && !option->check_name("--help") && !option->check_name("--output");
    });
    CLI::Option* ofClass = command
                               ->add_option("--class", arguments->ofClass.course,
                                            "Mark the hand-ins of a class, one folder a student in place of SCENE, by "
                                            "the points of this file")
                               ->type_name("COURSE.toml");
    for (CLI::Option* option : notOfClass) ofClass->excludes(option);
    command
        ->add_option("--pass", arguments->ofClass.pass,
                     "Of a class: exit with 1 where somebody has fewer per cent of the points")
        ->check(CLI::Range(0.0, 100.0))
        ->type_name("PERCENT")
        ->needs(ofClass);
    command->add_option("--shard", arguments->ofClass.shard, "Of a class: only the I-th of N parts of the hand-ins")
        ->type_name("I/N")
        ->needs(ofClass);
    command
        ->add_option("--commands", arguments->ofClass.commands,
                     "Of a class: write one command a line instead of running, for several machines")
        ->type_name("FILE")
        ->needs(ofClass);
    command->add_flag("--restart", arguments->ofClass.restart, "Of a class: mark again what is marked already")
        ->needs(ofClass);
    declareForce(*command, arguments->ofClass.force)->needs(ofClass);
    command->callback([arguments, &status] { status = runCompare(*arguments); });
}

}  // namespace app
