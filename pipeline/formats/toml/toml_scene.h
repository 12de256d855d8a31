#pragma once
#include <string>
#include <string_view>

#include "pipeline/core/result.h"
#include "pipeline/formats/scene_folder.h"
#include "pipeline/scene/scene.h"

namespace pipeline {

// The program's own scene format, in TOML. A key of settings_table.h is the path of a value:
// "camera.fov" is fov in [camera], "light.#.kind" is kind in a [[light]], "material.#.n" is n in an
// [object.material]. Beside them stand vectors and what has no setting:
//     title, look
//     [[object]]  name; one of shape, mesh, model; turns; [object.material], [object.back_material]
//     [[light]]   attenuation = [c, l, q]
// Where a file gives none, a material's ambient is its diffuse, and a light's OpenGL specular its color.
// At most kMaxTomlBytes; meshes and models come from `load`. The scene has passed checkScene.
Result<Scene> readTomlScene(const SourceText& source, const FileLoader& load);
inline constexpr std::size_t kMaxTomlBytes = std::size_t{16} << 20;

// Whether the first line that says something begins a table or gives a key its value.
bool looksLikeTomlScene(std::string_view start);

// What a list of scenes shows of a file: title and look as it gives them, else empty.
struct SceneTitle {
    std::string title, look;
};
SceneTitle readTomlTitle(std::string_view text);

}  // namespace pipeline
