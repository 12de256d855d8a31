#pragma once

namespace app {

// What every command answers with.
enum ExitStatus {
    kDone = 0,
    kAnswerIsNo = 1,
    kWrongUsage = 2,
    kBadInput = 3,
    kCouldNotWrite = 4,  // or there was not enough memory
    kInterrupted = 130,  // Ctrl+C, as shells have it; the others that ask to stop too
};

}  // namespace app
