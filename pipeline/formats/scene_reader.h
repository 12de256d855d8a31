#pragma once
#include <filesystem>

#include "pipeline/core/result.h"
#include "pipeline/formats/built_in_scenes.h"
#include "pipeline/formats/text/read_progress.h"
#include "pipeline/scene/scene.h"

namespace pipeline {

// Reads a scene from a file of any format of format_table.h. Files that it names are looked for
// beside it; a path that leaves its folder is refused. The scene has passed checkScene.
Result<Scene> readScene(const std::filesystem::path& file, const ReadProgress& progress = {});

}  // namespace pipeline
