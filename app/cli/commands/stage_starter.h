#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/compare/own/stage_blocks.h"

namespace app {

std::vector<std::string> starterLanguages();  // "python", "cpp", …

// Writes one file with a function to complete, and all that it takes to run it, into a folder that is made when it is missing.
// Gives the file's path. A file that is there already stays, and is an error.
pipeline::Result<std::string> writeFunctionStarter(const pipeline::OwnContract& contract, const std::string& language,
                                                   const std::filesystem::path& folder);

// The same for a whole stage.
pipeline::Result<std::string> writeStageStarter(const pipeline::foreign::StageBlocks& blocks,
                                                const std::string& language, const std::filesystem::path& folder);
// The six ready assignments and their scenes, likewise.
pipeline::Result<std::vector<std::string>> writeAssignments(const std::filesystem::path& folder);

}  // namespace app
