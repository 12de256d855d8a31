#pragma once
#include <memory>
#include <optional>

#include "app/drawing3d/view_content.h"

namespace app {

// The map of a space for a frame's content; nothing where the content has none: a light without a
// shadow buffer, or ViewSpace::Point, which is made by pointContent.
std::optional<SpaceMap> mapOf(const ViewContent& world, SpaceId id);

// What of the polygons lies in front of the near plane, in world space: those that cross it are cut
// there. The content itself where none does.
ViewContent clippedAtNear(const ViewContent& world);

// The content as a space shows it: `world` moved by `map`. Clip and Screen have no lengths and
// angles to show: there normals, vectors, lights and spheres are left out.
// `before`, made by inSpace: where it is of the same mesh and space, its polygons are taken from it, which are the work.
ViewContent inSpace(const ViewContent& world, const SpaceMap& map, const ViewContent* before = nullptr);

// A change from one space to another: the same polygons, moved on straight lines of the picture.
class SpaceMorph {
public:
    // from, to: where the camera looks from, before and after.
    SpaceMorph(const ViewContent& world, const SpaceMap& mapFrom, const OrbitCamera& from, const SpaceMap& mapTo,
               const OrbitCamera& to);
    // t = 0 looks as `from` showed it, t = 1 as `to` shows it. Polygons and their edges only.
    ViewContent content(double t) const;
    OrbitCamera camera(double t) const;

private:
    ViewContent m_content;              // topology and colours
    std::vector<Vec3d> m_begin, m_end;  // per vertex, in the space that it goes to
    OrbitCamera m_from, m_to;
};

}  // namespace app
