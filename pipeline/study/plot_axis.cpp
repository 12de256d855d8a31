#include "pipeline/study/plot_axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace pipeline {

namespace {

double power(int exponent) { return exponent < 0 ? 1 / std::pow(10.0, -exponent) : std::pow(10.0, exponent); }

std::vector<double> timesPowers(const LogAxis& axis, std::initializer_list<double> digits, int every) {
    std::vector<double> values;
    const int first = static_cast<int>(std::floor(std::log10(axis.low)));
    const int last = static_cast<int>(std::ceil(std::log10(axis.high)));
    for (int exponent = first; exponent <= last; ++exponent) {
        if (exponent % every != 0) continue;
        for (const double digit : digits)
            if (const double value = digit * power(exponent); value >= axis.low && value <= axis.high)
                values.push_back(value);
    }
    return values;
}

// "0.200000" and "2." become "0.2" and "2".
void dropZeros(std::string& text) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
}

}  // namespace

std::vector<double> roundSteps(double low, double high, int most) {
    const double range = high - low;
    if (!(range > 0) || !std::isfinite(range)) return {low};
    const int exponent = static_cast<int>(std::floor(std::log10(range / most)));
    double step = power(exponent);
    for (const double digit : {2.0, 5.0, 10.0})
        if (range / step > most) step = digit * power(exponent);
    // k / 10 is rounded once where k · 0.1 would be twice: 0.3, not 0.30000000000000004.
    const double inverse = std::round(1 / step), first = std::ceil(low / step);
    std::vector<double> values;
    // Counted from the first: where neighbours in double are farther apart than steps, k + 1 may be k.
    for (int i = 0; i <= 2 * most; ++i) {
        const double k = first + i, value = step < 1 ? k / inverse : k * step;
        if (value > high) break;
        if (value >= low && (values.empty() || value > values.back())) values.push_back(value);
    }
    return values;
}

double LogAxis::place(double value) const {
    return start + (end - start) * (std::log(value) - std::log(low)) / (std::log(high) - std::log(low));
}

LogAxis axisAround(double smallest, double largest) {
    // A single value stands in the middle of a decade or so.
    const double room = largest > smallest ? std::max(std::pow(largest / smallest, 0.07), 1.25) : 3;
    LogAxis axis;
    // Within what a double holds, whatever the values.
    axis.low = std::max(smallest / room, 1e-307);
    axis.high = std::min(largest * room, 1e307);
    if (!(axis.low < axis.high)) axis = smallest > 1 ? LogAxis{1e306, 1e307} : LogAxis{1e-307, 1e-306};
    return axis;
}

std::vector<Tick> ticksOf(const LogAxis& axis, int most, double plainFrom) {
    const double decades = std::log10(axis.high / axis.low);
    std::vector<double> values;
    if (decades >= 2) {
        for (int every = 1; values.empty() || static_cast<int>(values.size()) > most; ++every)
            values = timesPowers(axis, {1}, every);
    } else {
        values = timesPowers(axis, {1, 2, 5}, 1);
        if (values.size() < 3) values = roundSteps(axis.low, axis.high, std::min(most, 6));
    }
    std::vector<Tick> ticks;
    ticks.reserve(values.size());
    for (const double value : values) ticks.push_back({value, tickText(value, plainFrom)});
    return ticks;
}

std::string tickText(double value, double plainFrom) {
    if (value >= plainFrom * (1 - 1e-12) && value < 1e5) {
        std::string text = fmt::format("{:.6f}", value);
        dropZeros(text);
        return text;
    }
    const std::string text = fmt::format("{:.3e}", value);  // "2.000e-05"
    const std::size_t at = text.find('e');
    std::string digits = text.substr(0, at), exponent = text.substr(at + 1);
    dropZeros(digits);
    const bool negative = exponent[0] == '-';
    exponent.erase(0, std::min(exponent.find_first_not_of("+-0"), exponent.size() - 1));
    return fmt::format("{}e{}{}", digits, negative ? "-" : "", exponent);
}

}  // namespace pipeline
