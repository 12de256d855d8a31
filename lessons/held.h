#pragma once
#include <optional>
#include <string>
#include <vector>

#include "lessons/lesson_text.h"
#include "lessons/prose.h"
#include "pipeline/scene/hold/hold.h"
#include "pipeline/scene/hold/lecture_text.h"

// What half a page lets a hand move, and what follows the hand: the keys hold, shows, figure, play, strip, pixels and
// file.

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
    Codes,     // where a z-buffer of 16 bits spends its codes
    Row        // the first buffer along the picked pixel's row
};
inline constexpr std::array<std::string_view, 3> kFigureNames{"equation", "codes", "row"};

// The picked pixel, where a hand moves it along one row of the picture.
struct Spot {
    int row = 0;
    std::string name;
};

struct Held {
    std::vector<pipeline::Hold> holds;
    Prose shows;  // plain text with holes that the reader's frame fills; empty: each hold says its value
    std::optional<Figure> figure;
    std::optional<Play> play;
    std::vector<std::string> strip;  // values of the first hold for three pictures on paper: "object.0.rz=20"
    bool hardPixels = false;         // not smoothed
    std::optional<Spot> spot;
    std::string file;                // title of the text of the object whose vertex is held; empty: none
    pipeline::SourceLocation where;  // of the first hold
};

inline constexpr std::array<std::string_view, 7> kHeldKeys{"hold",  "shows",  "figure", "play",
                                                           "strip", "pixels", "file"};

// Of the entries with these keys, others are passed over. What they leave open is as in `held`, but for the play; a half
// that names its own holds has none of those. `names` as in Scope.
Held heldFrom(std::span<const Entry> entries, const pipeline::Scene& scene, const Names& names, Held held,
              Complaints& complaints);

// The two files of lecture 1 that a scene with a held vertex would be: their titles and lines. Empty without the key file.
struct HeldFile {
    std::string title;
    std::vector<pipeline::LectureLine> lines;
};
std::vector<HeldFile> filesOf(const Held& held, const pipeline::Scene& scene);
// The same for a page without a stage, Markdown.
std::string filesText(const Held& held, const pipeline::Scene& scene);

// Buffers that a reader's frame needs for what follows the hand.
pipeline::BufferSet buffersOf(const Held& held);

}  // namespace lessons
