#include "lessons/questions/known_mistakes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "pipeline/core/angles.h"
#include "pipeline/core/elementary.h"

namespace lessons {

namespace {

constexpr double kRounding = 0.005, kMostOff = 0.05, kMostCoarse = 0.2;  // of a value
constexpr int kMostPower = 6;
constexpr double kDegree = std::numbers::pi / 180;

constexpr std::array<std::string_view, 10> kSuperscripts{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};

}  // namespace

bool isMeant(const TypedNumber& typed, double value, double tolerance) {
    const double size = std::abs(value);
    const double off = value == 0 ? tolerance : std::min(tolerance, kMostOff * size);
    const double rounded = std::min(typed.lastPlace / 2, kRounding * size);
    return std::abs(typed.value - value) <= std::max(off, rounded);
}

bool hasTooFewDigits(const TypedNumber& typed, double answer) {
    const double half = typed.lastPlace / 2;
    return half > 0 && half <= kMostCoarse * std::abs(answer) && std::abs(typed.value - answer) <= half;
}

std::optional<KnownMistake> knownMistake(const TypedNumber& typed, double answer, double tolerance,
                                         std::string_view unit) {
    if (answer == 0) return {};
    const double size = std::abs(answer);
    const auto means = [&](double value, double scale) { return isMeant(typed, value, tolerance * scale); };
    if (means(-answer, 1)) return KnownMistake{"sign", "The size is right, the sign is the other one."};
    const bool isDegrees = unit == "°" || unit == "degrees";
    if (isDegrees && means(answer * kDegree, kDegree))
        return KnownMistake{"radians", "That is the angle in radians. The question asks for degrees."};
    if (unit == "rad" && means(answer / kDegree, 1 / kDegree))
        return KnownMistake{"degrees", "That is the angle in degrees. The question asks for radians."};
    if (isDegrees && means(pipeline::cosDegrees(answer), kDegree))
        return KnownMistake{"cos-for-angle", "That is the cosine of the angle. The question asks for the angle."};
    if (means(2 * answer, 2)) return KnownMistake{"twice", "That is twice as much."};
    if (means(answer / 2, 0.5)) return KnownMistake{"half", "That is half as much."};
    for (int power = 1; power <= kMostPower; ++power) {
        const double factor = std::pow(10.0, power);
        const bool more = means(answer * factor, factor);
        if (!more && !means(answer / factor, 1 / factor)) continue;
        return KnownMistake{"power-of-ten",
                            fmt::format("The digits are right. The number is too {} by a factor of 10{}.",
                                        more == (typed.value > 0) || size == 0 ? "large" : "small",
                                        power == 1 ? "" : kSuperscripts[std::size_t(power)])};
    }
    return {};
}

}  // namespace lessons
