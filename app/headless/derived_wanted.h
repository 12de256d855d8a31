#pragma once
#include <optional>
#include <string>

#include "lessons/derived_buffer.h"
#include "pipeline/core/result.h"
#include "pipeline/core/stop.h"
#include "pipeline/export/export_frame.h"

namespace app {

// What can be made from a frame beside its own buffers.
struct DerivedArgument {
    bool shadowVerdicts = false;
    std::string where, mix;
};

// Why --shadow-verdicts has nothing to say of any light of the scene, if so.
pipeline::Errors noShadowVerdicts(const pipeline::Scene& scene);

// The derived buffers of the options and of `named`, each once, after their names in the table.
// Errors: what is wrong with the words, or why the scene has no such buffer, or a run until `until`, if it ends early.
struct DerivedWanted {
    std::vector<pipeline::BufferName> names;
    lessons::DerivedRecipe recipe;
    pipeline::BufferSet buffers;  // that a frame must hold for them
};
pipeline::Result<DerivedWanted> derivedWanted(const DerivedArgument& argument,
                                              const std::vector<pipeline::BufferName>& named,
                                              const pipeline::Scene& scene, std::optional<pipeline::StageId> until);

// Errors: what cannot be made of this frame, and why. Empty when stopped.
pipeline::Result<std::vector<pipeline::ExportRequest::Derived>> derivedOf(const DerivedWanted& wanted,
                                                                          const pipeline::Frame& frame, int threads,
                                                                          const pipeline::Stop& stop);

}  // namespace app
