#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "app/headless/exit_status.h"
#include "lessons/pages/talk_page.h"
#include "pipeline/core/result.h"
#include "pipeline/run/frame.h"

namespace app {

// What only a build with a window can do.
struct CliHost {
    // Writes the 3D views of a frame as PNG files into a folder and gives their paths; empty in
    // a build without them.
    std::function<pipeline::Result<std::vector<std::filesystem::path>>(
        const pipeline::Frame& frame, std::optional<glm::ivec2> pixel, const std::filesystem::path& folder)>
        writeViews;
    // Draws a view of a cue as the window does; empty in a build without it.
    lessons::DrawView drawCueView;
    bool hasWindow = false;
};

// Whether a program's first argument is for runCli: a subcommand, or an option that it knows.
bool isForCli(std::string_view argument);
// Of the subcommands: what was meant by a first argument that is none.
std::string nearestCommand(std::string_view argument);

// Runs a subcommand. Data goes to standard output, messages to standard error. Gives the
// program's exit status. Throws std::bad_alloc.
int runCli(int argc, const char* const* argv, const CliHost& host);

// The help of the whole program.
std::string helpText(const CliHost& host);

}  // namespace app
