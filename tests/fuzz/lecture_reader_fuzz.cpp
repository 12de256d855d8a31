// Any bytes as a scene, or as an object that a scene names: whatever they are, there is a scene
// that keeps its promises, or there are errors that point into the text.
#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include "pipeline/formats/format_table.h"
#include "pipeline/formats/lecture_formats.h"

namespace {

void require(bool promise) {
    if (!promise) std::abort();
}

void checkMesh(const pipeline::Mesh& mesh) {
    std::size_t triangles = 0;
    for (std::size_t i = 0; i < mesh.polygonCount(); ++i) {
        require(mesh.polygon(i).size() >= 3);
        for (const std::uint32_t corner : mesh.polygon(i)) require(corner < mesh.positions.size());
        require(mesh.firstTriangle[i] == triangles);
        triangles += mesh.polygon(i).size() - 2;
    }
    require(mesh.triangles.size() == triangles);
}

void checkErrors(const pipeline::Errors& errors) {
    require(!errors.empty() && errors.size() <= pipeline::kMaxErrors);
    for (const pipeline::Error& error : errors) {
        require(!error.found.empty() && error.found.size() < 500);
        require(!error.where.file.empty());
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view input(reinterpret_cast<const char*>(data), size);
    // Up to the first zero byte it is the scene; the rest is every object file.
    const std::size_t sceneSize = std::min(input.find('\0'), size);
    const std::string_view object = input.substr(std::min(sceneSize + 1, size));
    const pipeline::FileLoader load = [&](std::string_view name) -> pipeline::Result<pipeline::NamedFile> {
        return pipeline::NamedFile{std::string(object), std::string(name)};
    };
    for (const pipeline::Format& format : pipeline::formatTable()) {
        format.looksLike(input);
        const pipeline::Result<pipeline::Scene> scene = format.read({input.substr(0, sceneSize), "scene"}, load);
        if (!scene) {
            checkErrors(scene.errors());
            continue;
        }
        for (const pipeline::Object& part : scene->objects) checkMesh(*part.mesh);
    }
    return 0;
}
