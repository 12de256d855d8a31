#pragma once
#include <optional>
#include <string>
#include <vector>

#include "lessons/lesson_text.h"
#include "lessons/prose.h"
#include "pipeline/scene/hold.h"

// What half a page lets a hand move, and what follows the hand: the keys hold, shows, figure, play, strip and pixels.

namespace lessons {

// Something to do before the question. It has no points and no wrong, and blocks nothing.
struct Play {
    std::string text;  // "Drag the lamp. Make the ringed point as dark as you can."
    Expression until;  // a condition on the reader's frame
    std::string done;  // what stands in its place once the condition has been true
    pipeline::SourceLocation where;
};

// Stands below the picture and follows the hand.
enum class Figure : std::uint8_t {
    Equation,  // the terms of the picked pixel, in the page's channel
    Codes      // where a z-buffer of 16 bits spends its codes
};
inline constexpr std::array<std::string_view, 2> kFigureNames{"equation", "codes"};

struct Held {
    std::vector<pipeline::Hold> holds;
    Prose shows;  // plain text with holes that the reader's frame fills; empty: each hold says its value
    std::optional<Figure> figure;
    std::optional<Play> play;
    std::vector<std::string> strip;  // values of the first hold for three pictures on paper: "object.0.rz=20"
    bool hardPixels = false;         // not smoothed
    pipeline::SourceLocation where;  // of the first hold
};

inline constexpr std::array<std::string_view, 6> kHeldKeys{"hold", "shows", "figure", "play", "strip", "pixels"};

// Of the entries with these keys, others are passed over. What they leave open is as in `held`, but for the play; a half
// that names its own holds has none of those. `names` as in Scope.
Held heldFrom(std::span<const Entry> entries, const pipeline::Scene& scene, const Names& names, Held held,
              Complaints& complaints);

// Buffers that a reader's frame needs for what follows the hand.
pipeline::BufferSet buffersOf(const Held& held);

}  // namespace lessons
