#include "pipeline/defects/own_judge.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "pipeline/core/numerics.h"

namespace pipeline {
namespace {

constexpr double kNotANumber = std::numeric_limits<double>::infinity();

double angleAndLength(Vec3d a, Vec3d b) {
    const double la = glm::length(a), lb = glm::length(b);
    return std::max(angleBetween(a, b) * 180 / std::numbers::pi, 100 * std::abs(la - lb) / std::max({1.0, la, lb}));
}

bool agree(const OwnContract& contract, const std::optional<OwnValue>& mine, const OwnValue& right) {
    return differenceOf(contract, mine, right) <= contract.tolerance;
}

}  // namespace

double differenceOf(const OwnContract& contract, const std::optional<OwnValue>& mine, const OwnValue& right) {
    if (!mine) return kNotANumber;
    Vec3d apart(0);
    for (std::size_t i = 0; i < contract.size(); ++i) {
        const double a = mine->at[i], b = right.at[i];
        if (a == b || (std::isnan(a) && std::isnan(b))) continue;
        if (!std::isfinite(a) || !std::isfinite(b)) return kNotANumber;
        apart[int(i)] = std::abs(a - b);
        if (contract.measure == OwnMeasure::Relative) apart[int(i)] /= std::max(std::abs(b), 1e-12);
    }
    switch (contract.measure) {
        case OwnMeasure::Same:
        case OwnMeasure::Relative:
        case OwnMeasure::Largest: return largestComponent(apart);
        case OwnMeasure::Distance: return glm::length(apart);
        case OwnMeasure::Angle:
            if (apart == Vec3d(0)) return 0;
            return angleAndLength({mine->at[0], mine->at[1], mine->at[2]}, {right.at[0], right.at[1], right.at[2]});
    }
    return kNotANumber;
}

OwnVerdict judgeOwn(const OwnContract& contract, const std::vector<OwnElement>& elements, const OwnResults& mine) {
    OwnVerdict verdict;
    verdict.all = elements.size();
    std::vector<bool> isWrong(elements.size());
    for (std::size_t i = 0; i < elements.size(); ++i) {
        isWrong[i] = !agree(contract, mine[i], elements[i].right);
        verdict.wrong += isWrong[i];
        if (isWrong[i] && !verdict.first) verdict.first = i;
    }
    if (verdict.isRight()) return verdict;
    std::size_t best = 0;
    for (const OwnMistake& mistake : contract.mistakes) {
        std::size_t said = 0, explained = 0;
        for (std::size_t i = 0; i < elements.size(); ++i) {
            const OwnValue predicted = valueOf(contract, mistake.formula, elements[i].in);
            if (!isWrong[i] && agree(contract, predicted, elements[i].right)) continue;
            ++said, explained += agree(contract, mine[i], predicted);
        }
        if (100 * explained < 99 * said) continue;
        // Those that explain all are better than those that nearly do.
        const std::size_t rank = explained == said ? 2 : 1;
        if (rank > best) verdict.names.clear(), best = rank;
        if (rank == best) verdict.names.push_back(&mistake);
    }
    return verdict;
}

}  // namespace pipeline
