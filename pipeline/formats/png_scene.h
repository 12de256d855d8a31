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

// The name of the buffer that a picture shows; empty where it does not say, or where it is stopped.
std::string shownBuffer(std::string_view png, const Stop& stop = {});

// What the window showed, as TOML: lessons/state/window_state.h; likewise.
std::string carriedState(std::string_view png, const Stop& stop = {});

}  // namespace pipeline
