#include "pipeline/study/analysis_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pipeline/core/text.h"

namespace pipeline {

namespace {

// "4.20e-02" has zeros in its exponent that say nothing.
std::string scientific(double value, int digits) {
    std::string text = fmt::format("{:.{}e}", value, digits);
    const std::size_t e = text.find('e');
    const std::size_t first = text.find_first_not_of("+-0", e + 1);
    return text.substr(0, e + 1) + (text[e + 1] == '-' ? "-" : "") +
           (first == std::string::npos ? "0" : text.substr(first));
}

std::string withUnit(const std::string& number, const std::string& unit) {
    return unit.empty() ? number : fmt::format("{} {}", number, unit);
}

std::string describe(const PointAnalysis& point) { return point.label.empty() ? "the only setting" : point.label; }

// What the error does not count; empty where it counts every pixel.
std::string leftOutSentence(const PointAnalysis& point) {
    const double pixels = point.leftOut.value_or(0);
    if (pixels == 0) return {};
    return fmt::format(" {:.0f} {} not show what the reference shows, and {} not in this error.", pixels,
                       pixels == 1 ? "pixel does" : "pixels do", pixels == 1 ? "is" : "are");
}

constexpr const char* kNoPoint = "No point has both a time and this error.";

}  // namespace

std::string errorText(double error) {
    const double size = std::abs(error);
    if (std::isfinite(size) && size == std::floor(size) && size < 1e6) return fmt::format("{:.0f}", error);
    // 0.0996 reads "0.10", not "1.0e-1", and 999.6 "1000".
    if (size >= 0.0995 && size < 1e4) return fmt::format("{:.{}f}", error, size < 0.995 ? 2 : size < 9.95 ? 1 : 0);
    return scientific(error, 1);
}

std::string errorText(const PointAnalysis& point) {
    if (!point.error) return {};
    const std::string text = errorText(*point.error);
    if (!point.drawn) return text;
    return fmt::format("{} ({} to {})", text, errorText(point.drawn->first), errorText(point.drawn->second));
}

std::string timeText(double milliseconds) {
    if (milliseconds != 0 && milliseconds < 0.000995) return scientific(milliseconds, 2);
    const int digits = milliseconds < 0.00995  ? 5
                       : milliseconds < 0.0995 ? 4
                       : milliseconds < 0.9995 ? 3
                       : milliseconds < 9.995  ? 2
                       : milliseconds < 99.95  ? 1
                                               : 0;
    return fmt::format("{:.{}f}", milliseconds, digits);
}

std::string orderText(double order) {
    const std::string digits = fmt::format("{:.2f}", std::abs(order));
    return order < 0 && digits != "0.00" ? "\u2212" + digits : digits;
}

std::string orderText(const ObservedOrder& order) {
    return order.within ? fmt::format("{} ± {:.2f}", orderText(*order.fit), *order.within) : std::string();
}

std::string pictureSizeText(const StudyReport& report) {
    const bool changes = std::ranges::any_of(
        report.axes, [](const SweepAxis& axis) { return axis.key == "width" || axis.key == "height"; });
    return changes ? "several sizes" : fmt::format("{} × {}", report.width, report.height);
}

std::string withinSentence(std::string label) {
    const auto upper = [](char c) { return c >= 'A' && c <= 'Z'; };
    const auto lower = [](char c) { return c >= 'a' && c <= 'z'; };
    if (label.size() > 1 && upper(label[0]) && lower(label[1])) label[0] = static_cast<char>(label[0] - 'A' + 'a');
    return label;
}

std::string threadsText(int threads) {
    return threads == 0 ? "all threads" : threads == 1 ? "1 thread" : fmt::format("{} threads", threads);
}

std::string measureText(const ErrorChoice& choice) { return fmt::format("{} of {}", choice.measure, choice.buffer); }

std::string measureWithUnit(const StudyAnalysis& analysis) {
    const std::string text = measureText(analysis.choice);
    return analysis.unit.empty() ? text : fmt::format("{} ({})", text, analysis.unit);
}

std::string cheapestSentence(const StudyAnalysis& analysis, double error) {
    if (analysis.byTime.empty()) return kNoPoint;
    const std::string limit = withUnit(shortestText(error), analysis.unit);
    if (const auto found = cheapestWithin(analysis, error)) {
        const PointAnalysis& point = analysis.points[*found];
        return fmt::format("{} up to {} takes at least {} ms: {}.{}", measureText(analysis.choice), limit,
                           timeText(*point.time), describe(point), leftOutSentence(point));
    }
    const std::size_t best =
        *std::ranges::min_element(analysis.byTime, {}, [&](std::size_t i) { return *analysis.points[i].error; });
    const PointAnalysis& point = analysis.points[best];
    return fmt::format("No setting reaches {} up to {}; the best reaches {}: {}.{}", measureText(analysis.choice),
                       limit, errorText(*point.error), describe(point), leftOutSentence(point));
}

std::string bestSentence(const StudyAnalysis& analysis, double milliseconds) {
    if (analysis.byTime.empty()) return kNoPoint;
    if (const auto found = bestWithin(analysis, milliseconds)) {
        const PointAnalysis& point = analysis.points[*found];
        return fmt::format("Within {} ms {} is at best {}: {}.{}", shortestText(milliseconds),
                           measureText(analysis.choice), withUnit(errorText(*point.error), analysis.unit),
                           describe(point), leftOutSentence(point));
    }
    const PointAnalysis& fastest = analysis.points[analysis.byTime.front()];
    return fmt::format("No setting is done within {} ms; the fastest takes {} ms: {}.", shortestText(milliseconds),
                       timeText(*fastest.time), describe(fastest));
}

std::string standing(const StudyAnalysis& analysis, std::size_t point) {
    const PointAnalysis& which = analysis.points[point];
    if (!which.placed()) return which.missing;
    return which.dominatedBy ? describe(analysis.points[*which.dominatedBy]) : "on the front";
}

}  // namespace pipeline
