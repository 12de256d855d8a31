#pragma once
#include <array>
#include <optional>
#include <string>

#include "app/drawing3d/orbit_camera.h"
#include "pipeline/scene/view.h"

namespace app {

// What a 3D view looks at: the whole scene in one of the spaces that the stages work in, or the
// vectors at the picked point alone.
enum class ViewSpace : unsigned char { World, Eye, Clip, Screen, Light, Point };

struct SpaceId {
    ViewSpace space = ViewSpace::World;
    int light = 0;  // of ViewSpace::Light
    int face = -1;  // of a point light's six; -1: the one that sees the most
    auto operator<=>(const SpaceId&) const = default;
};
std::string nameOf(SpaceId id);       // "Eye space", "Light 0's space", "Light 0's space, face −x"
std::string shortNameOf(SpaceId id);  // "Eye", "Light 0", "Point"; no face

// A point light's faces, in the order of its shadow buffer, each by the axis that it looks along.
constexpr int kLightFaces = 6;
std::string nameOfFace(int face);  // "+x"

// Takes points of the world to where a space shows them. Every space is drawn with its first axis
// to the right, its depth away from the reader and its second axis upwards, so that (x, y, z) of a
// left-handed space stands at (x, z, y) of the drawing and nothing is mirrored:
//   Eye, Light  x, y, z along the view's right, up and forward, world units; lengths and angles stay
//   Clip        after the division by w: x and y from −1 to 1 over the picture, z from −1 (near) to 1 (far)
//   Screen      x right and y down in pixels, z from 0 (near) to 1 (far), drawn as deep as the picture is high
// z of Clip and Screen is affine in 1 / z_view in perspective, in z_view else, so lines stay lines:
// M. Segal and K. Akeley, "The OpenGL Graphics System: A Specification", 1992.
struct SpaceMap {
    ViewSpace space = ViewSpace::World;
    pipeline::View view{};     // of Eye, Clip and Screen: the scene's camera; of Light: one face of the light
    int light = -1, face = 0;  // of Light

    // Clip and Screen take points in front of the eye only: z_view >= near.
    Vec3d toSpace(Vec3d world) const;
    Vec3d toWorld(Vec3d shown) const;
    bool keepsLengths() const { return space != ViewSpace::Clip && space != ViewSpace::Screen; }
    Vec3d turned(Vec3d direction) const;  // where lengths are kept
    pipeline::View turned(const pipeline::View& other) const;
    // What of a ray stands for places of the world up to z_view = farthest, as a ray of the world; nothing where none does.
    // Places keep their order along it.
    struct WorldRay {
        Ray ray;
        double length;  // infinite where it goes on for ever
    };
    std::optional<WorldRay> toWorld(const Ray& shown, double farthest) const;
    bool operator==(const SpaceMap&) const = default;
};

// z_view of a point.
double depthOf(const pipeline::View& view, Vec3d world);

// The box that Clip and Screen show, in the drawing: corners as ViewContent's Bounds.
struct SpaceBox {
    Vec3d min{0.0}, max{0.0};
};
SpaceBox visibleBox(const SpaceMap& map);

// The picture of Clip and Screen as an eye in the drawing that looks along parallel lines, in front of the box.
pipeline::View flatEye(const SpaceMap& map);

// The axes as they are drawn: where they begin, and each with its name and its end.
struct SpaceAxis {
    const char* name;
    Vec3d direction;  // unit, in the drawing
};
std::array<SpaceAxis, 3> axesOf(ViewSpace space);

}  // namespace app
