#pragma once
#include <string>

#include "pipeline/scene/scene.h"

namespace pipeline {

// Why what the stages would leave of vertices is what the mesh has, to the last bit, so that no copy is made; empty where
// it is not. There is one object, its matrix is the identity, and the mesh keeps the numbers in the scene's precision.

// Their places in world space.
std::string whyPlacesStay(const Scene& scene);
// Their normals, given by the mesh at length 1.
std::string whyNormalsStay(const Scene& scene);

}  // namespace pipeline
