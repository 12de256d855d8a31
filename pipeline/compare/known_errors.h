#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/buffers/buffer_table.h"
#include "pipeline/core/stage.h"
#include "pipeline/scene/scene.h"

namespace pipeline::foreign {

// An error that renderers are known to have, as a scene whose frame shows it.
struct KnownError {
    std::string id, name;          // "r-flip", "R points the wrong way"
    std::optional<StageId> stage;  // where the line stands that is to be mended; nothing: in the file
    std::string wrong, right;      // the line, in the lecture's notation
    std::string lesson, heading;   // about it; empty where there is none
    std::string way;               // how it is made, where there are several
    // The scene with the error, beside one that it may have already; as it is where that cannot be.
    std::function<Scene(Scene)> plant;
    std::vector<BufferId> leaves{};  // right, though its frame shows others
};

// All that this scene can show: every planted defect in each of its ways, and errors that a change of settings shows.
std::vector<KnownError> knownErrors(const Scene& scene);

}  // namespace pipeline::foreign
