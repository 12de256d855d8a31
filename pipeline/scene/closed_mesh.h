#pragma once
#include "pipeline/core/stop.h"
#include "pipeline/scene/mesh.h"

namespace pipeline {

// Whether there are polygons, and from every vertex to every other at most one edge, and then one back: MeshFacts::closed.
// Of large meshes a part of the vertices at a time: with memory for some ten million edges' ends, whatever the mesh.
// False where it is stopped.
bool isClosed(const Mesh& mesh, StopCheck& check);

}  // namespace pipeline
