#pragma once
#include <vector>

#include "app/drawing3d/view_content.h"
#include "app/drawing3d/view_options.h"

namespace app {

// A normal in world space as a colour.
inline glm::vec3 colorOfNormal(glm::vec3 normal) { return (normal + 1.0f) / 2.0f; }

// How many normals could be drawn: none where they are off, the frame has none, or the space keeps no angles.
std::size_t normalCount(const ViewMesh& mesh, NormalsShown shown);

// Those that are drawn: of each object every k-th, but twenty where it has so many. On an object that is small beside
// the scene they are shorter.
std::vector<NormalArrow> shownNormals(const ViewContent& content, const ViewOptions& options);

// As many normals of the polygons as can be told apart on each object, and as long as they stand apart.
void makeNormalsReadable(const ViewContent& content, ViewOptions& options);

}  // namespace app
