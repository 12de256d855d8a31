#pragma once
#include <stop_token>
#include <string>
#include <vector>

#include "pipeline/core/result.h"

namespace app {

// Runs this program once more with other arguments and waits for it; its output is ours. Gives its exit status, 128 +
// the signal that ended it. When it is asked to stop it asks the other one to stop, too;
// when this thread or the process ends by force the other one ends.
pipeline::Result<int> runOurselves(const std::vector<std::string>& arguments, std::stop_token stop);

}  // namespace app
