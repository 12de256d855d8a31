#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/core/real.h"
#include "pipeline/scene/mesh/mesh.h"
#include "pipeline/scene/mesh/shape.h"
#include "pipeline/scene/model_facts.h"
#include "pipeline/scene/remark.h"
#include "pipeline/scene/settings.h"

namespace pipeline {

// A turn about an axis through the object's origin, as glRotate makes it.
struct AxisTurn {
    double angle = 0;     // degrees, counter-clockwise seen from the axis' positive end
    Vec3d axis{0, 0, 1};  // any length but 0
    bool operator==(const AxisTurn&) const = default;
};

// The axis of a mesh's file that points up.
enum class UpAxis : std::uint8_t { Z, Y };
// A vector of the file with z up: (x, y, z) of a file with y up is (x, -z, y).
inline Vec3d upright(UpAxis up, const Vec3d& v) { return up == UpAxis::Y ? Vec3d{v.x, 0.0 - v.z, v.y} : v; }

// Applied in this order: what turns the mesh upright, scale, rotation about x, then y, then z, translation. Where there
// are turns they take the place of the rotation; like successive calls of glRotate, the last one
// written is the first one applied.
struct ObjectTransform {
    Vec3d scale{1.0};
    Vec3d rotation{0.0};     // degrees, counter-clockwise seen from the axis' positive end
    Vec3d translation{0.0};  // world units
    std::vector<AxisTurn> turns{};
    UpAxis up = UpAxis::Z;
    bool operator==(const ObjectTransform&) const = default;
};

// Which lobe the specular term of a material has: that of the scene's model, or Phong's or Blinn's
// whatever the model, to have both in one picture. Some models always have their own: ModelFacts::choosesLobe.
enum class Highlight : std::uint8_t { OfModel, Phong, BlinnPhong };

// Reflection coefficients are fractions, 0 to 1 in nature; more or less than that is computed as written.
struct Material {
    Vec3d diffuse{0.7};     // k_r, k_g, k_b; in lecture 1's model also of ambient light
    Vec3d specular{0.0};    // k_s for red, green and blue; equal in lecture 1's model
    double exponent = 8.0;  // n, or s in Blinn-Phong; >= 0
    Vec3d ambient{0.7};     // k_a of Blinn-Phong and OpenGL; readers take k_d where a file has none
    Vec3d emission{0.0};    // OpenGL only
    Highlight highlight = Highlight::OfModel;
    double alpha = 1.0;  // 1 opaque, 0 as if the object were not there; beyond [0, 1] as the nearer of the two
    bool operator==(const Material&) const = default;
};

// Whether the specular term is (N·H)^n, else (R·V)^n.
inline bool usesHalfway(Model model, const Material& material) {
    const ModelFacts& facts = modelFacts(model);
    if (facts.choosesLobe && material.highlight != Highlight::OfModel)
        return material.highlight == Highlight::BlinnPhong;
    return facts.lobe == Lobe::Halfway;
}
// Whether there is a specular term.
inline bool shines(Model model, const Material& material) {
    return material.specular != Vec3d(0) || !modelFacts(model).dullWithoutKs;
}
// n as the specular term takes it; exponentFactor: the setting.
inline double effectiveExponent(Model model, double exponentFactor, const Material& material) {
    const bool factored = modelFacts(model).exponentFactor && usesHalfway(model, material);
    return (factored ? exponentFactor : 1.0) * material.exponent;
}
// The reflection coefficient of ambient light.
inline const Vec3d& ambientCoefficient(Model model, const Material& material) {
    return modelFacts(model).found.ownAmbient ? material.ambient : material.diffuse;
}

struct Object {
    std::string name;
    std::shared_ptr<const Mesh> mesh;  // never null; compared by identity
    ObjectTransform transform;
    Material material;
    std::optional<Material> backMaterial{};  // of back faces with two-sided lighting; else `material`
    std::optional<Shape> shape{};            // what `mesh` was made of; nothing for one read from a file
    bool operator==(const Object&) const = default;
};

// Whether back faces are lit with their normal turned round.
inline bool lightsBacks(const Settings& settings) { return modelFacts(settings.model).twoSided && settings.twoSided; }
// What a side of an object is made of.
inline const Material& effectiveMaterial(const Object& object, const Settings& settings, bool back) {
    return back && lightsBacks(settings) && object.backMaterial ? *object.backMaterial : object.material;
}

enum class LightKind : std::uint8_t { AtInfinity, Point, Area };

enum class LightSpace : std::uint8_t { World, Eye };

// What only OpenGL's model reads of a light.
struct OpenGlLight {
    Vec3d ambient{0.0};                              // its own part of the ambient light
    Vec3d specular{1.0};                             // colour of its specular part, instead of `color`
    double constant = 1, linear = 0, quadratic = 0;  // attenuation 1 / (c + l d + q d²), point lights; >= 0
    Vec3d spotDirection{0, 0, -1};                   // any length, in the light's space
    double spotCutoff = 180;                         // degrees, 0..90; 180: no spot
    double spotExponent = 0;                         // 0..128
    LightSpace space = LightSpace::World;            // Eye: x right, y up, z towards the viewer
    bool operator==(const OpenGlLight&) const = default;
};

// What only an area light has: a rectangle around its position; pipeline/scene/area_light.h says how it lies.
struct AreaLight {
    Vec3d facing{0, 0, -1};        // world space, any length but 0: across the rectangle
    double width = 1, height = 1;  // world units, >= 0
    int samples = 4;               // along each side
    bool operator==(const AreaLight&) const = default;
};

struct Light {
    LightKind kind = LightKind::AtInfinity;
    Vec3d position{0, 0, 1};  // for a light at infinity the direction towards it, any length
    double intensity = 1.0;   // I_p, in the scene's own unit
    Vec3d color{1.0};         // multiplies the intensity
    bool castsShadow = true;
    OpenGlLight gl{};
    AreaLight area{};
    bool operator==(const Light&) const = default;
};

struct AmbientLight {
    std::optional<double> intensity{};  // I_a, where the scene gives one
    Vec3d color{1.0};

    // What OpenGL begins with, GL_LIGHT_MODEL_AMBIENT, holds in its model until a scene says otherwise.
    double intensityIn(Model model) const { return intensity.value_or(modelFacts(model).ambientByDefault); }
    Vec3d lightIn(Model model) const { return intensityIn(model) * color; }
    bool operator==(const AmbientLight&) const = default;
};

enum class CameraKind : std::uint8_t { Spherical, LookAt };
enum class ProjectionKind : std::uint8_t { Perspective, Orthographic };

struct Camera {
    CameraKind kind = CameraKind::Spherical;
    ProjectionKind projection = ProjectionKind::Perspective;

    // Spherical (lecture 1): on a sphere around the world's origin, looking at it.
    double rho = 1000, theta = 45, phi = 60;  // world units, >= 0; degrees; degrees from +z
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
    std::string look;  // what to look at, one sentence; may be empty
    std::vector<Object> objects;
    std::vector<Light> lights;
    AmbientLight ambient;
    Camera camera;
    Settings settings;
    std::vector<Remark> remarks{};  // of its readers, about what they left out
    bool framed = false;  // a model opened by itself: pipeline/scene/framing.h has placed it and added the camera
    bool operator==(const Scene&) const = default;
};

}  // namespace pipeline
