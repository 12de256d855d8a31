#pragma once
#include "app/drawing3d/view_content.h"
#include "pipeline/scene/mesh/topology.h"

namespace app {

Vec3d row3(const pipeline::AnyBuffer& buffer, std::size_t row);  // of three components
pipeline::rays::Corners<double> cornersOf(const ViewMesh& mesh, std::uint32_t face);

// The places of a frame's vertices, and what stands on them: edges, bounds, faces without their colours, what finds them.
// bounds: grows by the places. What `before` has of the same places is taken from it. Incomplete when it is stopped.
void addPolygons(const pipeline::Frame& frame, const ViewMesh* before, const std::stop_token& stop, ViewMesh& mesh,
                 Bounds& bounds);
// A polygon's normal stands at the mean of its vertices, where flat shading evaluates it.
void addNormals(const pipeline::Frame& frame, const std::stop_token& stop, ViewMesh& mesh);

}  // namespace app
