#pragma once
#include "pipeline/core/stop.h"
#include "pipeline/scene/mesh/mesh.h"

namespace pipeline {

// Closed: there are polygons, and from every vertex to every other at most one edge, and then one back: MeshFacts::closed.
// Turned: where every edge is used twice, but not always there and back, edges that are used twice the same way; else 0.
// Of large meshes a part of the vertices at a time: with memory for some ten million edges' ends, whatever the mesh.
// Neither where it is stopped.
struct EdgeUse {
    bool closed = false;
    std::size_t turned = 0;
};
EdgeUse edgeUseOf(const Mesh& mesh, StopCheck& check);

// Of a closed mesh whose box is known: how many polygons belong to pieces that enclose a negative volume. A piece within
// the box of the others may be the wall of a cavity, and does not count.
std::size_t inwardPolygons(const Mesh& mesh, StopCheck& check);

// Whether a polygon has an area, and is less than 2^-16 times as high as it is long. Float rounds places by 2^-24 of their
// size, and so turns the normal of such a polygon by some 2^-8, half a degree, and more; in a mean of unit normals it counts
// as much as every other.
bool isSliver(const Mesh& mesh, std::size_t polygon);

}  // namespace pipeline
