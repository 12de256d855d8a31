#pragma once
#include <functional>
#include <string>
#include <vector>

#include "app/cli/interrupt.h"

namespace app {

// What tells that files were written anew: names, sizes and times of these, and of the files in these folders, but for the
// one that the command writes itself.
std::string stateOfFiles(const std::vector<std::string>& paths, const std::string& own);

// Calls `again` at once, and whenever the state has changed and stays as it is for a moment; until Ctrl+C. Gives the exit
// status.
int watch(const std::function<std::string()>& state, const std::function<void()>& again, const Interrupt& interrupt);

}  // namespace app
