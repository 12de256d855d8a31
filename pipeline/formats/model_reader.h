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

// The objects of a model. Files that it names (materials, glTF buffers) come from `load`.
Result<std::vector<Object>> readModel(const SourceText& source, std::string_view extension, const FileLoader& load);

}  // namespace pipeline
