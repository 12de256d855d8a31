#pragma once
#include <array>

#include "pipeline/compare/reference.h"

namespace pipeline::foreign {

// What became of a pixel, a vertex or a polygon.
enum class Class : std::uint8_t { Equal, Tolerated, Allowed, Wrong, Missing, Extra, Left };
inline constexpr std::size_t kClassCount = 7;
std::string_view name(Class of);  // "equal", "within tolerance", …
constexpr bool isBad(Class of) { return of == Class::Wrong || of == Class::Missing || of == Class::Extra; }

// One buffer of theirs beside ours.
struct Finding {
    HandedName name;
    std::string file;
    StageId stage = StageId::Shading;
    Reading reading;
    std::vector<Class> classes;  // per element
    std::array<std::size_t, kClassCount> counts{};
    std::size_t columns = 1;
    std::size_t compared = 0;  // all but those left out and those where nothing is in either
    double largest = 0;        // of the elements that are compared and not allowed
    double rms = 0;
    double tolerance = 0;
    std::string_view unit;
    std::optional<std::size_t> worst;  // the largest difference of those wrong, missing or extra
    std::size_t nan = 0, infinite = 0;
    bool agrees = true;

    std::size_t count(Class of) const { return counts[std::size_t(of)]; }
    std::size_t bad() const { return count(Class::Wrong) + count(Class::Missing) + count(Class::Extra); }
    bool isPicture() const { return bufferInfo(name.buffer.id).domain == Domain::Pixel; }
};

// The share of the elements that may be wrong in a buffer that agrees: of pixels, as rasterizers differ in ways that a
// neighbourhood of one pixel does not explain.
inline constexpr double kStrayPixels = 0.001;
inline constexpr double kStrayTexels = 0.01;  // of a shadow buffer, whose frame is found, not known

Finding compareValues(const ReadFile& file, const Reference& reference);
// The same of values that somebody else has made: `right` takes the place of the reference's.
Finding compareValues(const ReadFile& file, const Values& right, const Reference& reference);

// Without those of these elements that are wrong: they are not compared then. May be empty.
void leaveOut(const std::vector<std::uint8_t>& elements, Finding& finding);

// "pixel 185, 105", "vertex 65", "polygon 3".
std::string placeText(const Finding& finding, std::size_t element);
// "85 42 20", "(0.831, 0.388, 0.398)", "nothing"
std::string valueText(const Finding& finding, const Values& values, std::size_t element);
// "308 of 500 differ, up to 51.1°", "1.4e-5 px", "25454 equal, 24 within 2 of 255"
std::string findingText(const Finding& finding);
std::string toleranceText(const Finding& finding);
std::string shortNumber(double value);

}  // namespace pipeline::foreign
