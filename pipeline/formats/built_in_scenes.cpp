#include "pipeline/formats/built_in_scenes.h"

#include <array>
#include <string_view>

namespace pipeline {
namespace {

namespace fs = std::filesystem;

struct Row {
    std::string_view name, title, look;
};
// Each is resources/scenes/NAME.scene. The first is the one to begin with.
constexpr std::array<Row, 3> kScenes{{
    {"pyramid", "Pyramid", "The lecture's example: five polygons, of which the picture needs two."},
    {"box_over_plane", "Box over a floor", "The shadow lies beside the box, for the light comes from the side."},
    {"two_pyramids", "Two pyramids",
     "Where the near pyramid stands before the far one, the z-buffer keeps the nearer."},
}};

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
    for (const Row& row : kScenes)
        scenes.push_back({std::string(row.name), std::string(row.title), std::string(row.look),
                          folder / (std::string(row.name) + ".scene")});
    return scenes;
}

}  // namespace pipeline
