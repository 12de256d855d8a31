#pragma once
#include <filesystem>

#include "lessons/state/window_state.h"
#include "pipeline/core/result.h"
#include "pipeline/scene/scene.h"

namespace app {

// What of a cue does not fit its scene, with the places in its file. The window shows the rest of such a cue and says
// what it left out; a command that nobody watches refuses it. folder: that files are named from.
pipeline::Errors checkCue(const lessons::WindowState& state, const pipeline::Scene& scene,
                          const std::filesystem::path& folder);

}  // namespace app
