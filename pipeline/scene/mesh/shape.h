#pragma once
#include <cstdint>
#include <memory>
#include <string_view>

#include "pipeline/scene/mesh/mesh.h"

namespace pipeline {

// Shapes with exactly known normals, around the object's origin.
//   Plane     the square -1/2..1/2 in x and y, facing +z
//   Box       the cube -1/2..1/2
//   Sphere    radius 1
//   Cylinder  radius 1, from z = -1 to z = 1, closed
//   Torus     around z; radius 1 to the middle of the tube, 0.4 of the tube
//   Teapot    M. Newell's, 1975: 32 bicubic patches, z up, standing on z = 0
enum class ShapeKind : std::uint8_t { Plane, Box, Sphere, Cylinder, Torus, Teapot };
inline constexpr std::size_t kShapeCount = 6;
std::string_view name(ShapeKind kind);  // "sphere"

struct Shape {
    ShapeKind kind = ShapeKind::Sphere;
    int tessellation = 16;  // pieces along a quarter of a circle, a side or a patch; 1..256
    bool operator==(const Shape&) const = default;
};

// With the exact normals in Mesh::normals. Polygons are quadrilaterals, and triangles where those shrink.
std::shared_ptr<const Mesh> makeShape(const Shape& shape);

}  // namespace pipeline
