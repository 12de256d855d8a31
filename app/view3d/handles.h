#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/view3d/drawing.h"
#include "app/view3d/view_content.h"
#include "pipeline/scene/scene.h"

namespace app {

// What can be taken hold of in world space: a light, the camera, what it looks at, an object.
struct Handle {
    enum class Kind : unsigned char { Light, LightDirection, Eye, Target, Object };
    Kind kind = Kind::Object;
    std::size_t index = 0;  // of the light or the object
    Vec3d at{0.0};          // world space; an object's is the middle of its bounds
    Vec3d centre{0.0};      // of LightDirection: what it turns around
    std::string name;       // "light 0", "camera", "pyramid"
    bool operator==(const Handle&) const = default;
};

// Those of a scene: every light that stands in the world, the camera, and `object` where one is given.
std::vector<Handle> handlesOf(const pipeline::Scene& scene, const ViewContent& world,
                              std::optional<std::size_t> object);

// Along which a drag leads: the plane of the screen through the handle, or one of the world's axes.
enum class DragAxis : unsigned char { Screen, X, Y, Z };

// Where the three axes of a handle end on the screen, logical pixels.
std::array<glm::dvec2, 3> axisTips(const Handle& handle, const ViewFrame& view);

// What a press at `cursor` takes hold of.
struct Grip {
    std::size_t handle = 0;  // into the handles
    DragAxis axis = DragAxis::Screen;
    bool operator==(const Grip&) const = default;
};
// The nearest handle within reach; of the one with its axes on show (`hot`) also their tips.
std::optional<Grip> gripAt(std::span<const Handle> handles, std::optional<std::size_t> hot, const ViewFrame& view,
                           glm::dvec2 cursor);

// Where the handle is when the cursor has moved by `moved` pixels since it was taken hold of: under
// it in the screen's plane, beside it on an axis, on the sphere around `centre` for a direction. In
// steps of a power of ten, at most as large as a pixel there. Always finite.
Vec3d draggedTo(const Handle& handle, DragAxis axis, const ViewFrame& view, glm::dvec2 moved);

// The scene with the handle there instead. A direction keeps its length; a spherical camera takes ρ, θ and φ.
pipeline::Scene withHandleAt(const pipeline::Scene& scene, const Handle& handle, Vec3d at);

// Its numbers: "x 120  y 40  z 300", "ρ 1000  θ 45.0°  φ 60.0°".
std::string numbersOf(const pipeline::Scene& scene, const Handle& handle);

}  // namespace app
