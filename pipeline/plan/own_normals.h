#pragma once
#include <vector>

#include "pipeline/scene/scene.h"

namespace pipeline {

// Per object, whether the normals that its mesh gives are certain to be its vertices' normals, decided before any vertex
// is transformed: no vertex is without one, and none becomes 0 on its way to the world, where the sum of the polygon
// normals around the vertex would stand in. Empty where the setting normals asks for no given normals.
std::vector<bool> objectsOfOwnNormals(const Scene& scene);

// Whether the polygons of all objects, or of any, are lit with the given normal of their first vertex in flat shading.
bool allLitByFirstVertex(const Scene& scene);
bool anyLitByFirstVertex(const Scene& scene);

}  // namespace pipeline
