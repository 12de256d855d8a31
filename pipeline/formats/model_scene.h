#pragma once
#include "pipeline/formats/scene_folder.h"
#include "pipeline/scene/scene.h"

namespace pipeline {

// A model as a scene of its own, framed (pipeline/scene/framing.h); source.name has its extension. Where the model brings
// normals, it is shaded by Phong's method, with those normals where the settings offer that.
Result<Scene> readModelScene(const SourceText& source, const FileLoader& load);

}  // namespace pipeline
