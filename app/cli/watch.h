#pragma once
#include <functional>
#include <string>
#include <vector>

#include "app/cli/interrupt.h"

namespace app {

// Names, sizes and times of these files and of all files in these folders, without `own`, the file that the command writes.
// The text changes when one of them is written.
std::string stateOfFiles(const std::vector<std::string>& paths, const std::string& own);

// Calls `again` at once, and after each change once the state has stayed the same for a moment. Ends with Ctrl+C; returns
// the exit status.
int watch(const std::function<std::string()>& state, const std::function<void()>& again, const Interrupt& interrupt);

}  // namespace app
