#pragma once
#include <array>
#include <string_view>

#include "pipeline/scene/scene.h"

namespace pipeline {

using Parts = Vec3d& (*)(Scene&, std::size_t);

// Vectors. `first` is the setting of the first component; all have its range. Colours may be one number, a grey.
struct VectorKey {
    std::string_view prefix, key, first;
    bool isColor;
    Parts parts;
};
inline constexpr auto kVectors = std::to_array<VectorKey>({
    {"camera.", "eye", "camera.eye_x", false, [](Scene& s, std::size_t) -> Vec3d& { return s.camera.eye; }},
    {"camera.", "target", "camera.target_x", false, [](Scene& s, std::size_t) -> Vec3d& { return s.camera.target; }},
    {"camera.", "up", "camera.up_x", false, [](Scene& s, std::size_t) -> Vec3d& { return s.camera.up; }},
    {"ambient.", "color", "ambient.red", true, [](Scene& s, std::size_t) -> Vec3d& { return s.ambient.color; }},
    {"light.#.", "position", "light.#.x", false,
     [](Scene& s, std::size_t i) -> Vec3d& { return s.lights[i].position; }},
    {"light.#.", "color", "light.#.red", true, [](Scene& s, std::size_t i) -> Vec3d& { return s.lights[i].color; }},
    {"light.#.", "ambient", "light.#.ambient_red", true,
     [](Scene& s, std::size_t i) -> Vec3d& { return s.lights[i].gl.ambient; }},
    {"light.#.", "specular", "light.#.specular_red", true,
     [](Scene& s, std::size_t i) -> Vec3d& { return s.lights[i].gl.specular; }},
    {"light.#.", "spot_direction", "light.#.spot_x", false,
     [](Scene& s, std::size_t i) -> Vec3d& { return s.lights[i].gl.spotDirection; }},
    {"light.#.", "facing", "light.#.facing_x", false,
     [](Scene& s, std::size_t i) -> Vec3d& { return s.lights[i].area.facing; }},
    {"object.#.", "scale", "object.#.sx", false,
     [](Scene& s, std::size_t i) -> Vec3d& { return s.objects[i].transform.scale; }},
    {"object.#.", "rotation", "object.#.rx", false,
     [](Scene& s, std::size_t i) -> Vec3d& { return s.objects[i].transform.rotation; }},
    {"object.#.", "translation", "object.#.tx", false,
     [](Scene& s, std::size_t i) -> Vec3d& { return s.objects[i].transform.translation; }},
    {"material.#.", "diffuse", "material.#.kr", true,
     [](Scene& s, std::size_t i) -> Vec3d& { return s.objects[i].material.diffuse; }},
    {"material.#.", "specular", "material.#.ksr", true,
     [](Scene& s, std::size_t i) -> Vec3d& { return s.objects[i].material.specular; }},
    {"material.#.", "ambient", "material.#.kar", true,
     [](Scene& s, std::size_t i) -> Vec3d& { return s.objects[i].material.ambient; }},
    {"material.#.", "emission", "material.#.ker", true,
     [](Scene& s, std::size_t i) -> Vec3d& { return s.objects[i].material.emission; }},
});

}  // namespace pipeline
