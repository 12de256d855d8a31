#pragma once
#include "pipeline/scene/hold/hold.h"

// Kinds of holds with a file of their own, for hold.cpp alone. Places are pixels of the picture, values are always finite.

namespace pipeline {

double powerBelow(double unit);               // the largest power of ten that is at most `unit`
double roundedTo(double value, double step);  // to the nearest multiple of `step`, a power of ten

// The place of a number on its track, 0 to 1.
double shareOf(const Hold& hold, double value);
// Rounded: on a logarithmic track to two digits, on a linear one to a power of ten of at most a hundredth of it; coarse: to
// one digit, to a tenth. Whole where the setting is.
double numberNear(const Scene& scene, const Hold& hold, double value, bool coarse);

Vec3d vertexInWorld(const Scene& scene, const Hold& hold);
// Moves the vertex in its plane to where `to` is seen, or as near to it as its polygons allow.
Assignments vertexAt(const Scene& scene, const Hold& hold, glm::dvec2 to, bool coarse);

// The rim's point to the right of the highlight's middle. Nothing where the ball is unlit or outside the picture.
std::optional<glm::dvec2> rimPlace(const Scene& scene, const Hold& hold);
// The n with which the rim is nearest to `to`.
Assignments rimAt(const Scene& scene, const Hold& hold, glm::dvec2 to, bool coarse);
// n is whole up to 64, and has two digits from there on.
double exponentNear(const Hold& hold, double n, bool coarse);

}  // namespace pipeline
