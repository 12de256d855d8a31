#include "pipeline/scene/hold/lecture_text.h"

#include <algorithm>
#include <initializer_list>

#include <fmt/format.h>

#include "pipeline/core/text.h"

namespace pipeline {

namespace {

std::string listed(std::initializer_list<double> numbers, std::string_view between = ", ") {
    std::string text;
    for (const double number : numbers) text += (text.empty() ? "" : std::string(between)) + shortestText(number);
    return text;
}
std::string listed(const Vec3d& v) { return listed({v.x, v.y, v.z}); }

}  // namespace

std::vector<LectureLine> objectLines(const Object& object) {
    const Mesh& mesh = *object.mesh;
    std::vector<LectureLine> lines{
        {1, fmt::format("{}, {}", mesh.positions.size(), mesh.polygonCount()), "how many", {}}};
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const Vec3d p = mesh.positions[v];
        lines.push_back({v == 0 ? 2 : 0, '(' + listed({p.x, p.y, p.z}, ",") + ')', fmt::format("vertex {}", v), v});
    }
    for (std::size_t p = 0; p < mesh.polygonCount(); ++p)
        lines.push_back({p == 0 ? 3 : 0,
                         fmt::format("{},({})", mesh.polygon(p).size(), fmt::join(mesh.polygon(p), ",")),
                         fmt::format("polygon {}", p),
                         {}});
    lines.push_back({4, listed(object.material.diffuse), "diffuse", {}});
    lines.push_back({5, listed({object.material.specular.x}), "specular", {}});
    lines.push_back({6, listed({object.material.exponent}), "exponent", {}});
    return lines;
}

std::vector<LectureLine> sceneLines(const Scene& scene, const std::string& objectFile) {
    const Camera& camera = scene.camera;
    const bool isFar =
        std::ranges::all_of(scene.lights, [](const Light& l) { return l.kind == LightKind::AtInfinity; });
    if (camera.kind != CameraKind::Spherical || !isFar) return {};
    std::vector<LectureLine> lines;
    const auto add = [&](std::string text, std::string meaning) {
        lines.push_back({int(lines.size()) + 1, std::move(text), std::move(meaning), {}});
    };
    add(listed({camera.screenDistance, camera.rho, camera.theta, camera.phi}), "camera");
    add(std::to_string(scene.objects.size()), "objects");
    for (const Object& object : scene.objects) {
        add(objectFile, "their file");
        const Vec3d& scale = object.transform.scale;
        add(fmt::format("{:#}, {:#}, {:#}", scale.x, scale.y, scale.z), "scale");
        add(listed(object.transform.rotation), "turn");
        add(listed(object.transform.translation), "move");
    }
    add(std::to_string(scene.lights.size()), "lights");
    for (const Light& light : scene.lights) add(listed(light.position) + ", " + shortestText(light.intensity), "light");
    add(shortestText(scene.ambient.intensityIn(scene.settings.model)), "ambient light");
    return lines;
}

}  // namespace pipeline
