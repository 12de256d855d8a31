#pragma once
#include "app/drawing3d/view_content.h"
#include "pipeline/scene/mesh/topology.h"

namespace app {

// Gives every face the colour that the frame buffer would hold: from polygons.intensity (flat) or
// vertices.intensity (Gouraud), and with Phong shading from the illumination model at the vertices.
// Before shading has run, the material's diffuse colour. Culled polygons are marked as not shaded.
void colorFaces(const pipeline::Frame& frame, const pipeline::Topology& topology, ViewMesh& mesh,
                const std::stop_token& stop = {});

}  // namespace app
