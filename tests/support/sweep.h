#pragma once
#include <cstddef>
#include <cstdlib>
#include <vector>

namespace test {

// Whether this run has time for every sample of a long sweep: ./test --long sets SHADESCOPE_LONG to 1.
inline bool longRun() {
    const char* value = std::getenv("SHADESCOPE_LONG");
    return value && *value && *value != '0';
}

// Which of the samples 0 .. n - 1 a test takes, ascending: all of them in a long run, else at most `few` that are evenly
// spread, the first and the last among them.
inline std::vector<std::size_t> sweep(std::size_t n, bool all = longRun(), std::size_t few = 50) {
    const std::size_t taken = all || n < few ? n : few;
    std::vector<std::size_t> samples;
    for (std::size_t i = 0; i < taken; ++i) samples.push_back(taken == n ? i : i * (n - 1) / (taken - 1));
    return samples;
}

}  // namespace test
