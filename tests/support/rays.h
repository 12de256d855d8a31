#pragma once
#include <string>

#include "pipeline/run/frame.h"

namespace test {

using namespace pipeline;

// A frame in double against its scene's polygons by rays.
struct RayComparison {
    int seen = 0;           // pixels that show an object, and whose neighbours show the same one
    int otherFacets = 0;    // of those, pixels on an edge between two facets that show the other one
    int otherShadows = 0;   // of those, pixels in which a light that counts has another S
    std::string different;  // the first other pixel that differs by more than snapping explains, and how; may be empty
};
// The frame needs picturesNeed(); its scene has rays, and depths in format Linear. Snapping moves a sample by up to
// √2 / 512 pixel against its triangle, and turns triangles of a few pixels as much: by `snapped` of what the nine pixels
// around take on, where they show one object.
RayComparison compareWithRays(const Frame& frame, double snapped = 0.02);

}  // namespace test
