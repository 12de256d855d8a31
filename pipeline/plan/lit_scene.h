#pragma once
#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

#include "pipeline/buffers/buffer_table.h"
#include "pipeline/scene/scene.h"

namespace pipeline {

// What of a scene its lights can show.

// Without the objects of alpha 0, which draw nothing and cast no shadow. Nothing where there are none, or where somebody
// reads what is computed of their polygons or vertices all the same.
std::optional<Scene> withoutTransparent(const Scene& scene, BufferSet wanted);

// Whether a condition holds for any material, of fronts, and of backs where they have their own.
template <class Condition>
bool anyMaterial(const Scene& scene, Condition holds) {
    const bool backs = lightsBacks(scene.settings);
    return std::ranges::any_of(scene.objects, [&](const Object& o) {
        return holds(o.material) || (backs && o.backMaterial && holds(*o.backMaterial));
    });
}

// Whether the specular term of any material reads a vector.
bool anySpecularReads(const Scene& scene, bool VectorsRead::*vector);
// "Only OpenGL's model has attenuation."
std::string onlyIn(bool ModelFacts::Found::*fact, std::string_view what);

// Why a light sends out nothing; empty where it does.
std::string whyDark(const Light& light, Model model);
// Whether any material sends back any colour of it.
bool isReflected(const Scene& scene, const Light& light);

// Of the objects that are drawn, those of which a side is translucent.
std::size_t translucentTriangles(const Scene& scene);
// Why no surface is laid over another; empty where one is.
std::string whyNoLayers(const Scene& scene);

}  // namespace pipeline
