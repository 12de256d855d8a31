#include "pipeline/formats/model_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "pipeline/core/text.h"
#include "pipeline/formats/model_reader.h"
#include "pipeline/formats/object_names.h"
#include "pipeline/formats/up_axis.h"
#include "pipeline/scene/framing.h"

namespace pipeline {
namespace {

// glTF says which axis is up, and its reader has done what follows from that. STL files come from construction and
// printing, where z is up.
void findUp(const SourceText& source, Scene& scene) {
    if (upOf(scene) == UpAxis::Y)
        return scene.remarks.push_back({"up", "y of the file points up, as in every glTF file."});
    const std::string extension = std::filesystem::path(source.name).extension().string();
    const UpGuess guess = sameLetters(extension, ".stl") ? UpGuess{UpAxis::Z, "as in most STL files"}
                                                         : guessUp(source.text, scene.objects, source.progress.stop);
    for (Object& object : scene.objects) object.transform.up = guess.up;
    const bool isY = guess.up == UpAxis::Y;
    const char up = isY ? 'y' : 'z', other = isY ? 'z' : 'y';
    scene.remarks.push_back(
        {fmt::format("up={}", up),
         fmt::format("{} of the file is taken to point up: {}; up={} turns it.", up, guess.why, other)});
}

}  // namespace

Result<Scene> readModelScene(const SourceText& source, const FileLoader& load) {
    Result<LoadedModel> model = readModel(source, std::filesystem::path(source.name).extension().string(), load);
    if (!model) return model.errors();
    Scene scene;
    scene.objects = std::move(model).value().objects;
    scene.remarks = std::move(model).value().remarks;
    tellApart(scene.objects);
    findUp(source, scene);
    const auto hasNormals = [](const Object& object) { return !object.mesh->normals.empty(); };
    const auto hasColors = [](const Object& object) { return !object.mesh->colors.empty(); };
    if (std::ranges::any_of(scene.objects, hasNormals)) {
        scene.settings.shading = Shading::Phong;
        scene.settings.normalWeight = NormalWeight::Given;
    } else if (std::ranges::any_of(scene.objects, hasColors)) {
        scene.settings.shading = Shading::Phong;  // a flat polygon would have one colour
    }
    if (model->doubleSided) {
        scene.settings.cull = CullMode::None;
        // glTF 2.0, section 3.9.5. Of closed meshes no back is seen.
        scene.settings.twoSided =
            std::ranges::any_of(scene.objects, [](const Object& object) { return !object.mesh->facts.closed; });
    }
    frameModel(scene);
    return scene;
}

}  // namespace pipeline
