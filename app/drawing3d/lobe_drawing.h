#pragma once
#include <vector>

#include "app/drawing3d/drawing.h"
#include "app/drawing3d/view_content.h"

namespace app {

// One meridian of the surface r = cos^n a: (a, r) with a the angle from the axis in radians, from the
// tip (0, 1) to where r is at most a hundredth, and then back to the origin. exponent n >= 0; with
// n = 0 it is a quarter of a circle, for the power counts before the hemisphere's edge.
std::vector<glm::dvec2> lobeProfile(double exponent, int steps);

// The surface as wires around the axis, `length` world units high, and the probe's cut with its number.
void addLobe(const SpecularLobe& lobe, double length, Drawing& drawing);

}  // namespace app
