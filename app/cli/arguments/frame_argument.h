#pragma once
#include <string>
#include <vector>

#include "app/headless/wanted_frame.h"

namespace CLI {
class App;
}

namespace app {

void declareFrameArgument(CLI::App& command, FrameArgument& argument);
void declareThreads(CLI::App& command, int& threads);
// An option of names with commas between them. An empty one counts, so that it is refused as any other unknown name.
void declareNames(CLI::App& command, const std::string& option, std::vector<std::string>& names,
                  const std::string& type, const std::string& meaning);

// remarksText(), on standard error.
void tellRemarks(const pipeline::Frame& frame);

}  // namespace app
