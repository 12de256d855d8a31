#pragma once
#include "pipeline/formats/scene_folder.h"
#include "pipeline/scene/scene.h"

namespace pipeline {

// Moves the objects, whose transforms move nothing yet, so that the middle of their common box is
// the world's origin, and adds a light and a camera that shows all of them, as seen from the
// direction of lecture 1's example.
void showAll(Scene& scene);

// A model as a scene of its own; source.name has its extension. Where the model brings normals,
// it is shaded by Phong's method, with those normals where the settings offer that.
Result<Scene> readModelScene(const SourceText& source, const FileLoader& load);

}  // namespace pipeline
