#pragma once
#include <functional>
#include <memory>
#include <string>

#include "lessons/expression/condition.h"
#include "pipeline/core/stop.h"
#include "pipeline/inspect/term_mix.h"
#include "pipeline/study/shadow_verdict.h"

namespace lessons {

// What the derived buffers of a frame are made after.
struct DerivedRecipe {
    std::string text{};          // the condition of `condition`, the numbers of `expression`; may be empty
    pipeline::TermMix mix = {};  // of `mix`; empty: every term as it is
    bool operator==(const DerivedRecipe&) const = default;
};

// The buffers that a frame must hold for a derived one. An error says why a scene has no such buffer, or what is wrong
// with the recipe; its place is that in the recipe's text.
pipeline::Result<pipeline::BufferSet> buffersFor(const pipeline::BufferName& name, const DerivedRecipe& recipe,
                                                 const pipeline::Scene& scene);

// Exact rays that were cast, and in which scene.
struct KnownRays {
    std::shared_ptr<const pipeline::Scene> scene;
    pipeline::ExactShadows exact;
};

struct DerivedBuffer {
    pipeline::AnyBuffer buffer;
    std::string meaning;  // one sentence, with what it was made after
    // What else has been found on the way.
    std::size_t clamped = 0;                                     // of `mix`: pixels of which a channel is above I_max
    std::shared_ptr<const pipeline::ShadowVerdicts> verdicts{};  // of `shadow_verdict.k`
    std::shared_ptr<const KnownRays> rays{};                     // likewise
    std::shared_ptr<const ConditionMask> mask{};                 // of `condition`
};

struct DerivedControl {
    int threads = 0;  // 0: as many as the machine has
    pipeline::Stop stop{};
    std::function<void(double share)> progress{};  // of the rays, 0 to 1; on any thread
    std::shared_ptr<const KnownRays> rays{};       // taken where they are those of the frame's scene; may be null
};
// buffersFor() has found no error. An error names the buffer that the frame lacks, or says "stopped".
pipeline::Result<DerivedBuffer> derive(const pipeline::BufferName& name, const DerivedRecipe& recipe,
                                       const pipeline::Frame& frame, const DerivedControl& control = {});

}  // namespace lessons
