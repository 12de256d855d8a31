#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/core/result.h"
#include "pipeline/scene/scene.h"

namespace bench {

// What the comparison with OpenGL draws: meshes that are computed, so that whoever has the repository draws the same, or a
// model of the user's.
struct Workload {
    std::string name;   // "70k"; of a model its file's
    int triangles = 0;  // about; a sphere's rings leave no free choice
    int spheres = 1;    // along each side of a cube of them: the more, the more surfaces lie over each other
    int width = 640, height = 480;
    int shadowSize = 1024;
    std::filesystem::path file{};  // of a model, instead of spheres
};

// What is drawn of it.
enum class Part : std::uint8_t { Depth, Phong, PhongShadow };
inline constexpr Part kParts[]{Part::Depth, Part::Phong, Part::PhongShadow};
std::string name(Part part, const Workload& workload);  // "Phong + 1024²"

// The five rows of the table.
const std::vector<Workload>& workloads();
const Workload& workload(std::string_view name);  // one of them

// Triangles with smooth normals, one light at infinity from (1, 1, 1), the camera 20 degrees beside the axis with the
// bounding sphere filling the picture's height. `moved`: the camera stands elsewhere, by a distance
// that no picture shows.
pipeline::Scene sceneOf(const Workload& workload, Part part, std::shared_ptr<const pipeline::Mesh> mesh, bool moved,
                        pipeline::Arithmetic arithmetic);
// A mesh of triangles, with a normal at every vertex and in float, as OpenGL gets them: neither side draws what the other
// cannot see. Only a model's file has errors.
pipeline::Result<std::shared_ptr<const pipeline::Mesh>> meshOf(const Workload& workload);

}  // namespace bench
