#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/core/result.h"
#include "pipeline/defects/own.h"

namespace app {

std::vector<std::string> starterLanguages();  // "python", "cpp", …

// Writes one file with a function to complete, and all that it takes to run it, into a folder that is made when it is missing.
// Gives the file's path. A file that is there already stays, and is an error.
pipeline::Result<std::string> writeFunctionStarter(const pipeline::OwnContract& contract, const std::string& language,
                                                   const std::filesystem::path& folder);

}  // namespace app
