#include "tests/support/triangles.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "pipeline/compare/coverage_verifier.h"

namespace test {

std::vector<ScreenTriangle> randomTriangles(unsigned seed, std::size_t count, int size, double reach, int bits) {
    std::mt19937 random(seed);
    const auto between = [&](double low, double high) {
        return low + (high - low) * (double(random()) / double(std::mt19937::max()));
    };
    const auto place = [&] { return glm::dvec2{between(0, size), between(0, size)}; };
    const auto aside = [&](double by) { return glm::dvec2{between(-by, by), between(-by, by)}; };
    std::vector<ScreenTriangle> triangles;
    while (triangles.size() < count) {
        const glm::dvec2 p = place();
        ScreenTriangle t{p, place(), place()};
        switch (random() % 7) {
            case 0: break;
            case 1: t = {p, p + aside(1), p + aside(1)}; break;
            case 2: t[2] = t[0] + between(0, 1) * (t[1] - t[0]) + aside(std::exp2(-between(0, 12))); break;
            case 3: t = {p + aside(reach), p + aside(reach), p + aside(reach)}; break;
            case 4: t = {p, p + aside(6), p + aside(6)}; break;
            case 5:  // corners and centres of pixels
                for (glm::dvec2& v : t) v = glm::floor(2.0 * v) / 2.0;
                break;
            case 6:
                if (!triangles.empty()) t = {triangles.back()[2], triangles.back()[1], place()};
                break;
        }
        const double steps = std::exp2(bits);
        for (glm::dvec2& v : t) v = glm::clamp(glm::round(v * steps) / steps, -reach, size + reach);
        if (random() % 2) std::swap(t[1], t[2]);
        triangles.push_back(t);
    }
    return triangles;
}

void CoverageViolations::add(const std::vector<ScreenTriangle>& triangles, const std::vector<int>& ids, int size,
                             int bits) {
    using pipeline::foreign::Coverage;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const auto verifier = pipeline::foreign::CoverageVerifier::make(triangles[i], bits);
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) {
                const int seen = ids[std::size_t(y * size + x)];
                if (seen > int(i)) continue;  // one that is nearer
                const Coverage coverage = verifier->at({x, y});
                missing += coverage == Coverage::Forced && seen != int(i);
                extra += coverage == Coverage::Forbidden && seen == int(i);
                decided += coverage == Coverage::Forced;
            }
        }
    }
}

}  // namespace test
