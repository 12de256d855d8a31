#include "pipeline/formats/built_in_scenes.h"

#include <array>
#include <string_view>

#include "pipeline/formats/scene_folder.h"
#include "pipeline/formats/toml_scene.h"

namespace pipeline {
namespace {

namespace fs = std::filesystem;

// title and look are empty where the file gives them.
struct Row {
    std::string_view name, extension, title = {}, look = {};
};
// Each is a file of resources/scenes. The first is the one to begin with.
constexpr auto kScenes = std::to_array<Row>({
    {"pyramid", ".scene", "Pyramid", "The lecture's example: five polygons, of which three face the viewer."},
    {"box_over_plane", ".scene", "Box over a floor",
     "The shadow lies beside the box, for the light comes from the side."},
    {"two_pyramids", ".scene", "Two pyramids",
     "Where the near pyramid stands before the far one, the z-buffer keeps the nearer."},
    {"lambert", ".toml"},
    {"reflection_law", ".toml"},
    {"flat_gouraud_phong", ".toml"},
    {"no_hidden_surface_removal", ".toml"},
    {"back_face_culling", ".toml"},
    {"z_buffer_flat", ".toml"},
    {"z_buffer_gouraud", ".toml"},
    {"z_buffer_phong", ".toml"},
    {"interpolation", ".toml"},
    {"highlight_exponents", ".toml"},
    {"phong_blinn", ".toml"},
    {"microfacets", ".toml"},
    {"vertex_normals", ".toml"},
    {"ambient", ".toml"},
    {"coloured_lights", ".toml"},
    {"near_plane", ".toml"},
    {"intersecting_polygons", ".toml"},
    {"cyclic_overlap", ".toml"},
    {"translucent", ".toml"},
    {"translucent_cycle", ".toml"},
    {"z_fighting", ".toml"},
    {"concave_polygon", ".toml"},
    {"point_light_shadow", ".toml"},
    {"soft_shadow", ".toml"},
    {"shadow_bias", ".toml"},
    {"teapot", ".toml"},
    {"gl_cube", ".toml"},
});

}  // namespace

fs::path resourceFolder() {
    std::error_code failed;
    const fs::path program = fs::read_symlink("/proc/self/exe", failed);
    if (!failed) {
        const fs::path installed = program.parent_path().parent_path() / "share" / "shadescope";
        if (fs::is_directory(installed / "scenes", failed)) return installed;
    }
    return SHADESCOPE_RESOURCES;
}

std::vector<BuiltInScene> builtInScenes() {
    const fs::path folder = resourceFolder() / "scenes";
    std::vector<BuiltInScene> scenes;
    for (const Row& row : kScenes) {
        BuiltInScene& scene = scenes.emplace_back();
        scene.name = row.name;
        scene.title = row.title;
        scene.look = row.look;
        scene.file = folder / (scene.name + std::string(row.extension));
        if (!row.title.empty()) continue;
        const Result<std::string> text = readFile(scene.file, kMaxTomlBytes);
        const SceneTitle given = text ? readTomlTitle(*text) : SceneTitle();
        scene.title = given.title.empty() ? scene.name : given.title;
        scene.look = given.look;
    }
    return scenes;
}

}  // namespace pipeline
