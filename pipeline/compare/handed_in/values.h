#pragma once
#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/buffers/any_buffer.h"
#include "pipeline/core/real.h"

// What two renderers have made of one scene, side by side.
namespace pipeline::foreign {

// A buffer as numbers, whoever has made it: row 0 on top, in the units and the space of this program.
struct Values {
    Domain domain = Domain::Pixel;
    std::size_t rows = 0, columns = 1;
    int channels = 1;
    std::vector<double> numbers;      // rows · columns · channels
    std::vector<std::uint8_t> there;  // per element: something is there, and its numbers are finite
    // Per element what the file's steps leave open beyond the tolerance, in the buffer's unit; below 0 where its steps are
    // finer than the buffer's own. May be empty.
    std::vector<double> slack{};
    double allowed(std::size_t element, double tolerance) const {
        if (slack.empty()) return tolerance;
        return std::max(tolerance + slack[element], tolerance / 64);
    }

    std::size_t count() const { return rows * columns; }
    const double* at(std::size_t element) const { return numbers.data() + element * std::size_t(channels); }
    double* at(std::size_t element) { return numbers.data() + element * std::size_t(channels); }
    bool isSameSize(const Values& other) const {
        return rows == other.rows && columns == other.columns && channels == other.channels;
    }
};

// Of this program. covered: per pixel whether the z-buffer has a surface; for buffers of pixels alone. Codes of verdicts
// and whether a vertex has a position are taken into account.
Values valuesOf(const AnyBuffer& buffer, const std::vector<std::uint8_t>& covered);

// How two elements of a buffer are compared, and what is still called the same.
enum class Measure : std::uint8_t {
    Largest,   // the largest difference of a channel
    Distance,  // of two points
    Angle,     // between two directions, degrees; lengths are told apart too: 0.01 counts as 1 degree
    Same,      // names
};
struct Tolerance {
    BufferId buffer;
    Measure measure;
    double value;
    enum class Of : std::uint8_t { Unit, DepthRange, IMax, Scene } of;  // what `value` is a share of
    std::string_view unit;
};
// In the order of the table of buffers: those that are compared.
std::span<const Tolerance> toleranceTable();
const Tolerance* toleranceOf(BufferId buffer);  // null: not compared

// Of one element. NaN where one of the two is not there.
double differenceAt(Measure measure, const Values& mine, const Values& reference, std::size_t element);
// Of an element of theirs and another one of the reference.
double differenceBetween(Measure measure, const Values& mine, std::size_t element, const Values& reference,
                         std::size_t other);

}  // namespace pipeline::foreign
