#pragma once
#include <array>

#include "lessons/lesson_text.h"
#include "lessons/state/window_state.h"
#include "pipeline/scene/scene.h"

namespace lessons {

// The keys of a page that say what the window shows: those of a cue. Values for several views stand between ";", one
// value holds for all.
inline constexpr std::array<std::string_view, 27> kWindowKeys{
    "stage", "buffers",   "pixel",   "channel",  "place",  "step",       "algorithm", "arrangement", "linked",
    "pins",  "condition", "mix",     "selected", "shown",  "range",      "overlays",  "counts",      "region",
    "zoom",  "against",   "compare", "wipe",     "metric", "difference", "space",     "camera",      "options"};

// What the window shows after these entries, of whose keys the last counts; others are passed over. Checked against the
// scene. `scene` and `set` of the state stay empty.
WindowState windowFrom(std::span<const Entry> entries, const pipeline::Scene& scene, Complaints& complaints);

}  // namespace lessons
