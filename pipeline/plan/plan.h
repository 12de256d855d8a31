#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/plan/stage_keys.h"

namespace pipeline {

// Why a stage runs that never has.
inline constexpr std::string_view kNotRunYet = "It has not run yet.";

enum class Action : std::uint8_t { Run, Reuse, LeaveOut };
std::string_view name(Action action);  // "runs", "reused", "left out"

// A part of a stage that may be left out by itself.
struct PlanPart {
    std::string name;  // "vertex normals", "light 0", "specular of light 1"
    Action action;
    std::string why;    // one sentence
    std::string saves;  // when left out: "1 pass, 4.2 MB"; may be empty
    // The rule that leaves it out, or that leaves out some of it while it runs; nothing where the
    // scene has no such part at all.
    std::optional<Rule> rule{};
};

struct PlanStep {
    StageId stage;
    Action action;
    std::string why;  // one sentence: "Material 0 changed.", "No light casts a shadow."
    std::optional<Rule> rule{};
    std::vector<PlanPart> parts;
    // Of shading where nothing but materials, or intensities and colours of light, has changed: whether N·L, highlights
    // and S at pixels are reused, or found and kept for the next such frame, or not kept. Nothing where more has changed.
    std::optional<PlanPart> incidence{};
};

// One step per stage, in the order of kStages: what a frame will do, decided before anything runs.
using Plan = std::array<PlanStep, kStageCount>;

// What the frame before has left; nothing where there is none in the same precision.
struct Past {
    const StageKeys* keys = nullptr;
    std::array<bool, kStageCount> has{};  // the stage's output
    bool keptIncidence = false;
    BufferSet made;
    long number = 0;  // of that frame
};

// What each stage does up to `until`, and why, without its parts; those are for readers, and explain adds them.
Plan decide(const Needs& needs, StageId until, const StageKeys& keys, const Past& past);
void explain(const Scene& scene, const Needs& needs, Plan& plan);

}  // namespace pipeline
