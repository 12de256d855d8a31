#pragma once
#include <cstdint>
#include <vector>

#include "pipeline/core/real.h"
#include "pipeline/inspect/formula.h"

namespace app {

using pipeline::Vec3d;
using pipeline::VectorCode;

// Triangles, counter-clockwise seen from outside.
struct Solid {
    std::vector<Vec3d> positions;
    std::vector<glm::uvec3> triangles;
};
void append(Solid& solid, const Solid& more);

// Where a shape made in units of a pixel, from the origin along z, stands in the world.
struct ShapePlacement {
    Vec3d origin{0.0};
    Vec3d along{0, 0, 1};       // unit
    Vec3d towardsEye{1, 0, 0};  // unit; flat tips (ring, chevron) turn their face this way
    double scale = 1;           // world units per pixel
};
Solid placed(Solid solid, const ShapePlacement& placement);

// A piece of a line: where it begins and ends, pixels from the line's start.
struct Dash {
    double begin, end;
};
// The dashes of a vector's code along `length` pixels, for a line `width` pixels wide (the pattern
// is in widths, as a pen's). VectorCode::None is a solid line.
std::vector<Dash> dashes(VectorCode code, double length, double width);

// How far the tip of a vector reaches back from its end, pixels, for a shaft of `radius` pixels.
double tipLength(VectorCode code, double radius);

Vec3d across(Vec3d along);  // any unit vector across a unit vector

// The arrow of a vector: dashed shaft and tip, `length` pixels from its foot to the end of its
// tip. N a cone, L a sphere, V a torus, R two bars at 40°, H an octahedron; None has no tip.
Solid arrow(VectorCode code, double length, double radius, const ShapePlacement& placement);
// A plain arrow of few triangles along z, for the many normals of a mesh.
Solid smallArrow(double length, double radius);

// The solid with every point moved outwards by `distance` (of the solid's own units).
Solid inflated(Solid solid, double distance);

// A straight tube from a to b, and a ball.
Solid tube(Vec3d a, Vec3d b, double radius, int sides = 10);
Solid ball(Vec3d centre, double radius, int around = 16);
// A ring in the plane across z, around the origin.
Solid ring(double radius, double tubeRadius);

}  // namespace app
