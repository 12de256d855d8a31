#pragma once
#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

#include "pipeline/buffers/screen_position.h"
#include "pipeline/defects/hooks.h"
#include "pipeline/scene/mesh/topology.h"
#include "pipeline/scene/object_matrix.h"
#include "pipeline/scene/view.h"
#include "pipeline/stages/depth.h"
#include "pipeline/stages/hand_on.h"
#include "pipeline/stages/snapped_vertices.h"

namespace pipeline {

// Stage 1: object to world to view to screen, vertex by vertex.

// What the stage depends on, compared to find out whether it has to run again.
struct TransformInputs {
    std::shared_ptr<const Topology> topology;  // compared by identity
    std::vector<ObjectTransform> transforms;   // per object
    View view;
    DepthFormat depthFormat;
    std::vector<std::uint8_t> transparent{};  // per object, 1 where it is as if not there; empty when none is
    NormalMatrixForm normalMatrix = NormalMatrixForm::Cofactors;
    bool placesAsGiven = false;  // places of the mesh, which are Real and of the only object, are those in world space
    Planted planted{};
    bool operator==(const TransformInputs&) const = default;
};
// placesAsGiven: see there.
TransformInputs transformInputs(const Scene& scene, std::shared_ptr<const Topology> topology, bool placesAsGiven);

template <class Real>
struct TransformOutput : Transformed<Real> {
    std::size_t done = 0;       // of the vertices, from the first; all, but while stepping inside the stage
    SnappedVertices snapped{};  // in float, for pipeline/simd; else empty
};

template <class Real>
TransformOutput<Real> prepareTransform(const TransformInputs& inputs);
// Vertices [begin, end) of one object.
template <class Real>
void transform(const TransformInputs& inputs, std::size_t object, std::size_t begin, std::size_t end,
               TransformOutput<Real>& out);

// Per vertex: its place in view space; (0, 0, 0) for one that is not done. Found when somebody looks.
template <class Real>
std::vector<Vec3<Real>> viewPlaces(const TransformOutput<Real>& in);
// Per vertex: x, y in pixels, depth as stored, also of one that the near or far plane cuts off; or kNoScreenPosition.
// Computed when somebody looks: no stage reads it.
template <class Real>
std::vector<Vec3<Real>> screenPlaces(const TransformOutput<Real>& in);

}  // namespace pipeline
