#pragma once
#include <stop_token>
#include <string>

#include "pipeline/core/result.h"
#include "pipeline/export/export_frame.h"

namespace CLI {
class App;
}

namespace app {

// What can be made from a frame beside its own buffers.
struct DerivedArgument {
    bool shadowVerdicts = false;
    std::string where, mix;
    bool any() const { return shadowVerdicts || !where.empty() || !mix.empty(); }
};
void declareDerived(CLI::App& command, DerivedArgument& argument);

// The buffers that a frame must hold for it. Errors: what is wrong with the words.
pipeline::Result<pipeline::BufferSet> buffersFor(const DerivedArgument& argument, const pipeline::Scene& scene);
// Errors: what cannot be made of this frame, and why. Empty when stopped.
pipeline::Result<std::vector<pipeline::ExportRequest::Derived>> derivedOf(const DerivedArgument& argument,
                                                                          const pipeline::Frame& frame, int threads,
                                                                          std::stop_token stop);

}  // namespace app
