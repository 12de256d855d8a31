#pragma once
#include <vector>

#include "app/drawing3d/view_picture.h"
#include "pipeline/run/frame.h"
#include "pipeline/scene/view.h"

namespace app {

// What a light sees, as its shadow buffer has it: one view for a light at infinity, six for a
// point light. Of an area light its middle sample's.
struct LightFrustum {
    int light = 0;
    int face = 0, faces = 1;    // which, of how many: six around a point light
    pipeline::View view;        // world space
    double begin = 0, end = 1;  // Z' of the nearest and the farthest texel, along the view
    double plane = 0;           // where the shadow buffer stands, along the view, before them
    std::size_t texels = 0;     // of them see a polygon; 0: begin, end and plane are somewhere
    Picture picture;            // its Z' in the palette of distances: light is near
};

// Of every light that has a shadow buffer in this frame. The one that sees the most comes first of each light's.
std::vector<LightFrustum> lightFrusta(const pipeline::Frame& frame);

}  // namespace app
