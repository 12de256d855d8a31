#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/buffers/verdict.h"
#include "pipeline/stages/transform.h"

namespace pipeline {

// Stage 2: which polygons go on. Each gets a verdict, whatever happens to it.

struct CullInputs {
    CullMode mode;
    Planted planted{};
    bool operator==(const CullInputs&) const = default;
};

using CullOutput = Culled;

CullOutput prepareCull(std::size_t polygons);  // nothing is written yet
// Polygons [begin, end).
template <class Real>
void cull(const CullInputs& inputs, const TransformOutput<Real>& in, std::size_t begin, std::size_t end,
          CullOutput& out);

// Of a polygon, px²; positive for a front face (counter-clockwise as seen, mirroring undone). Of the part inside near,
// far and guard band; computed on snapped corners, exact. Nothing where the verdict did not take it. Nothing keeps it: it
// costs what the stage costs for that polygon.
template <class Real>
std::optional<double> signedArea(const TransformOutput<Real>& in, const CullOutput& cull, std::size_t polygon);
// "back-facing, signed area −1 991.6 px²"
template <class Real>
std::string reason(const TransformOutput<Real>& in, const CullOutput& cull, std::size_t polygon);

}  // namespace pipeline
