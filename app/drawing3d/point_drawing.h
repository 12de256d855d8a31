#pragma once
#include "app/drawing3d/drawing.h"
#include "app/drawing3d/view_content.h"
#include "app/drawing3d/view_options.h"
#include "app/drawing3d/world_drawing.h"

namespace app {

// The view "At the point": the unit hemisphere over the point where the illumination was evaluated,
// with N up. Its space is turned from world space so that N is +z; the point is the origin, and a
// unit vector has length 1. Lights and eye appear as directions alone.

// Null where no vectors are there to show. The disc under the hemisphere has the polygon's colour.
std::shared_ptr<const ViewContent> pointContent(const ViewContent& content);

// Vectors, circles at 30° and 60°, the angles of N·L and R·V as arcs with degrees, and, dotted, how
// R comes from L (through N), or H from L and V where R is not shown. With the options, dashed: the
// projection (N·L)N of L on N with its right angle, and the law of reflection R = 2(N·L)N − L.
Drawing drawPoint(const ViewContent& content, const ViewOptions& options, const ViewFrame& view);

// Iso and Everything are turned so that L and V stand farthest apart on the screen; Eye looks
// along V, Top along N, Front and Side across it.
OrbitCamera pointCamera(ViewPreset preset, const ViewContent& content, const ViewOptions& options, glm::dvec2 size,
                        bool orthographic, double foot = 0);

}  // namespace app
