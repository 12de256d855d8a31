#pragma once
#include <string>
#include <string_view>

#include "pipeline/formats/scene_folder.h"
#include "pipeline/scene/scene.h"

namespace pipeline {

// The text chunks in which a picture that this program exported (pipeline/export/buffers/png_file.h) carries its scene and what the
// window showed, as TOML; the scene stands beside it.
inline constexpr char kSceneChunk[] = "Shadescope scene";
inline constexpr char kStateChunk[] = "Shadescope state";
inline constexpr std::size_t kMaxCarriedScene = std::size_t{1} << 20;  // bytes of text

bool looksLikePng(std::string_view start);
// A picture without a scene, or one that is damaged, is refused.
Result<Scene> readPngScene(const SourceText& source, const FileLoader& load);

// The name of the buffer that a picture shows; empty where it does not say, or where it is stopped.
std::string shownBuffer(std::string_view png, const Stop& stop = {});

// What the window showed, as TOML: lessons/state/window_state.h; likewise.
std::string carriedState(std::string_view png, const Stop& stop = {});

}  // namespace pipeline
