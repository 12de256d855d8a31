#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdlib>

#include "app/cli/commands.h"
#include "app/cli/interrupt.h"
#include "app/cli/message.h"
#include "app/cli/progress_printer.h"
#include "app/cli/scene_argument.h"
#include "pipeline/compare/compare_html.h"
#include "pipeline/compare/compare_text.h"
#include "pipeline/core/text.h"
#include "pipeline/export/byte_file.h"
#include "pipeline/formats/text_scanner.h"

namespace app {

namespace {

namespace foreign = pipeline::foreign;

struct CompareArguments {
    SceneArgument scene;
    std::vector<std::string> paths, tolerances;
    std::string stage, output;
    int hints = 3;
    bool strict = false, noKnown = false, json = false;
};

int wrongCompare(const std::string& message) {
    tell("shadescope compare: {}\n", message);
    return kWrongUsage;
}

// "color=2": a buffer's name without a light's index, and a number.
std::optional<std::string> parseTolerance(const std::string& text, std::map<std::string, double>& into) {
    const auto equals = text.find('=');
    const std::string name = text.substr(0, equals);
    const auto value =
        equals == text.npos ? std::nullopt : pipeline::parseNumber(std::string_view(text).substr(equals + 1));
    if (!value || *value < 0) return fmt::format("--tolerance is {}, expected BUFFER=NUMBER", pipeline::inQuotes(text));
    const std::string buffer = name == "depth" ? "z_view" : name;
    for (const foreign::Tolerance& row : foreign::toleranceTable())
        if (bufferInfo(row.buffer).name == buffer) {
            into[buffer] = *value;
            return {};
        }
    return fmt::format("--tolerance: no buffer is called {}; {}", pipeline::inQuotes(name),
                       foreign::insteadOfHanded(name));
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

int statusOf(const foreign::Report& report) {
    if (!report.agrees()) return kAnswerIsNo;
    if (report.options.strict && report.conventionsDiffer()) return kAnswerIsNo;
    return report.in->errors.empty() ? kDone : kBadInput;
}

// What was typed, for the page.
std::string commandOf(const CompareArguments& arguments) {
    std::string command = "shadescope compare " + arguments.scene.scene;
    for (const std::string& path : arguments.paths) command += " " + path;
    for (const std::string& set : arguments.scene.set) command += " --set " + set;
    return command + " -o " + arguments.output;
}

int runCompare(const CompareArguments& arguments) {
    foreign::CompareOptions options;
    for (const std::string& text : arguments.tolerances)
        if (const auto wrong = parseTolerance(text, options.tolerances)) return wrongCompare(*wrong);
    if (!arguments.stage.empty()) {
        const auto stage = pipeline::findStage(arguments.stage);
        if (!stage)
            return wrongCompare(fmt::format("--stage: no stage is called {}", pipeline::inQuotes(arguments.stage)));
        options.until = *stage;
    }
    options.known = !arguments.noKnown && arguments.hints >= 3;
    options.strict = arguments.strict, options.hints = arguments.hints;
    const Interrupt interrupt;
    options.stop = interrupt.token();
    int status = kDone;
    const auto scene = loadScene(arguments.scene, options.stop, status);
    if (!scene) return status;
    pipeline::FrameRequest request;
    for (const foreign::Tolerance& row : foreign::toleranceTable()) request.wanted.set(index(row.buffer));
    if (!fits(*scene, request, arguments.scene, status)) return status;
    ProgressPrinter progress("compare");
    options.progress = [&](std::string_view what, std::size_t done, std::size_t all) {
        if (what == "known errors") progress.show(done, all, what);
    };
    const auto report = compareRenderer(*scene, arguments.paths, options);
    progress.end();
    if (interrupt.asked()) {
        tell("Cancelled.\n");
        return kInterrupted;
    }
    if (!report) {
        printErrors(report.errors());
        return kBadInput;
    }
    status = statusOf(*report);
    if (!arguments.output.empty()) {
        pipeline::ByteFile page(arguments.output);
        page.write(reportHtml(*report, commandOf(arguments)));
        if (const auto written = page.close(); !written) {
            printErrors(written.errors());
            return kCouldNotWrite;
        }
    }
    if (arguments.json)
        say("{}\n", reportJson(*report, status).dump(2, ' ', false, pipeline::Json::error_handler_t::replace));
    else
        sayReport(*report);
    return status;
}

}  // namespace

void declareCompare(CLI::App& program, const CliHost&, int& status) {
    const auto arguments = std::make_shared<CompareArguments>();
    CLI::App* command =
        program.add_subcommand("compare", "Find the first wrong stage of another renderer by its files");
    declareSceneArgument(*command, arguments->scene);
    command->add_option("FOLDER", arguments->paths, "A folder with the buffers of a renderer, or files by themselves")
        ->required()
        ->type_name("|FILE ...");
    command->add_option("-o,--output", arguments->output, "Write the report as an HTML page")->type_name("REPORT.html");
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
    command->add_flag("--json", arguments->json, "Print JSON");
    command->callback([arguments, &status] { status = runCompare(*arguments); });
}

}  // namespace app
