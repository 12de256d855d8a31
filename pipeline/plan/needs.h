#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/buffers/buffer_table.h"
#include "pipeline/core/stage.h"
#include "pipeline/scene/scene.h"
#include "pipeline/stages/parts.h"

namespace pipeline {

// What a scene and the buffers asked for need of each stage, and why not the rest. Every reason
// here leaves the picture the same, bit for bit.

// Of a part of a stage. Empty text: needed. Else the reason it is left out, one sentence, and the rule that says so;
// no rule where there is nothing that could be done ("The light casts no shadow."). What is needed and has a rule is left
// out element by element, by the stage itself.
struct Need {
    std::string notBecause{};
    std::optional<Rule> rule{};
    std::string despite{};  // of what is needed only because a rule is off: what it would say, and that it is off
    explicit operator bool() const { return notBecause.empty(); }
    bool isWhole() const { return notBecause.empty() && !rule; }
};

struct Needs {
    std::array<Need, kPartCount> whole;                // by Part; of a part per light, whether it is needed for any
    std::array<std::vector<Need>, kPartCount> lights;  // by Part: per light, where the part is per light
    std::vector<bool> ownNormals;  // per object: no sum around a vertex is read; empty: of every object some may be
    BufferSet buffers;             // those that are made
    RuleSet rules;                 // in force

    const Need& operator[](Part part) const { return whole[index(part)]; }
    const Need& of(Part part, std::size_t light) const { return lights[index(part)][light]; }
    // What a stage carries out of the parts that it reads.
    Parts parts(StageId stage) const;
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
