#pragma once
#include <span>
#include <vector>

#include "app/view3d/view_content.h"
#include "app/view3d/view_options.h"

namespace app {

// The arrows of a mesh's normals; none where they are off or the frame has none.
std::span<const NormalArrow> normalArrows(const ViewMesh& mesh, NormalsShown shown);

// Those that are drawn: of each object every k-th, but twenty where it has so many. On an object that is small beside
// the scene they are shorter.
std::vector<NormalArrow> shownNormals(const ViewContent& content, const ViewOptions& options);

// As many normals of the polygons as can be told apart on each object, and as long as they stand apart.
void makeNormalsReadable(const ViewContent& content, ViewOptions& options);

}  // namespace app
