#pragma once
#include <stop_token>

#include "lessons/questions/write_run.h"

namespace app {

// Runs lines of questions of kind write in Node.js, in a process of its own: at most 10 s and 256 MB. What reads and runs them
// are a live page's parts. Empty where there is no Node.js, or the parts are not there.
lessons::LinesRunner nodeLines(const std::stop_token& stop);

}  // namespace app
