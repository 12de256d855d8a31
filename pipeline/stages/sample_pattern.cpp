#include "pipeline/stages/sample_pattern.h"

#include <bit>
#include <random>

namespace pipeline {
namespace {

// 0 <= x < 1. The standard fixes the engine's numbers, but not those of its distributions.
double between0And1(std::mt19937_64& random) { return double(random() >> 11) * 0x1p-53; }

double mirroredDigits(unsigned i) {
    double value = 0, digit = 0.5;
    for (; i > 0; i >>= 1, digit /= 2) value += (i & 1) * digit;
    return value;
}

}  // namespace

std::vector<glm::dvec2> samplePlaces(SamplePattern pattern, int side, unsigned draw) {
    if (side == 1) return {glm::dvec2(0)};
    const int count = side * side;
    std::mt19937_64 random(std::mt19937_64::default_seed + draw);
    std::vector<glm::dvec2> places;
    for (int i = 0; i < count; ++i) {
        const glm::dvec2 cell(i % side, i / side);
        switch (pattern) {
            case SamplePattern::Grid: places.push_back((cell + 0.5) / double(side)); break;
            case SamplePattern::Jittered: {
                const double x = between0And1(random);
                places.push_back((cell + glm::dvec2(x, between0And1(random))) / double(side));
                break;
            }
            case SamplePattern::Random: {
                const double x = between0And1(random);
                places.emplace_back(x, between0And1(random));
                break;
            }
            case SamplePattern::Hammersley:
                places.emplace_back((i + 0.5) / count,
                                    mirroredDigits(unsigned(i)) + 0.5 / std::bit_ceil(unsigned(count)));
                break;
        }
        places.back() -= 0.5;
    }
    return places;
}

}  // namespace pipeline
