#pragma once
#include "app/drawing3d/drawing.h"
#include "app/drawing3d/view_content.h"
#include "app/drawing3d/view_options.h"

namespace app {

// The ground grid of the world, as lines that fade out away from the scene. `content` in world space.
std::vector<InkedLine> groundLines(const ViewContent& content);
// Where a light at infinity is drawn: the middle one of its three discs.
Vec3d lightDisc(const LightMark& light, const ViewContent& content);
// The step of that grid: 1, 2 or 5 times a power of ten.
double gridStep(const ViewContent& content);

// Vectors at the picked point, lights, eye and frustum, as the world view shows them.
Drawing drawWorld(const ViewContent& content, const ViewOptions& options, const ViewFrame& view);

// Whether eye and picture plane lie inside the view altogether: only then is the plane drawn, which
// would otherwise hide what it is a picture of.
bool showsWholeEye(const ViewContent& content, const ViewFrame& view);

// What the first view of a scene must hold: the objects, and the lights at infinity when shown.
std::vector<Vec3d> sceneExtent(const ViewContent& content, const ViewOptions& options);
// Beside them the eye with its picture plane and the point lights.
std::vector<Vec3d> everythingExtent(const ViewContent& content, const ViewOptions& options);

// The named views. Outside stands behind the scene's own eye and shows its frustum whole. Iso looks from beside the scene's own eye, so that the vectors towards it are
// seen from the side and the faces that it sees are seen. Of the view's height `foot` pixels are taken by something else.
enum class ViewPreset { Front, Side, Top, Iso, Eye, Everything, Outside };
OrbitCamera presetCamera(ViewPreset preset, const ViewContent& content, const ViewOptions& options, glm::dvec2 size,
                         bool orthographic, double foot = 0);

}  // namespace app
