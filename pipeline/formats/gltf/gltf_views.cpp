#include "pipeline/formats/gltf/gltf_views.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "pipeline/core/text.h"
#include "pipeline/formats/gltf/gltf_formats.h"

// glTF 2.0, section 3.10, and KHR_lights_punctual (Khronos Group, 2018): both look along -z of their node.
namespace pipeline {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;
constexpr double kMost = 1e30;
constexpr const char* kLights = "KHR_lights_punctual";

struct Place {
    Vec3d at, back, up;  // world space; back and up of any length but 0
};

// The objects of a framed scene stand y up, moved by one vector.
Place placeOf(const Scene& scene, const glm::dmat4& toFile) {
    const Vec3d offset = scene.objects.empty() ? Vec3d(0) : scene.objects[0].transform.translation;
    const UpAxis up = UpAxis::Y;
    return {upright(up, Vec3d(toFile[3])) + offset, upright(up, Vec3d(toFile[2])), upright(up, Vec3d(toFile[1]))};
}

Camera cameraOf(const GltfValue& value, const Place& place) {
    Camera camera;
    camera.kind = CameraKind::LookAt;
    camera.eye = place.at, camera.target = place.at - place.back, camera.up = place.up;
    const bool isFlat = value["type"].text() == "orthographic";
    camera.projection = isFlat ? ProjectionKind::Orthographic : ProjectionKind::Perspective;
    const GltfValue lens = value[isFlat ? "orthographic" : "perspective"];
    if (!lens.isThere()) lens.refuse("its numbers");
    const GltfValue size = lens[isFlat ? "ymag" : "yfov"];
    if (const auto number = size.number(0, isFlat ? kMost : std::numbers::pi))
        (isFlat ? camera.height : camera.fovY) = isFlat ? 2 * *number : kDegrees * *number;
    else if (!size.isThere())
        size.refuse("a number");
    // Without a far plane the program chooses both.
    const auto near = lens["znear"].number(0, kMost), far = lens["zfar"].number(0, kMost);
    if (near && far && *near > 0 && *near < *far) camera.near = *near, camera.far = *far;
    return camera;
}

Light lightOf(const GltfValue& value, const Place& place, double radius) {
    Light light;
    std::array<double, 3> color{1, 1, 1};
    value["color"].numbers(color, 0, kMost);
    light.color = {color[0], color[1], color[2]};
    light.intensity = value["intensity"].isThere() ? value["intensity"].number(0, kMost).value_or(0) : 1;
    const auto kind = value["type"].text();
    if (kind == "directional") {
        light.position = place.back;
        return light;
    }
    if (kind != "point" && kind != "spot") value["type"].refuse("directional, point or spot");
    light.kind = LightKind::Point, light.position = place.at;
    // Candela: at the middle, or a tenth of the scene's radius from the light.
    const double distance = std::max(glm::length(place.at), radius / 10);
    light.intensity /= distance * distance;
    if (kind == "spot") {
        light.gl.spotDirection = -place.back;
        const auto outer = value["spot"]["outerConeAngle"].number(0, std::numbers::pi / 2);
        light.gl.spotCutoff = outer ? kDegrees * *outer : 45;
    }
    return light;
}

double radiusOf(const Scene& scene) {
    double radius = 0;
    for (const Object& object : scene.objects)
        for (const Vec3d& corner : {object.mesh->facts.low, object.mesh->facts.high})
            radius = std::max(radius, glm::length(upright(UpAxis::Y, corner) + object.transform.translation));
    return radius > 0 ? radius : 1;
}

Result<GltfFile> parseFile(const std::filesystem::path& file, const ReadProgress& progress) {
    const Result<NamedFile> opened = openFile(file);
    if (!opened) return opened.errors();
    const Result<std::string> text = wholeText({opened->text, file.string(), progress, opened->tail});
    if (!text) return text.errors();
    return parseGltf({*text, file.string(), progress});
}

}  // namespace

Result<std::vector<std::string>> gltfCameras(const std::filesystem::path& file, const ReadProgress& progress) {
    Result<GltfFile> parsed = parseFile(file, progress);
    if (!parsed) return parsed.errors();
    GltfFile gltf = std::move(parsed).value();
    std::vector<std::string> names;
    for (const GltfNode& node : nodesOf(gltf)) {
        const auto camera = node.node["camera"].element("cameras");
        if (!camera) continue;
        const auto name = (*camera)["name"].text(), ofNode = node.node["name"].text();
        names.push_back(name     ? std::string(*name)
                        : ofNode ? std::string(*ofNode)
                                 : fmt::format("camera {}", names.size()));
    }
    if (!gltf.errors.empty()) return gltf.errors;
    return names;
}

Result<Scene> withGltfViews(Scene scene, const std::filesystem::path& file, const GltfViews& views,
                            const ReadProgress& progress) {
    const char* const option = views.camera ? "--camera" : "--lights";
    const std::string extension = file.extension().string();
    if (!scene.framed || !(sameLetters(extension, ".gltf") || sameLetters(extension, ".glb")))
        return Error{{file.string()}, fmt::format("{} takes what a glTF file has", option), "a .gltf or .glb"};
    Result<GltfFile> parsed = parseFile(file, progress);
    if (!parsed) return parsed.errors();
    GltfFile gltf = std::move(parsed).value();
    std::vector<Camera> cameras;
    std::vector<Light> lights;
    for (const GltfNode& node : nodesOf(gltf)) {
        const Place place = placeOf(scene, node.toWorld);
        if (const auto camera = node.node["camera"].element("cameras")) cameras.push_back(cameraOf(*camera, place));
        const GltfValue light = node.node["extensions"][kLights]["light"];
        if (!light.isThere()) continue;
        const GltfValue list = GltfValue(gltf)["extensions"][kLights]["lights"];
        if (const auto i = light.whole(0, std::max<std::size_t>(list.size(), 1) - 1); i && *i < list.size())
            lights.push_back(lightOf(list.at(*i), place, radiusOf(scene)));
    }
    if (!gltf.errors.empty()) return gltf.errors;
    if (views.camera) {
        if (*views.camera >= cameras.size())
            return Error{{file.string()},
                         fmt::format("the file has {}", plural(std::int64_t(cameras.size()), "camera")),
                         cameras.empty() ? "no --camera" : fmt::format("--camera 0 to {}", cameras.size() - 1)};
        scene.camera = cameras[*views.camera];
    }
    if (!views.lights) return scene;
    if (lights.empty()) return Error{{file.string()}, "the file has no light", "no --lights"};
    double sum = 0;
    for (const Light& light : lights) sum += light.intensity;
    // Together as bright as the light that the program adds.
    const double all = scene.lights.empty() ? 1 : scene.lights[0].intensity;
    for (Light& light : lights) light.intensity *= sum > 0 ? all / sum : 0;
    scene.lights = std::move(lights);
    return scene;
}

}  // namespace pipeline
