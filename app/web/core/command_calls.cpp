#include <algorithm>
#include <array>
#include <memory>

#include "app/headless/check.h"
#include "app/headless/export.h"
#include "app/headless/inspect.h"
#include "app/headless/plan.h"
#include "app/web/core/core.h"
#include "app/web/core/written_files.h"
#include "pipeline/core/printable.h"
#include "pipeline/export/folder/contents.h"
#include "pipeline/export/manifest.h"
#include "pipeline/plan/memory_limit.h"

// Commands of the program on the open scene: what each prints, and its exit status.

namespace web {

namespace {

std::vector<std::string> textsOf(const Json& json) {
    std::vector<std::string> texts;
    for (const Json& one : json) texts.push_back(one.text());
    return texts;
}
bool isSet(const Json& json) { return json == Json(true); }

app::FrameArgument frameOf(const Json& options) {
    app::FrameArgument frame{.until = options["until"].text(), .threads = 1};
    if (options.find("buffers")) frame.buffers = textsOf(options["buffers"]);
    return frame;
}

int runInspect(const Json& options, const app::CommandHost& host) {
    app::InspectOptions what{.pixel = options["pixel"].text(),
                             .table = options["table"].text(),
                             .step = options["step"].text(),
                             .contracts = isSet(options["contracts"]),
                             .threads = 1,
                             .json = isSet(options["json"])};
    if (const Json* where = options.find("where")) what.where = where->text();
    if (const Json* row = options.find("row"); row && row->is(Json::kWhole)) what.row = int(row->get<long long>());
    if (const Json* format = options.find("format")) what.format = format->text();
    return inspect(core().own.scene, what, host);
}

int runPlan(const Json& options, const app::CommandHost& host) {
    return plan(core().own.scene,
                {.frame = frameOf(options), .json = isSet(options["json"]), .counts = isSet(options["counts"])}, host);
}

int runCheck(const Json& options, const app::CommandHost& host) {
    return check({.cases = textsOf(options["case"]),
                  .groups = textsOf(options["group"]),
                  .threads = 1,
                  .json = isSet(options["json"]),
                  .list = isSet(options["list"])},
                 host);
}

// The files go to writtenFiles(), the manifest last.
pipeline::Result<pipeline::ExportSummary> keepFiles(const pipeline::Frame& frame,
                                                    const pipeline::ExportRequest& request) {
    auto written = writeExportFiles(frame, request, {});
    if (!written) return written.errors();
    pipeline::ExportFiles made = std::move(written).value();
    std::vector<std::pair<std::string, std::string>> files;
    for (const std::string& name : made.names) files.emplace_back(name, writtenFiles()['/' + name]);
    made.manifest["contents"] = pipeline::contentsOf(files);
    const std::string text = made.manifest.dump(2) + '\n';
    made.names.emplace_back(pipeline::kManifest);
    writtenFiles()[std::string("/") + pipeline::kManifest] = text;
    return pipeline::ExportSummary{.files = made.names, .bytes = made.bytes + text.size()};
}

int runExport(const Json& options, const app::CommandHost& host) {
    app::ExportOptions what{.frame = frameOf(options), .folder = options["folder"].text()};
    what.derived.where = options["where"].text(), what.derived.mix = options["mix"].text();
    what.derived.shadowVerdicts = isSet(options["shadowVerdicts"]);
    what.at = options["at"].text();
    if (options.find("format")) what.formats = textsOf(options["format"]);
    if (const std::string wrong = app::wrongFormats(what.formats); !wrong.empty()) {
        host.tell("shadescope export: {}\n", wrong);
        return app::kWrongUsage;
    }
    writtenFiles().clear();
    const app::ExportPlace place{
        .prepare = [](app::ExportOptions&, std::optional<pipeline::StageId>) { return pipeline::Errors(); },
        .mayWrite = [](const std::vector<std::string>&) { return true; },  // who keeps the files looks
        .write = [](const pipeline::Frame& frame, const pipeline::ExportRequest& request, const app::ExportOptions&,
                    const std::optional<pipeline::Place>&,
                    const std::optional<glm::ivec2>&) { return keepFiles(frame, request); }};
    return exportBuffers(core().own.scene, what, place, host);
}

struct Command {
    std::string_view name;
    int (*run)(const Json& options, const app::CommandHost& host);
    bool needsScene = true;
};
constexpr std::array kCommands{Command{"inspect", runInspect}, Command{"plan", runPlan}, Command{"export", runExport},
                               Command{"check", runCheck, false}};

}  // namespace

// Options by their names on the command line, as JSON; {"out", "messages", "status", "files"}. Of an export `files` are the
// names of what written() gives.
WEB_CALL(run_command) int webRunCommand(const char* name, int nameSize, const char* text, int size) {
    const std::string_view asked = textAt(name, nameSize);
    const auto command =
        std::find_if(kCommands.begin(), kCommands.end(), [&](const Command& one) { return one.name == asked; });
    if (command == kCommands.end()) return refuse("no such command");
    if (command->needsScene && !core().own.scene) return refuse("no scene is open");
    std::string out, messages;
    const app::CommandHost host{
        .out = [&](std::string_view said) { out += pipeline::escapedLines(said); },
        .messages = [&](std::string_view told) { messages += pipeline::escapedLines(told); },
        .tellErrors = [&](const pipeline::Errors& errors) { messages += pipeline::escapedLines(format(errors)); },
        .fits =
            [&](const pipeline::Scene& scene, const pipeline::FrameRequest& request, int& status) {
                const pipeline::Errors errors = checkMemory(scene, request.wanted, request.until);
                if (errors.empty()) return true;
                messages += pipeline::escapedLines(format(errors));
                status = app::kBadInput;
                return false;
            }};
    const int status = command->run(Json::read(textAt(text, size)).value_or(Json()), host);
    Json files = Json::array();
    for (const auto& [file, bytes] : writtenFiles()) files.push_back(file.substr(1));
    return give({{"out", out}, {"messages", messages}, {"status", status}, {"files", files}});
}

// The bytes of a file that an export has written: pointer and count.
WEB_CALL(written) int webWritten(const char* name, int size) {
    const auto found = writtenFiles().find('/' + std::string(textAt(name, size)));
    if (found == writtenFiles().end()) return refuse("no such file was written");
    return give(
        {{"pointer", std::uintptr_t(found->second.data())}, {"count", found->second.size()}, {"dtype", "uint8"}});
}

}  // namespace web
