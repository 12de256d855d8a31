#pragma once
#include "pipeline/scene/mesh.h"

namespace pipeline {

// Whether there are polygons, and from every vertex to every other at most one edge, and then one back: MeshFacts::closed.
// With memory for about six million edges at a time, whatever the mesh.
bool isClosed(const Mesh& mesh);

}  // namespace pipeline
