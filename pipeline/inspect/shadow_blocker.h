#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/core/stop.h"
#include "pipeline/inspect/pixel_report.h"
#include "pipeline/run/frame_data.h"

namespace pipeline {

// The polygon, over all objects, nearest to a light (an area light's centre) of those that a straight way from a surface
// point to it meets: the one whose depth its shadow buffer holds there. The point's own polygon, what is wholly
// transparent and what `shadow.cull` leaves out are passed. Nothing where the way is free. By every triangle in turn, in
// double: the answer that the shadow buffer of lecture 1 stands for. Of those before it is stopped.
// T. Möller and B. Trumbore, "Fast, minimum storage ray-triangle intersection", Journal of Graphics Tools 2, 1997.
template <class Real>
std::optional<std::uint32_t> blockerOf(const FrameData<Real>& data, std::size_t light, Vec3d position,
                                       std::uint32_t polygon, const Stop& stop = {});

// The same for each light that does not reach the pixel of a report; -1 where nothing stands before it.
std::vector<int> blockersOf(const Frame& frame, const PixelReport& report);

// Why S of a light is 0 at a point whose N·L is above 0, one sentence with the two depths compared. triangle: index into
// Topology::triangles; back: it is lit from behind.
template <class Real>
std::string whyShadowed(const Scene& scene, const FrameData<Real>& data, std::size_t light, Vec3d position,
                        std::uint32_t triangle, bool back, const Stop& stop = {});

}  // namespace pipeline
