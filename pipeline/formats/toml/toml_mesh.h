#pragma once
#include <optional>
#include <string>

#include "pipeline/formats/toml/toml_values.h"
#include "pipeline/scene/mesh/mesh.h"
#include "pipeline/scene/mesh/shape.h"

namespace pipeline {

// The shape that an object's table asks for, nothing where it asks for none; what is wrong with it is left to who reads
// its keys.
std::optional<Shape> tomlShape(const toml::table& object);

// A mesh that stands in the scene itself:
//     vertices = [[x, y, z], ...]    object space
//     polygons = [[a, b, c, ...]]    indices of vertices, from 0, at least three, counter-clockwise from outside
//     normals = [[x, y, z], ...]     one a vertex, or no such key
//     colors = [[r, g, b], ...]      likewise; 0 and up
// Nothing where something is wrong; `values` has the errors then. Not completed by makeMesh.
std::optional<Mesh> readTomlMesh(const toml::table& object, const std::string& path, TomlValues& values,
                                 const Stop& stop);

}  // namespace pipeline
