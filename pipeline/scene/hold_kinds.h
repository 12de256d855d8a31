#pragma once
#include "pipeline/scene/hold.h"

// Kinds of holds with a file of their own, for hold.cpp alone. Places are pixels of the picture, values are always finite.

namespace pipeline {

// The power of ten at or below it; to a multiple of a power of ten.
double powerBelow(double unit);
double roundedTo(double value, double step);

// Of a number: its place on the track, 0 to 1; to two digits where the track has equal factors, else to a two hundredth of
// it, whole where the setting is.
double shareOf(const Hold& hold, double value);
double numberNear(const Scene& scene, const Hold& hold, double value, bool coarse);

Vec3d vertexInWorld(const Scene& scene, const Hold& hold);
// With the vertex at `to` in its plane, as near as its polygons allow.
Assignments vertexAt(const Scene& scene, const Hold& hold, glm::dvec2 to, bool coarse);

// To the right of the highlight's middle. Nothing where the ball has no light, or is not in the picture.
std::optional<glm::dvec2> rimPlace(const Scene& scene, const Hold& hold);
// The n with which the rim is nearest to `to`.
Assignments rimAt(const Scene& scene, const Hold& hold, glm::dvec2 to, bool coarse);
// n is whole up to 64, and has two digits from there on.
double exponentNear(const Hold& hold, double n, bool coarse);

}  // namespace pipeline
