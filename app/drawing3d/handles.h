#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/drawing3d/view_content.h"
#include "app/drawing3d/view_options.h"
#include "pipeline/scene/scene.h"

namespace app {

// A way that a drag of a handle may be held to.
struct HandleArm {
    std::string name;     // "x"; where an object has turns of its own, which of them: "0"
    Vec3d axis{1, 0, 0};  // unit, world space: along it, or of HandleTool::Turn around it
    bool operator==(const HandleArm&) const = default;
};

// What can be taken hold of: a light, the camera, what it looks at, an object.
struct Handle {
    enum class Kind : unsigned char { Light, LightDirection, LightFacing, Eye, Target, Object };
    Kind kind = Kind::Object;
    std::size_t index = 0;               // of the light or the object
    HandleTool tool = HandleTool::Move;  // of an object
    Vec3d at{0.0};                  // world space; of an object that is moved the middle of its bounds, else its origin
    Vec3d centre{0.0};              // of LightDirection and LightFacing: what they turn around
    Vec3d value{0.0};               // what a drag changes: `at`; an angle per arm, degrees; the scale
    std::vector<HandleArm> arms{};  // at most three; of Turn at least one
    std::string name{};             // "light 0", "camera", "pyramid"
    bool isDirection() const { return kind == Kind::LightDirection || kind == Kind::LightFacing; }
    bool operator==(const Handle&) const = default;
};

// Those of a scene where `shown` shows it: every light that stands in the world, its direction where it
// has one, the camera, and `object` where one is given. What a space is built on has none in it: the
// camera in eye, clip and screen space, a light in its own. Clip and screen space have no lengths, so
// that an object's is Move there, without arms.
std::vector<Handle> handlesOf(const pipeline::Scene& scene, const ViewContent& shown, std::optional<std::size_t> object,
                              HandleTool tool);

// Whether a scene has what the handle is of.
bool isIn(const pipeline::Scene& scene, const Handle& handle);

// The scene with the handle's value there instead. A direction keeps its length; a spherical camera takes ρ, θ and φ.
pipeline::Scene withHandleAt(const pipeline::Scene& scene, const Handle& handle, Vec3d value);

// Its numbers: "x 120  y 40  z 300", "ρ 1000  θ 45.0°  φ 60.0°", "rotation x 30.0°  y 0.0°  z 0.0°".
std::string numbersOf(const pipeline::Scene& scene, const Handle& handle);

// For the steps that drags go in: the power of ten at or below it; to a multiple of `step`.
double stepBelow(double unit);
Vec3d roundedTo(Vec3d p, double step);
bool finite(Vec3d v);

}  // namespace app
