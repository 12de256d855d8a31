#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/buffers/buffer_table.h"
#include "pipeline/core/stage.h"

namespace pipeline {

// Scenes that come with the program.
struct BuiltInScene {
    std::string name;   // "pyramid"
    std::string title;  // "Pyramid"
    std::string look;   // what to look at, one sentence
    std::filesystem::path file;
    StageId stage = StageId::Shading;   // where its point is made
    std::vector<BufferName> buffers{};  // that make it, the most important first; may be empty
};
std::vector<BuiltInScene> builtInScenes();
// By its name; nothing where there is none.
std::optional<BuiltInScene> builtInScene(std::string_view name);
// The one whose file this is; nothing for any other.
std::optional<BuiltInScene> builtInSceneOf(const std::filesystem::path& file);

// Where resources/ is: the folder that was set, else ../share/shadescope from an installed program, else the source tree.
std::filesystem::path resourceFolder();
// For a library, beside whose program no resources are. Once, before anything is read.
void setResourceFolder(std::filesystem::path folder);

}  // namespace pipeline
