#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/headless/command_host.h"
#include "app/headless/derived_wanted.h"
#include "app/headless/wanted_frame.h"
#include "pipeline/export/export_frame.h"
#include "pipeline/steps/moment.h"

namespace app {

// As the options of `shadescope export` have them.
struct ExportOptions {
    FrameArgument frame;
    DerivedArgument derived;
    std::string folder;
    std::vector<std::string> formats{"npy", "png"};
    std::string at;     // a place inside a stage; empty: all stages
    std::string pixel;  // of the 3D views
    bool force = false;
};

// Where the files go: the program has a disk, the core of the page has memory.
struct ExportPlace {
    // Fills in what the options leave open, such as the buffers of a cue; until: where the run ends.
    std::function<pipeline::Errors(ExportOptions& options, std::optional<pipeline::StageId> until)> prepare;
    // Whether files of these names may be written, before anything is computed. If not, the reason was told.
    std::function<bool(const std::vector<std::string>& names)> mayWrite;
    std::function<pipeline::Result<pipeline::ExportSummary>(
        const pipeline::Frame& frame, pipeline::ExportRequest request, const ExportOptions& options,
        const std::optional<pipeline::Place>& at, const std::optional<glm::ivec2>& pixel)>
        write;
    bool writesViews = false;  // files beside those of the request
};

// The names of all formats there are, and what is wrong with some; empty: nothing.
std::vector<std::string> formatNames();
std::string wrongFormats(const std::vector<std::string>& formats);

// Runs a scene and writes its buffers; gives the exit status.
int exportBuffers(const std::shared_ptr<const pipeline::Scene>& scene, ExportOptions options, const ExportPlace& to,
                  const CommandHost& host);

}  // namespace app
