#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "app/cli/commands.h"
#include "app/cli/frame_argument.h"
#include "app/cli/scene_argument.h"
#include "pipeline/export/json.h"
#include "pipeline/inspect/pixel_report.h"
#include "pipeline/run/runner.h"

namespace app {

namespace {

struct InspectOptions {
    SceneArgument scene;
    std::string pixel;
    int threads = 0;
    bool json = false;
};

int runInspect(const InspectOptions& options) {
    int status = kDone;
    const auto scene = loadScene(options.scene, status);
    if (!scene) return status;
    const auto pixel = pixelIn(*scene, options.pixel);
    if (!pixel) return kWrongUsage;
    pipeline::FrameRequest request;
    request.threads = options.threads;
    const pipeline::FramePtr frame = runFrame(scene, request, nullptr);
    const pipeline::PixelReport report = inspectPixel(*frame, *pixel);
    if (options.json)
        fmt::print("{}\n", toJson(*frame, report).dump(2, ' ', false, pipeline::Json::error_handler_t::replace));
    else
        fmt::print("{}", toText(*frame, report));
    return kDone;
}

}  // namespace

void declareInspect(CLI::App& program, const CliHost&, int& status) {
    const auto options = std::make_shared<InspectOptions>();
    CLI::App* command =
        program.add_subcommand("inspect", "Print everything known about a pixel, its equation included");
    declareSceneArgument(*command, options->scene);
    command->add_option("--pixel", options->pixel, "Column and row, from 0 at the top left")
        ->required()
        ->type_name("X,Y");
    declareThreads(*command, options->threads);
    command->add_flag("--json", options->json, "Print JSON");
    command->callback([options, &status] { status = runInspect(*options); });
}

}  // namespace app
