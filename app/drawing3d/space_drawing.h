#pragma once
#include "app/drawing3d/drawing.h"
#include "app/drawing3d/view_content.h"
#include "app/drawing3d/view_options.h"

namespace app {

// The box that clip and screen space show, with what stands at its near and its far side.
void addSpaceBox(const SpaceMap& map, Drawing& drawing);

// A bounding box of the world, as the content's space shows it; what lies before the near plane is cut off.
void addWorldBox(const ViewContent& content, const pipeline::BoundingBox& box, Ink ink, std::vector<InkedLine>& lines);

// The marked, else the picked polygon, and the edges of the box around a marked object.
std::vector<Segment> markedOutline(const ViewContent& content);

// Which of the lights' frusta are drawn: those asked for, and in a light's own space the one that it is.
bool isShown(const LightFrustum& frustum, const ViewContent& content, const ViewOptions& options);
// From the light through its shadow buffer to the farthest texel, with the distances.
void addLightFrustum(const LightFrustum& frustum, Drawing& drawing);

}  // namespace app
