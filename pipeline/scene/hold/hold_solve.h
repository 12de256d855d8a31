#pragma once
#include "pipeline/scene/hold/hold_kinds.h"

namespace pipeline {

inline constexpr double kLeastMotion = 24;  // pixels over the whole range: less has no direction in the picture

// The scene with other values, which are not checked.
Scene withValues(Scene scene, const Assignments& values);

// The unknowns with which placeOf is nearest to `to`, by Newton's method. Nothing where the picture does not move with them.
template <std::size_t n, class AsValues>
std::optional<std::array<double, n>> solved(const Scene& scene, const Hold& hold, glm::dvec2 to,
                                            std::array<double, n> t, double reach, AsValues asValues) {
    const auto place = [&](const std::array<double, n>& at) -> std::optional<glm::dvec2> {
        const auto found = placeOf(withValues(scene, asValues(at)), hold);
        return found ? std::optional(found->at) : std::nullopt;
    };
    auto now = place(t);
    for (int round = 0; now && round < 8 && glm::length(to - *now) > 0.01; ++round) {
        std::array<glm::dvec2, n> moves;  // by one unit of each unknown
        for (std::size_t i = 0; i < n; ++i) {
            std::array<double, n> beside = t;
            beside[i] += reach * 1e-5;
            const auto at = place(beside);
            if (!at) return {};
            moves[i] = (*at - *now) / (reach * 1e-5);
        }
        const glm::dvec2 missing = to - *now;
        std::array<double, n> step;
        if constexpr (n == 1) {
            const double square = glm::dot(moves[0], moves[0]);
            if (std::sqrt(square) * reach < kLeastMotion) return {};
            step[0] = glm::dot(moves[0], missing) / square;
        } else {
            const double determinant = moves[0].x * moves[1].y - moves[1].x * moves[0].y;
            if (std::abs(determinant) * reach * reach < kLeastMotion * kLeastMotion) return {};
            step[0] = (missing.x * moves[1].y - moves[1].x * missing.y) / determinant;
            step[1] = (moves[0].x * missing.y - missing.x * moves[0].y) / determinant;
        }
        // A step that leads away, or behind the eye, is halved.
        double share = 1;
        std::optional<glm::dvec2> next;
        std::array<double, n> there = t;
        for (int tries = 0; tries < 12; ++tries, share /= 2) {
            for (std::size_t i = 0; i < n; ++i) there[i] = t[i] + share * step[i];
            next = place(there);
            if (next && glm::length(to - *next) < glm::length(missing)) break;
            next.reset();
        }
        if (!next) break;  // as near as it gets
        t = there, now = next;
    }
    return now ? std::optional(t) : std::nullopt;
}

}  // namespace pipeline
