#pragma once
#include <string>
#include <vector>

#include "pipeline/buffers/buffer_table.h"
#include "pipeline/plan/stage.h"
#include "pipeline/scene/scene.h"

namespace pipeline {

// What a scene and the buffers asked for need of each stage, and why not the rest. Every reason
// here leaves the picture the same, bit for bit; `leave_out = off` turns them all off.

// Empty text: needed. Else the reason it is left out, one sentence.
struct Need {
    std::string notBecause;
    explicit operator bool() const { return notBecause.empty(); }
};

struct Needs {
    Need cull, vertexNormals, shadowBuffers, polygonTerms, vertexTerms;
    std::vector<Need> shadowBuffer, light, specular;  // per light
    bool evaluateAll = false;                         // polygons that culling dropped are evaluated too
};
Needs needsOf(const Scene& scene, BufferSet wanted);

// Why this scene has no use for a buffer, or empty. Such a buffer is left out unless asked for by name.
std::string whyUseless(const Scene& scene, BufferId id);
// All that is left: what an export takes when nothing is named.
BufferSet usefulBuffers(const Scene& scene);

}  // namespace pipeline
