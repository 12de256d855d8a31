#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace pipeline {

// The shortest text that reads back as the same double: "0.25", "640", "1e9", "-0".
std::string shortestText(double value);
// The same of a value that is refused beyond a bound, rounded to three digits, or to as many as it takes to read as
// another number than the bound: "1.27e9", and "1000000100" beyond 1e9.
std::string textBeyond(double value, double bound);

// "words" in double quotes; control characters are shown as \x1b and more than 60 bytes of it are left out, so that a
// message stays one line whatever the input was.
std::string inQuotes(std::string_view words);

// "1 light", "2 lights".
std::string plural(std::int64_t count, std::string_view noun);

// Whether two words are the same but for the case of A to Z.
bool sameLetters(std::string_view a, std::string_view b);

// How many letters must be changed, added or taken away to make a into b (Levenshtein).
std::size_t editDistance(std::string_view a, std::string_view b);

// The candidate with the smallest edit distance, the first of equals; empty when there is none.
std::string nearest(std::string_view text, std::span<const std::string> candidates);

// What a message says after a word that is none of the known ones: "the nearest is "camera"" where one differs in at most
// a third of the word's letters, or holds it or is held; else "there are "camera", "lights" and "objects"". Of more than 10
// words only their number and the nearest three, then the command that lists all, where there is one.
std::string insteadOf(std::string_view text, std::span<const std::string> known, std::string_view command = {});
// For settings and buffers.
inline constexpr std::string_view kListingCommand = "shadescope plan --json SCENE";

}  // namespace pipeline
