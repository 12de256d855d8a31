#include "pipeline/inspect/fragment_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pipeline/core/text.h"

namespace pipeline {

std::string_view name(FragmentVerdict verdict) {
    switch (verdict) {
        case FragmentVerdict::WonStays: return "passed, stays";
        case FragmentVerdict::Overwritten: return "overwritten";
        case FragmentVerdict::NotNearer: return "not nearer";
        case FragmentVerdict::PaintedLast: return "painted last, stays";
        case FragmentVerdict::PaintedOver: return "painted over";
        case FragmentVerdict::NotYet: return "not drawn yet";
    }
    return {};
}

std::string fragmentCounts(std::span<const FragmentReport> fragments) {
    const auto count = [fragments](auto holds) {
        return std::ranges::count_if(fragments, holds, &FragmentReport::verdict);
    };
    const auto arrived = count(came);
    const auto painted =
        count([](FragmentVerdict v) { return v == FragmentVerdict::PaintedLast || v == FragmentVerdict::PaintedOver; });
    std::string text = plural(arrived, "fragment") +
                       (painted > 0 ? fmt::format(", {} written", painted) : fmt::format(", {} passed", count(won)));
    if (const auto later = std::ssize(fragments) - arrived; later > 0) text += fmt::format("; {} to come", later);
    return text;
}

std::string depthText(double depth, int digits) {
    if (!std::isfinite(depth)) return "+∞";
    // As many decimals in all of a column, which stays aligned; more where tiny depths are to be told apart.
    const int magnitude = depth == 0 ? 0 : static_cast<int>(std::floor(std::log10(std::abs(depth))));
    return fmt::format("{:.{}f}", depth, std::clamp(digits - 1 - magnitude, 0, digits > 7 ? 340 : 17));
}

ComparisonText comparisonText(const FragmentReport& fragment, const NumberText& chosen, bool isTested) {
    const auto text = [&chosen](double depth, int digits) {
        const auto own = chosen ? chosen(depth) : std::nullopt;
        return own ? *own : depthText(depth, digits);
    };
    constexpr int kMostDigits = 17;  // what tells any two doubles apart
    if (fragment.relation.empty() || !(came(fragment.verdict) || isTested)) return {text(fragment.depth, 7), {}, {}};
    for (int digits = 7;; ++digits) {
        ComparisonText both{text(fragment.depth, digits), std::string(fragment.relation),
                            text(fragment.stored, digits)};
        if (both.depth == both.stored && fragment.depth != fragment.stored && digits < kMostDigits) continue;
        // "636.1 > 0 (the error)": said behind the numbers.
        if (const std::size_t said = both.relation.find(' '); said != std::string::npos) {
            both.stored += both.relation.substr(said);
            both.relation.resize(said);
        }
        return both;
    }
}

}  // namespace pipeline
