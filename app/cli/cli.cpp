#include "app/cli/cli.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <system_error>

#include "app/cli/commands.h"
#include "app/cli/message.h"
#include "app/cli/out_of_memory.h"
#include "pipeline/core/printable.h"
#include "pipeline/core/text.h"
#include "pipeline/core/version.h"
#include "pipeline/formats/text/inputs.h"

namespace app {

namespace {

constexpr std::array kCommands{
    Command{"export", declareExport}, Command{"plan", declarePlan},       Command{"inspect", declareInspect},
    Command{"study", declareStudy},   Command{"check", declareCheck},     Command{"bench", declareBench},
    Command{"film", declareFilm},     Command{"figure", declareFigure},   Command{"lesson", declareLesson},
    Command{"bug", declareBug},       Command{"compare", declareCompare}, Command{"present", declarePresent},
    Command{"site", declareSite},     Command{"sheet", declareSheet},     Command{"grade", declareGrade},
    Command{"drill", declareDrill},   Command{"stage", declareStage},
};

constexpr std::array<std::string_view, 4> kOptions{"-h", "--help", "--version", "--help-all"};

constexpr const char* kSceneFooter =
    "SCENE is a scene file, or the name of a scene that comes with the program: pyramid.\n";
constexpr const char* kFooter =
    "Exit status: 0 done, 1 the answer is no, 2 wrong usage, 3 bad input,\n4 could not write, or not enough memory.";

// Of a command that takes a SCENE, or with commands of its own that do.
bool takesScene(const CLI::App& command) {
    return command.get_option_no_throw("SCENE") ||
           std::ranges::any_of(command.get_subcommands({}), [](const CLI::App* one) { return takesScene(*one); });
}

// A command takes its last lines from the one that it is added to.
void addFooters(CLI::App& command) {
    command.footer(takesScene(command) ? std::string(kSceneFooter) + kFooter : kFooter);
    for (CLI::App* one : command.get_subcommands({})) addFooters(*one);
}

}  // namespace

void declareProgram(CLI::App& program, const CliHost& host, int& status) {
    program.name("shadescope");
    program.description(
        std::string("See how polygons become a picture, one step at a time.\n") +
        (host.hasWindow
             ? "shadescope [FILE] opens the window, shadescope present FILE[:CUE] a talk; a command needs no display.\n"
               "shadescope FOLDER checks the renderer that has written its buffers there.\n"
               "--no-session, as the first argument, leaves the session alone for once: nothing is read, nothing kept."
             : "This build has no window: it has the commands alone."));
    program.set_help_flag("-h,--help", "Print this help");
    program.set_help_all_flag("--help-all", "Print the help of every command");
    program.set_version_flag("--version", fmt::format("shadescope {}", pipeline::programVersion()));
    program.require_subcommand(1);
    program.get_formatter()->column_width(32);
    for (const Command& command : kCommands) command.declare(program, host, status);
    addFooters(program);
}

namespace {

int couldNotWrite(int error) {
    tell("standard output: could not write: {}\n", std::generic_category().message(error));
    return kCouldNotWrite;
}

// What is short enough meets a full disk only here.
int flushed(int status) {
    errno = 0;
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return status;
    return couldNotWrite(errno != 0 ? errno : EIO);
}

}  // namespace

bool isForCli(std::string_view argument) {
    return std::ranges::find(kOptions, argument) != kOptions.end() ||
           std::ranges::find(kCommands, argument, &Command::name) != kCommands.end();
}

std::string nearestCommand(std::string_view argument) {
    std::vector<std::string> names;
    names.reserve(std::size(kCommands));
    for (const Command& command : kCommands) names.emplace_back(command.name);
    return pipeline::nearest(argument, names);
}

int runCli(int argc, const char* const* argv, const CliHost& host) {
    const pipeline::InputMemory inputs;  // no command replaces what it has read
    CLI::App program;
    int status = kDone;
    declareProgram(program, host, status);
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {  // help and version come this way too
        if (error.get_exit_code() == 0) {
            program.exit(error);
            return flushed(kDone);
        }
        const std::string_view first = argc > 1 ? argv[1] : "";
        const bool isOfCommand = std::ranges::find(kCommands, first, &Command::name) != kCommands.end();
        tell("shadescope: {}\nRun shadescope {}{}--help to see what there is.\n", pipeline::escaped(error.what()),
             isOfCommand ? first : "", isOfCommand ? " " : "");
        return kWrongUsage;
    } catch (const std::system_error& error) {  // say() has no other way
        if (error.code() == std::errc::resource_unavailable_try_again) return sayOutOfThreads();
        return couldNotWrite(error.code().value());
    }
    return flushed(status);
}

std::string helpText(const CliHost& host) {
    CLI::App program;
    int status = kDone;
    declareProgram(program, host, status);
    return program.help();
}

}  // namespace app
