#pragma once
#include <array>
#include <cstddef>
#include <optional>

#include "pipeline/run/runner.h"

namespace app {

// One for each stage, against double precision; empty if it is not computed.
using StageErrors = std::array<std::optional<pipeline::StageError>, pipeline::kStageCount>;

// The result of checking a frame in idle time.
struct FrameCheck {
    StageErrors errors;
    std::size_t nan = 0;  // NaN values in all its buffers
};

}  // namespace app
