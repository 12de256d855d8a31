#pragma once
#include <string>
#include <vector>

namespace pipeline {

// 0, 20, 40, …: multiples of 1, 2 or 5 times a power of ten from low to high, ascending, at most about `most` (at least
// 1). `low` alone where there is no range between the two, or none that is finite.
std::vector<double> roundSteps(double low, double high, int most);

// A logarithmic axis from `low` to `high`, which lie a little outside of the values, at the ends of
// a line from `start` to `end` in points.
struct LogAxis {
    double low = 1, high = 10;
    double start = 0, end = 1;
    double place(double value) const;  // value > 0
};

// The range with room around values from smallest to largest, both above 0.
LogAxis axisAround(double smallest, double largest);

struct Tick {
    double value;
    std::string label;  // empty for a line without a number
};

// Round values on an axis, at most about `most`: powers of ten (each, or each second, …) over two
// decades and more; below that 1, 2 and 5 times a power; then roundSteps. plainFrom as in
// tickText.
std::vector<Tick> ticksOf(const LogAxis& axis, int most, double plainFrom);

// "0.2", "20", "1e-3", "1e5": without a power of ten from plainFrom, at least 1e-4, to below 1e5.
std::string tickText(double value, double plainFrom);

}  // namespace pipeline
