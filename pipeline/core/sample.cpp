#include "pipeline/core/sample.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace pipeline {

namespace {

// How many values may be put aside at either end so that the rest holds the median with a
// probability of at least 95 %: the median lies below the k-th smallest value only when fewer
// than k of n values fall below it, which is binomial with p = 1/2.
// G. J. Hahn, W. Q. Meeker, "Statistical Intervals", Wiley, 1991, section 5.2.
std::optional<std::size_t> valuesAside(std::size_t n) {
    // 2^-n would vanish; the normal distribution is as good by then.
    if (n > 1000) return static_cast<std::size_t>((static_cast<double>(n) - 1.96 * std::sqrt(n)) / 2) - 1;
    double tail = 0, term = std::ldexp(1.0, -static_cast<int>(n));  // P(exactly i of n), i = 0
    std::optional<std::size_t> aside;
    for (std::size_t i = 0; i < n; ++i) {
        tail += term;
        if (tail > 0.025) break;
        aside = i;
        term *= static_cast<double>(n - i) / static_cast<double>(i + 1);
    }
    return aside;
}

}  // namespace

SampleSummary summarize(std::vector<double> values) {
    assert(!values.empty());
    std::ranges::sort(values);
    const std::size_t n = values.size();
    SampleSummary summary;
    summary.min = values.front();
    summary.median = n % 2 == 1 ? values[n / 2] : (values[n / 2 - 1] + values[n / 2]) / 2;
    summary.p95 = values[(95 * n + 99) / 100 - 1];
    if (const auto aside = valuesAside(n)) summary.medianInterval = {values[*aside], values[n - 1 - *aside]};
    return summary;
}

}  // namespace pipeline
