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

// glTF says which axis is up, and its reader has done what follows from that. Of the other formats OBJ alone is written
// both ways about as often.
void findUp(const SourceText& source, Scene& scene) {
    const auto remark = [&](std::string text) { scene.remarks.push_back({"up", std::move(text)}); };
    if (upOf(scene) == UpAxis::Y) return remark("y of the file points up, as in every glTF file.");
    const std::string extension = std::filesystem::path(source.name).extension().string();
    const UpGuess guess = sameLetters(extension, ".obj") ? guessUp(source.text, scene.objects) : UpGuess();
    for (Object& object : scene.objects) object.transform.up = guess.up;
    const bool isY = guess.up == UpAxis::Y;
    remark(fmt::format("{} of the file is taken to point up{}{}; up={} turns it.", isY ? 'y' : 'z',
                       guess.why.empty() ? "" : ": ", guess.why, isY ? 'z' : 'y'));
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
    if (std::ranges::any_of(scene.objects, hasNormals)) {
        scene.settings.shading = Shading::Phong;
        scene.settings.normalWeight = NormalWeight::Given;
    }
    if (model->doubleSided) scene.settings.cull = CullMode::None;
    frameModel(scene);
    return scene;
}

}  // namespace pipeline
