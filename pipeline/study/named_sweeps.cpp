// The sweeps that have a name. Each shows one law; the values fit the scene.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "pipeline/core/text.h"
#include "pipeline/plan/lit_scene.h"
#include "pipeline/scene/view.h"
#include "pipeline/study/sweep.h"

namespace pipeline {
namespace {

bool hasCurvedShape(const Scene& scene) {
    return std::ranges::any_of(scene.objects, [](const Object& object) {
        return object.shape && object.shape->kind != ShapeKind::Plane && object.shape->kind != ShapeKind::Box;
    });
}
bool hasHighlight(const Scene& scene) {
    return std::ranges::any_of(scene.objects, [](const Object& o) { return o.material.specular != Vec3d(0); });
}
// The first light with a shadow of its own to be wrong about.
std::optional<std::size_t> castingLight(const Scene& scene) {
    if (!modelFacts(scene.settings.model).shadows) return {};
    const auto found = std::ranges::find_if(scene.lights, [&](const Light& light) {
        return light.castsShadow && whyDark(light, scene.settings.model).empty();
    });
    if (found == scene.lights.end()) return {};
    return static_cast<std::size_t>(found - scene.lights.begin());
}

constexpr const char* kPieces = "object.#.tessellation=4..64*2";

// Exponents up to the largest of these that the model takes.
std::string exponents(const Scene& scene, const char* all) {
    const auto most = modelFacts(scene.settings.model).mostExponent;
    return most ? fmt::format("material.#.n=1..{}*2", shortestText(*most)) : all;
}

using Texts = std::vector<std::string>;

Texts shadingSweep(const Scene& scene) {
    if (hasCurvedShape(scene)) return {"shading=flat,gouraud,phong", kPieces};
    return {"shading=flat,gouraud,phong", "precision=float,double"};
}

// A near plane that comes closer to the eye, by powers of ten from where it stands. In double: z_view as a float is no
// nearer to what was to be stored than 24 bits are.
Texts depthSweep(const Scene& scene) {
    if (scene.settings.visibility != Visibility::ZBuffer) return {};
    const double near = makeView(scene).near;
    if (!(near > 0)) return {"depth_format=linear,float,reversed,fixed16,fixed24,fixed32,half", "precision=double"};
    Texts places;
    for (const double factor : {1.0, 0.1, 0.01, 1e-3, 1e-4}) {
        // Three digits are enough to read, and never beyond the nearest point.
        const double place = std::floor(near * factor / std::pow(10, std::floor(std::log10(near * factor)) - 2)) *
                             std::pow(10, std::floor(std::log10(near * factor)) - 2);
        places.push_back(fmt::format("{:.3g}", place));
    }
    return {"depth_format=float,reversed,infinite,fixed16,fixed24,fixed32,half,reversed-half",
            fmt::format("camera.near={}", fmt::join(places, ",")), "precision=double"};
}

Texts shadowSweep(const Scene& scene) {
    if (!castingLight(scene)) return {};
    return {"shadow.filter=0,1", "shadow.size=64..2048*2"};
}

Texts specularSweep(const Scene& scene) {
    if (!hasHighlight(scene)) return {};
    return {"shading=gouraud,phong", exponents(scene, "material.#.n=1..4096*4")};
}

Texts powerSweep(const Scene& scene) {
    if (!hasHighlight(scene)) return {};
    return {"numerics.power=log1p,pow,squaring,exp2,schlick,gaussian", exponents(scene, "material.#.n=1..65536*4"),
            "shading=phong"};
}

Texts normalizeSweep(const Scene& scene) {
    if (hasCurvedShape(scene))
        return {"numerics.normalize=scaled,direct,estimate,newton,newton2", "object.#.tessellation=4..64*4",
                "shading=phong"};
    return {"numerics.normalize=scaled,direct,estimate,newton,newton2", "shading=flat,phong"};
}

Texts subPixelSweep(const Scene&) { return {"numerics.subpixel_bits=4,6,8,12,16", "precision=double"}; }

Texts precisionSweep(const Scene& scene) {
    if (hasCurvedShape(scene)) return {"precision=float,double,extended", kPieces};
    return {"precision=float,double,extended", "shading=flat,gouraud,phong"};
}

Texts antialiasingSweep(const Scene&) {
    return {"antialiasing=1..8*2", "antialiasing_pattern=grid,jittered,random,hammersley"};
}

Texts normalsSweep(const Scene& scene) {
    if (!hasCurvedShape(scene)) return {};
    return {"normal_weight=mean,area,angle,given", kPieces, "shading=phong"};
}

const std::array kSweeps = std::to_array<NamedSweep>({
    {"shading",
     "Flat, Gouraud and Phong shading, over finer and finer polygons of round shapes.",
     {},
     shadingSweep,
     {}},
    {"depth",
     "Depth formats while the near plane comes closer to the eye.",
     {"depth", "RMSE", ErrorKind::Storage},
     depthSweep,
     "a z-buffer"},
    {"shadow",
     "Shadow buffers of more and more texels, with and without filtering.",
     {"shadow.0", "misclassified", ErrorKind::Model},
     shadowSweep,
     "a light that casts a shadow, and is not dark"},
    {"specular",
     "Sharper and sharper highlights, by vertex and by pixel.",
     {},
     specularSweep,
     "a material with k_s above 0"},
    {"power",
     "Forms of the specular power, from the usual ones to cheap approximations.",
     {},
     powerSweep,
     "a material with k_s above 0"},
    {"normalize", "Forms of v / |v|, from the safe one to a guess.", {}, normalizeSweep, {}},
    {"subpixel",
     "Finer and finer grids that corners are snapped to.",
     {"z_view", "RMSE", ErrorKind::Model},
     subPixelSweep,
     {}},
    {"precision", "What the stages compute in.", {"intensity", "RMSE", ErrorKind::Arithmetic}, precisionSweep, {}},
    {"antialiasing",
     "More and more samples a pixel.",
     {"antialiased", "RMSE", ErrorKind::Model},
     antialiasingSweep,
     {}},
    {"normals",
     "How vertex normals are weighted.",
     {"normal", "mean angle", ErrorKind::Model},
     normalsSweep,
     "a built-in shape that is round"},
});

}  // namespace

std::span<const NamedSweep> namedSweeps() { return kSweeps; }

const NamedSweep* findNamedSweep(std::string_view name) {
    const auto found = std::ranges::find(kSweeps, name, &NamedSweep::name);
    return found == kSweeps.end() ? nullptr : &*found;
}

ErrorChoice choiceOf(const NamedSweep& sweep, const Scene& scene) {
    ErrorChoice choice = sweep.choice;
    if (choice.buffer == "shadow.0") choice.buffer = fmt::format("shadow.{}", castingLight(scene).value_or(0));
    return choice;
}

}  // namespace pipeline
