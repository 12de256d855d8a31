#pragma once
#include <optional>
#include <string>

#include "pipeline/formats/toml_values.h"
#include "pipeline/scene/mesh.h"

namespace pipeline {

// A mesh that stands in the scene itself:
//     vertices = [[x, y, z], ...]    object space
//     polygons = [[a, b, c, ...]]    indices of vertices, from 0, at least three, counter-clockwise from outside
//     normals = [[x, y, z], ...]     one a vertex, or no such key
// Nothing where something is wrong; `values` has the errors then. Not completed by makeMesh.
std::optional<Mesh> readTomlMesh(const toml::table& object, const std::string& path, TomlValues& values);

}  // namespace pipeline
