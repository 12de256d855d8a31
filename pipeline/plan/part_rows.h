#pragma once
#include "pipeline/plan/part_table.h"
#include "pipeline/scene/model_facts.h"

namespace pipeline {

// The rows of the stages before shading, and of shading, each in the order of Part.
std::span<const PartInfo> partsBeforeShading();
std::span<const PartInfo> partsOfShading();

// What both have in common.

inline constexpr const char* kOutlines = "Outlines are not shaded.";

inline bool outlines(const Scene& scene) { return scene.settings.visibility == Visibility::None; }
inline const ModelFacts& modelOf(const Scene& scene) { return modelFacts(scene.settings.model); }
inline Need only(bool needed, std::string otherwise) { return needed ? Need{} : Need{std::move(otherwise)}; }

// Whether a light adds anything.
Need adding(const Decision& d, const Light& light);

// A buffer is of no use where its part is left out.
template <Part part>
std::string whyNot(const Scene&, const Needs& needs, std::size_t) {
    return needs[part].notBecause;
}

constexpr bool areInOrder(std::span<const PartInfo> rows, Part first) {
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (index(rows[i].id) != index(first) + i || (i > 0 && rows[i].stage < rows[i - 1].stage)) return false;
    return true;
}

}  // namespace pipeline
