#include "pipeline/scene/hold/hold.h"

#include <array>
#include <cmath>

#include "pipeline/scene/hold/hold_kinds.h"

namespace pipeline {

namespace {

// In the order of the enumerators.
constexpr std::array kRows{&kLampAtInfinity, &kLampFoot, &kLampTop, &kEye, &kTurn, &kAlong, &kVertex, &kRim, &kNumber};
const HoldKindRow& rowOf(Hold::Kind kind) { return *kRows[std::size_t(kind)]; }

std::string minusSigns(std::string text) {
    for (std::size_t at = 0; (at = text.find('-', at)) != text.npos; at += 3) text.replace(at, 1, "−");
    return text;
}

}  // namespace

std::string_view name(Hold::Kind kind) { return rowOf(kind).name; }
bool movesObject(const Hold& hold) { return rowOf(hold.kind).movesObject; }
bool hasEnds(const Hold& hold) { return rowOf(hold.kind).hasEnds; }

std::optional<HoldPlace> placeOf(const Scene& scene, const Hold& hold) { return rowOf(hold.kind).place(scene, hold); }

Assignments valuesOf(const Scene& scene, const Hold& hold) {
    Assignments values;
    for (const std::string& key : hold.keys) values.emplace_back(key, valueOf(scene, key));
    return values;
}

Assignments valuesAt(const Scene& start, const Hold& hold, glm::dvec2 from, glm::dvec2 to, bool coarse) {
    const auto place = placeOf(start, hold);
    const bool isFinite = std::isfinite(from.x) && std::isfinite(from.y) && std::isfinite(to.x) && std::isfinite(to.y);
    if (!place || !isFinite) return valuesOf(start, hold);
    return rowOf(hold.kind).dragged(start, hold, {place->at, from, to, coarse});
}

Assignments nudged(const Scene& scene, const Hold& hold, glm::ivec2 by, bool coarse) {
    return rowOf(hold.kind).nudged(scene, hold, by, coarse);
}

std::string wordsOf(const Scene& scene, const Hold& hold) { return minusSigns(rowOf(hold.kind).words(scene, hold)); }

}  // namespace pipeline
