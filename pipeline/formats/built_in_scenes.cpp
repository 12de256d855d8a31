#include "pipeline/formats/built_in_scenes.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "pipeline/formats/scene_folder.h"
#include "pipeline/formats/toml/toml_scene.h"

namespace pipeline {
namespace {

namespace fs = std::filesystem;

// title and look are empty where the file gives them.
struct Row {
    std::string_view name, extension, title = {}, look = {};
    StageId stage = StageId::Shading;
    std::array<std::string_view, 2> buffers = {};  // by their names
};
// Each is a file of resources/scenes. The first is the one to begin with.
constexpr auto kScenes = std::to_array<Row>({
    {"pyramid", ".scene", "Pyramid", "The lecture's example: five polygons, of which three face the viewer."},
    {"box_over_plane",
     ".scene",
     "Box over a floor",
     "The shadow lies beside the box, for the light comes from the side.",
     StageId::Shading,
     {"color", "shadow.0"}},
    {"two_pyramids",
     ".scene",
     "Two pyramids",
     "Where the near pyramid stands before the far one, the z-buffer keeps the nearer; its shadow falls on the far "
     "one.",
     StageId::ZBuffer,
     {"polygon_id", "depth"}},
    {"lambert", ".toml", {}, {}, StageId::Shading, {"color", "n_dot_l.0"}},
    {"reflection_law", ".toml", {}, {}, StageId::Shading, {"color", "r_dot_v.0"}},
    {"flat_gouraud_phong", ".toml", {}, {}, StageId::Shading, {"color", "intensity"}},
    {"no_hidden_surface_removal", ".toml", {}, {}, StageId::ZBuffer, {"color", "overdraw"}},
    {"back_face_culling", ".toml", {}, {}, StageId::Cull, {"polygons.verdict", "color"}},
    {"z_buffer_flat", ".toml", {}, {}, StageId::ZBuffer, {"depth", "color"}},
    {"z_buffer_gouraud", ".toml", {}, {}, StageId::ZBuffer, {"depth", "color"}},
    {"z_buffer_phong", ".toml", {}, {}, StageId::ZBuffer, {"depth", "color"}},
    {"interpolation", ".toml", {}, {}, StageId::Shading, {"color", "intensity"}},
    {"rgb_triangle", ".toml", {}, {}, StageId::Shading, {"color", "k_d"}},
    {"highlight_exponents", ".toml", {}, {}, StageId::Shading, {"color", "specular.0"}},
    {"phong_blinn", ".toml", {}, {}, StageId::Shading, {"color", "specular.0"}},
    {"microfacets", ".toml", {}, {}, StageId::Shading, {"color", "specular.0"}},
    {"vertex_normals", ".toml", {}, {}, StageId::Normals, {"color", "normal"}},
    {"ambient", ".toml", {}, {}, StageId::Shading, {"color", "ambient"}},
    {"coloured_lights", ".toml", {}, {}, StageId::Shading, {"color", "diffuse.0"}},
    {"near_plane", ".toml", {}, {}, StageId::Cull, {"color", "polygons.verdict"}},
    {"intersecting_polygons", ".toml", {}, {}, StageId::ZBuffer, {"polygon_id", "depth"}},
    {"cyclic_overlap", ".toml", {}, {}, StageId::ZBuffer, {"polygon_id", "depth"}},
    {"translucent", ".toml", {}, {}, StageId::Shading, {"color", "layers"}},
    {"translucent_cycle", ".toml", {}, {}, StageId::Shading, {"color", "layers"}},
    {"z_fighting", ".toml", {}, {}, StageId::ZBuffer, {"object_id", "depth"}},
    {"concave_polygon", ".toml", {}, {}, StageId::ZBuffer, {"polygon_id", "color"}},
    {"point_light_shadow", ".toml", {}, {}, StageId::Shading, {"color", "shadow.0"}},
    {"soft_shadow", ".toml", {}, {}, StageId::Shading, {"color", "shadow.0"}},
    {"shadow_bias", ".toml", {}, {}, StageId::Shading, {"color", "shadow.0"}},
    {"teapot", ".toml", {}, {}, StageId::Shading, {"color", "normal"}},
    {"gl_cube", ".toml", {}, {}, StageId::Shading, {"color", "intensity"}},
});

fs::path s_resources;  // empty: looked for

}  // namespace

void setResourceFolder(fs::path folder) { s_resources = std::move(folder); }

fs::path resourceFolder() {
    if (!s_resources.empty()) return s_resources;
    std::error_code failed;
    const fs::path program = fs::read_symlink("/proc/self/exe", failed);
    if (!failed) {
        const fs::path installed = program.parent_path().parent_path() / "share" / "shadescope";
        if (fs::is_directory(installed / "scenes", failed)) return installed;
    }
    return SHADESCOPE_RESOURCES;
}

namespace {

fs::path fileOf(const Row& row) {
    return resourceFolder() / "scenes" / (std::string(row.name) + std::string(row.extension));
}

BuiltInScene made(const Row& row) {
    BuiltInScene scene{
        std::string(row.name), std::string(row.title), std::string(row.look), fileOf(row), row.stage, {}};
    for (const std::string_view name : row.buffers)
        if (const auto buffer = findBuffer(name)) scene.buffers.push_back(*buffer);
    if (!row.title.empty()) return scene;
    const Result<std::string> text = readFile(scene.file, kMaxTomlBytes);
    const SceneTitle given = text ? readTomlTitle(*text) : SceneTitle();
    scene.title = given.title.empty() ? scene.name : given.title;
    scene.look = given.look;
    return scene;
}

}  // namespace

std::vector<BuiltInScene> builtInScenes() {
    std::vector<BuiltInScene> scenes;
    for (const Row& row : kScenes) scenes.push_back(made(row));
    return scenes;
}

std::optional<BuiltInScene> builtInScene(std::string_view name) {
    const auto row = std::ranges::find(kScenes, name, &Row::name);
    return row == kScenes.end() ? std::nullopt : std::optional(made(*row));
}

std::optional<BuiltInScene> builtInSceneOf(const fs::path& file) {
    std::error_code ignored;
    for (const Row& row : kScenes)
        if (file.stem() == row.name && fs::equivalent(fileOf(row), file, ignored)) return made(row);
    return {};
}

}  // namespace pipeline
