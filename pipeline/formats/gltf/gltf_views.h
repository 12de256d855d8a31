#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/core/result.h"
#include "pipeline/formats/text/read_progress.h"
#include "pipeline/scene/scene.h"

namespace pipeline {

// What a model opened by itself takes of its file instead of what the program adds (pipeline/scene/framing.h).
struct GltfViews {
    std::optional<std::size_t>
        camera{};         // of the nodes with one, in the order in which the file's scene shows them, from 0
    bool lights = false;  // all of KHR_lights_punctual
    bool any() const { return camera || lights; }
};

// The scene of a glTF file, as readScene() gave it, with its own camera or lights. Intensities are those at the middle of
// the scene, in one factor: lights have no range there, and only OpenGL's model reads a spot.
// Errors: no glTF file; no such camera; no light; those of its reader.
Result<Scene> withGltfViews(Scene scene, const std::filesystem::path& file, const GltfViews& views,
                            const ReadProgress& progress = {});

// The names of a glTF file's cameras, by their numbers: the camera's own, else its node's, else "camera 0".
Result<std::vector<std::string>> gltfCameras(const std::filesystem::path& file, const ReadProgress& progress = {});

}  // namespace pipeline
