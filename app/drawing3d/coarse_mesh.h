#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/scene/mesh/topology.h"

namespace app {

// A triangle of a mesh, its corners moved to nearby vertices.
struct CoarseFace {
    std::uint32_t face = 0;  // its number in the mesh
    std::array<std::uint32_t, 3> vertices{};
    bool operator==(const CoarseFace&) const = default;
};

// The shape of many triangles with few of them, for pictures that follow each other quickly: in a grid of `cells` along
// the longest side of the mesh all vertices of a cell become its first one, and what is left of a triangle stays where
// that is a triangle. J. Rossignac and P. Borrel, "Multi-resolution 3D approximations for rendering complex scenes",
// Modeling in Computer Graphics, 1993. Vertices that are no numbers have no triangles.
std::vector<CoarseFace> coarseMesh(std::span<const pipeline::Vec3d> positions,
                                   std::span<const pipeline::Triangle> triangles, int cells);

}  // namespace app
