#pragma once
#include "app/drawing3d/drawing.h"
#include "app/drawing3d/view_content.h"

namespace app {

// Lecture 2's debugging tips as lines in the world: bounding boxes, bounding spheres, and what the
// scene's own camera sees.

void addBox(const pipeline::BoundingBox& box, Ink ink, std::vector<InkedLine>& lines);
// Three great circles along the axes, and the outline that the observer sees.
void addSphere(const pipeline::BoundingSphere& sphere, Ink ink, const OrbitCamera& observer,
               std::vector<InkedLine>& lines);

// Corners of the near plane's part of the picture, then of the far plane's, each as pictureCorners.
std::array<Vec3d, 8> frustumCorners(const pipeline::View& eye);
// Both planes and the edges between them, labelled with their distances; in perspective the edges go
// on to the eye.
void addFrustum(const pipeline::View& eye, Drawing& drawing);
// The selected vertex; the eye's ray through the pixel that an algorithm is at, to the polygon, with its column and row.
void addMarkedPoint(const ViewContent& content, Drawing& drawing);

}  // namespace app
