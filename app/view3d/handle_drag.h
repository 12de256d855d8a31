#pragma once
#include <optional>
#include <span>

#include "app/drawing3d/drawing.h"
#include "app/drawing3d/handles.h"

namespace app {

// Where handles, which stand in world space, are seen and dragged. `map` is the world's where the
// space on show keeps lengths; then `view` has its camera in world space too.
struct HandleView {
    ViewFrame view;
    SpaceMap map;
};
// Of a view that shows the space of `map`.
HandleView handleView(const ViewFrame& shown, const SpaceMap& map);
// Where a point of the world is on the screen. Clip and screen space have nothing before the near plane.
Projected placeOf(const HandleView& view, Vec3d world);

// Where the arms end on the screen, logical pixels: to move or scale along them.
std::vector<glm::dvec2> armTips(const Handle& handle, const HandleView& view);
// The circle around an arm, to turn by: a closed line of points in world space.
std::vector<Vec3d> armRing(const Handle& handle, std::size_t arm, const HandleView& view);

// What a press takes hold of: an arm, or the handle's ring itself.
struct Grip {
    std::size_t handle = 0;  // into the handles
    std::optional<std::size_t> arm;
    bool operator==(const Grip&) const = default;
};
// The nearest handle within reach; of the one with its arms on show (`hot`) also those.
std::optional<Grip> gripAt(std::span<const Handle> handles, std::optional<std::size_t> hot, const HandleView& view,
                           glm::dvec2 cursor);
// To turn, one of its arms must be held.
bool holds(const Handle& handle, std::optional<std::size_t> arm);

// Fine moves by a tenth of what the cursor does; Coarse goes to tens of the usual step, to 15° and to
// tenths of a scale.
enum class DragStep : unsigned char { Usual, Fine, Coarse };

// The handle's value when the cursor, which took hold of it at `from`, has moved by `moved` pixels:
// - moved without an arm: the point of the screen's plane under the cursor; a direction, the point of the sphere around
//   `centre`;
// - moved along an arm: the point of the arm that is nearest to the cursor. Both in steps of a power of ten, at most as
//   large as a pixel there;
// - turned: the angle that the cursor goes around the arm, in whole degrees;
// - scaled: as much as the arm grows, all three without an arm, to hundredths; never 0 or of the other sign.
// Always finite.
Vec3d draggedTo(const Handle& handle, std::optional<std::size_t> arm, const HandleView& view, glm::dvec2 from,
                glm::dvec2 moved, DragStep step = DragStep::Usual);

}  // namespace app
