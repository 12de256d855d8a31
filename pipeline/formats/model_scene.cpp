#include "pipeline/formats/model_scene.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "pipeline/formats/model_reader.h"
#include "pipeline/formats/object_names.h"

namespace pipeline {

void showAll(Scene& scene) {
    Vec3d low = scene.objects.front().mesh->positions[0], high = low;
    for (const Object& object : scene.objects)
        for (const Vec3d& p : object.mesh->positions) {
            low = glm::min(low, p);
            high = glm::max(high, p);
        }
    const Vec3d center = 0.5 * (low + high);
    const double halfDiagonal = glm::length(high - center);
    const double radius = halfDiagonal > 0 ? halfDiagonal : 1;
    for (Object& object : scene.objects) object.transform.translation = -center;
    // Four radii away, a sphere's outline appears at d / sqrt(4² - 1) from the picture's centre;
    // it is to fill four fifths of the picture's height.
    scene.camera.rho = 4 * radius;
    scene.camera.screenDistance = 0.8 * scene.settings.height / 2 * std::sqrt(15.0);
    // Beside the eye: from the example's direction the two sides of a cube would look alike.
    scene.lights.push_back({.position = {500, 200, 600}, .intensity = 100});
    scene.ambient.intensity = 50;
}

Result<Scene> readModelScene(const SourceText& source, const FileLoader& load) {
    Result<LoadedModel> model = readModel(source, std::filesystem::path(source.name).extension().string(), load);
    if (!model) return model.errors();
    Scene scene;
    scene.objects = std::move(model).value().objects;
    scene.remarks = std::move(model).value().remarks;
    tellApart(scene.objects);
    const auto hasNormals = [](const Object& object) { return !object.mesh->normals.empty(); };
    if (std::ranges::any_of(scene.objects, hasNormals)) {
        scene.settings.shading = Shading::Phong;
        scene.settings.normalWeight = NormalWeight::Given;
    }
    showAll(scene);
    return scene;
}

}  // namespace pipeline
