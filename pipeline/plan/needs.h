#pragma once
#include <optional>
#include <string>
#include <vector>

#include "pipeline/buffers/buffer_table.h"
#include "pipeline/plan/stage.h"
#include "pipeline/scene/scene.h"

namespace pipeline {

// What a scene and the buffers asked for need of each stage, and why not the rest. Every reason
// here leaves the picture the same, bit for bit.

// Empty text: needed. Else the reason it is left out, one sentence, and the rule that says so;
// no rule where there is nothing that could be done ("The light casts no shadow.").
struct Need {
    std::string notBecause{};
    std::optional<Rule> rule{};
    std::string despite{};  // of what is needed only because a rule is off: what it would say, and that it is off
    explicit operator bool() const { return notBecause.empty(); }
};

struct Needs {
    Need modelTransform, unitNormals;   // copies of what the mesh has: places, and given normals at length 1
    Need cull, shadowBuffers, normals;  // whole stages
    Need polygonNormals, vertexNormals;
    Need normalSums;               // of polygon normals, around vertices
    std::vector<bool> ownNormals;  // per object: none of these sums is read; empty: of every object some may be
    Need polygonTerms, vertexTerms, ambient, position, viewVector;
    Need depthTest;                                                // of fragments at a pixel
    Need seenPolygons, fragmentCounts, weights;                    // what stage 5 leaves beside distances
    Need reflection, halfway;                                      // R and H
    Need vectorShading;                                            // several pixels at a time
    bool fast = false;                                             // these in the arithmetic `fast`
    Need layers, layerSort;                                        // of translucent polygons
    std::vector<Need> shadowBuffer, light, specular, attenuation;  // per light
    bool hiddenPolygons = false, hiddenVertices = false;           // what nobody can see is evaluated too
    BufferSet buffers;                                             // those that are made
    RuleSet rules;                                                 // in force
};
// until: the stage after which the run ends.
Needs needsOf(const Scene& scene, BufferSet wanted, StageId until = StageId::Shading);

// The normals that a scene is shaded with: what a run that ends earlier has to be asked for where they are looked at.
BufferSet normalsOfShading(const Scene& scene);

// Why this scene has no use for a buffer, or empty. Such a buffer is left out unless asked for by name.
std::string whyUseless(const Scene& scene, BufferId id);
// All that is left: what an export takes when nothing is named.
BufferSet usefulBuffers(const Scene& scene);

}  // namespace pipeline
