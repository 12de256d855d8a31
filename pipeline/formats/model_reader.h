#pragma once
#include <span>
#include <string_view>
#include <vector>

#include "pipeline/core/result.h"
#include "pipeline/formats/scene_folder.h"
#include "pipeline/scene/scene.h"

namespace pipeline {

// Models: meshes with materials, but without lights and a camera. OBJ with MTL, PLY, STL, glTF 2.
// Polygons stay polygons; normals that the file gives stand in Mesh::normals.

// Whether a file of this extension (".obj", in any case) is a model.
bool isModel(std::string_view extension);

struct LoadedModel {
    std::vector<Object> objects;    // each has at least one polygon
    std::vector<Remark> remarks{};  // about what the file has and the reader leaves out
    bool doubleSided = false;       // a material's back faces are to be seen as well
};

// Files that the model names (materials, glTF buffers) come from `load`.
Result<LoadedModel> readModel(const SourceText& source, std::string_view extension, const FileLoader& load);

}  // namespace pipeline
