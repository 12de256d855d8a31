#pragma once
#include <string>
#include <string_view>

#include "pipeline/formats/scene_folder.h"
#include "pipeline/scene/scene.h"

namespace pipeline {

// A picture that this program exported carries its scene (pipeline/export/png_file.h).
bool looksLikePng(std::string_view start);
// A picture without a scene, or one that is damaged, is refused.
Result<Scene> readPngScene(const SourceText& source, const FileLoader& load);

// The name of the buffer that a picture shows; empty where it does not say.
std::string shownBuffer(std::string_view png);

// What the window showed, as TOML: lessons/state/window_state.h; empty where the picture does not say.
std::string carriedState(std::string_view png);

}  // namespace pipeline
