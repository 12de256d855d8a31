#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "lessons/questions/typed_number.h"

namespace lessons {

// A wrong number that the program recognises in every lesson.
struct KnownMistake {
    std::string_view id;  // a row of lessons/misconceptions.md
    std::string said;     // one or two sentences
};
// Other sign, factor 2, radians for degrees and back, the cosine for its angle, a power of ten. unit: of the answer, where
// it decides ("°", "rad").
std::optional<KnownMistake> knownMistake(const TypedNumber& typed, double answer, double tolerance,
                                         std::string_view unit);

// Whether a typed number is meant to be `value`: within the tolerance, or rounded to it in its last digit. Never so
// coarse that it could be another number: at most a twentieth of the value off.
bool isMeant(const TypedNumber& typed, double value, double tolerance);

// Whether the answer rounded to the digits that were typed is what was typed.
bool hasTooFewDigits(const TypedNumber& typed, double answer);

}  // namespace lessons
