#pragma once
#include <string>
#include <vector>

#include "pipeline/scene/scene.h"

namespace twin {

struct NamedScene {
    std::string name;
    pipeline::Scene scene;
};

// Lecture 1's sample code.
pipeline::Scene lectureCube();
// One scene for each of OpenGL's features.
std::vector<NamedScene> featureScenes();
// Spheres and boxes, lights of every kind, materials, camera and settings, different for every seed.
pipeline::Scene randomGlScene(unsigned seed);

}  // namespace twin
