#pragma once
#include <string>
#include <string_view>

namespace pipeline {

// The name of a hidden folder of this process, ".shadescope.part-HOST-PID-START-N". Processes of several machines may
// share the folder it stands in, so that host, process and the process' start, in clock ticks after the machine's, say
// whose it is.
std::string hiddenName(int number);

// Whether a file of this name was left by a process of this machine that is gone. False where that is not certain: of
// another machine, or of a process that cannot be looked at.
bool isLeftover(std::string_view name);

}  // namespace pipeline
