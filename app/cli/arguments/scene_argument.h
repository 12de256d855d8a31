#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/headless/command_host.h"
#include "app/headless/pixel_text.h"
#include "lessons/state/window_state.h"
#include "pipeline/core/result.h"
#include "pipeline/core/stop.h"
#include "pipeline/formats/gltf/gltf_views.h"
#include "pipeline/run/frame.h"
#include "pipeline/scene/scene.h"

namespace CLI {
class App;
}

namespace app {

// What every command on a scene takes: SCENE, --set, --size, --no-leave-out.
struct SceneArgument {
    std::string scene;
    std::vector<std::string> set;                    // KEY=VALUE, applied in order
    std::string size;                                // WxH; empty: the scene's
    bool noLeaveOut = false;                         // everything runs
    pipeline::GltfViews views = {};                  // what of a glTF file takes the place of what is added to it
    std::optional<lessons::WindowState> state = {};  // what it shows in place of `scene`, its files from `folder`
    std::filesystem::path folder = {};
    enum class Need { Always, Maybe };
};

void declareSceneArgument(CLI::App& command, SceneArgument& argument,
                          SceneArgument::Need need = SceneArgument::Need::Always);

// The scene with its settings applied, or nothing after the reasons went to standard error and
// `status` was set to kBadInput, kWrongUsage or, where the stop ended it, kInterrupted.
std::shared_ptr<const pipeline::Scene> loadScene(const SceneArgument& argument, const pipeline::Stop& stop,
                                                 int& status);

// Whether such a frame fits into memory. If not, the reason went to standard error and `status` was set: to kWrongUsage
// where an option has made it so large, else to kBadInput.
bool fits(const pipeline::Scene& scene, const pipeline::FrameRequest& request, const SceneArgument& argument,
          int& status);

// The terminal, for a command on the scene of `argument`, which outlives the host.
CommandHost commandHost(const SceneArgument& argument, pipeline::Stop stop);

// Prints one line an error. Throws std::bad_alloc where memory was missing and nothing is wrong with a file.
void printErrors(const pipeline::Errors& errors);

}  // namespace app
