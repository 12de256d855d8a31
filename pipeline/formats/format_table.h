#pragma once
#include <span>
#include <string>
#include <string_view>

#include "pipeline/core/result.h"
#include "pipeline/formats/scene_folder.h"
#include "pipeline/scene/scene.h"

namespace pipeline {

// A file format that a scene can be read from.
struct Format {
    std::string_view name;                      // "scene description"
    std::string_view extension;                 // ".scene"
    bool (*looksLike)(std::string_view start);  // whether a file that begins so can be of the format
    // Errors name source.name, or a file that `load` gave.
    Result<Scene> (*read)(const SourceText& source, const FileLoader& load);
};
std::span<const Format> formatTable();

// A model's extension decides. Else contents do; the extension, in any case, where several formats or none could begin like
// that. Null where that settles nothing either.
const Format* findFormat(std::string_view start, std::string_view extension);

// "a scene description (.scene), an object description (.des) or …"
std::string knownFormats();

}  // namespace pipeline
