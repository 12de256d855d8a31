#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "pipeline/core/real.h"
#include "pipeline/scene/mesh.h"
#include "pipeline/scene/settings.h"

namespace pipeline {

// Applied in this order: scale, rotation about x, then y, then z, translation.
struct ObjectTransform {
    Vec3d scale{1.0};
    Vec3d rotation{0.0};     // degrees, counter-clockwise seen from the axis' positive end
    Vec3d translation{0.0};  // world units
    bool operator==(const ObjectTransform&) const = default;
};

struct Material {
    Vec3d diffuse{0.7};     // k_r, k_g, k_b: fractions of ambient and diffuse light reflected, 0..1
    Vec3d specular{0.0};    // k_s for red, green and blue; equal in lecture 1's model; 0..1
    double exponent = 8.0;  // n, >= 0
    bool operator==(const Material&) const = default;
};

struct Object {
    std::string name;
    std::shared_ptr<const Mesh> mesh;  // never null; compared by identity
    ObjectTransform transform;
    Material material;
    bool operator==(const Object&) const = default;
};

enum class LightKind : std::uint8_t { AtInfinity, Point };

struct Light {
    LightKind kind = LightKind::AtInfinity;
    Vec3d position{0, 0, 1};  // world space; for a light at infinity the direction towards it, any length
    double intensity = 1.0;   // I_p, >= 0, in the scene's own unit
    Vec3d color{1.0};         // multiplies the intensity
    bool castsShadow = true;
    bool operator==(const Light&) const = default;
};

struct AmbientLight {
    double intensity = 0.0;  // I_a, >= 0
    Vec3d color{1.0};
    bool operator==(const AmbientLight&) const = default;
};

enum class CameraKind : std::uint8_t { Spherical, LookAt };
enum class ProjectionKind : std::uint8_t { Perspective, Orthographic };

struct Camera {
    CameraKind kind = CameraKind::Spherical;
    ProjectionKind projection = ProjectionKind::Perspective;

    // Spherical (lecture 1): on a sphere around the world's origin, looking at it.
    double rho = 1000, theta = 45, phi = 60;  // world units, degrees, degrees from +z
    double screenDistance = 200;              // d, screen units
    double pixelsPerUnit = 1;                 // s, pixels per screen unit

    // Look-at.
    Vec3d eye{5, -5, 5}, target{0.0}, up{0, 0, 1};  // world space
    double fovY = 45;                               // vertical field of view, degrees
    double height = 5;                              // orthographic: world units from the picture's top to its foot

    // Distances along the viewing direction, world units. 0: chosen from the scene's bounds.
    double near = 0, far = 0;
    bool operator==(const Camera&) const = default;
};

// A plain value: copying shares the meshes, comparing tells what changed.
struct Scene {
    std::string name;  // for titles: "pyramid.scene"
    std::string file;  // path as given; empty for a built-in scene
    std::vector<Object> objects;
    std::vector<Light> lights;
    AmbientLight ambient;
    Camera camera;
    Settings settings;
    bool operator==(const Scene&) const = default;
};

}  // namespace pipeline
