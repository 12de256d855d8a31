#pragma once
#include <cstdint>
#include <vector>

#include "pipeline/scene/scene.h"

namespace pipeline {

// Alpha as it acts: clamped to [0, 1].
double opacity(const Material& material);

// Which sides of an object are translucent, with an opacity below 1. The back has a say of its own
// where two-sided lighting gives it a material; else it is as the front.
struct TranslucentSides {
    bool front = false, back = false;
    bool operator==(const TranslucentSides&) const = default;
};
// Per object; empty when everything is opaque.
std::vector<TranslucentSides> translucentSides(const Scene& scene);

// Whether an object has opacity 0 on both sides: it draws nothing and casts no shadow, as if it were not there.
bool isTransparent(const Object& object, const Settings& settings);
// Per object, 1 where it is; empty when none is.
std::vector<std::uint8_t> transparentObjects(const Scene& scene);

}  // namespace pipeline
