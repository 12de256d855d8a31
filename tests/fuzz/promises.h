#pragma once
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>

#include "pipeline/formats/scene_folder.h"
#include "pipeline/scene/scene.h"

// What every reader promises, whatever the bytes are.
namespace fuzz {

inline void require(bool promise) {
    if (!promise) std::abort();
}

inline void checkMesh(const pipeline::Mesh& mesh) {
    std::size_t triangles = 0;
    for (std::size_t i = 0; i < mesh.polygonCount(); ++i) {
        require(mesh.polygon(i).size() >= 3);
        for (const std::uint32_t corner : mesh.polygon(i)) require(corner < mesh.positions.size());
        require(mesh.firstTriangleOf(i) == triangles);
        triangles += mesh.polygon(i).size() - 2;
    }
    require(mesh.triangles.size() == triangles);
    require(mesh.normals.empty() || mesh.normals.size() == mesh.positions.size());
    require(mesh.polygonPlaces.empty() || mesh.polygonPlaces.size() == mesh.polygonCount());
    for (const pipeline::Vec3d& p : mesh.positions)
        for (int axis = 0; axis < 3; ++axis) require(std::abs(p[axis]) <= 1e9);
    for (const pipeline::Vec3d& n : mesh.normals) require(std::abs(glm::length(n) - 1) < 1e-6);
}

inline void checkMaterial(const pipeline::Material& material) {
    for (const pipeline::Vec3d& color : {material.diffuse, material.specular, material.ambient, material.emission})
        for (int c = 0; c < 3; ++c) require(std::isfinite(color[c]));
    require(material.exponent >= 0 && std::isfinite(material.exponent));
}

inline void checkErrors(const pipeline::Errors& errors) {
    require(!errors.empty() && errors.size() <= pipeline::kMaxErrors);
    for (const pipeline::Error& error : errors) {
        require(!error.found.empty() && error.found.size() < 1200);
        require(error.found.find('\n') == error.found.npos);
        require(!error.where.file.empty());
    }
}

// Up to the first zero byte the input is the text; the rest is every file that it names.
struct Input {
    std::string_view text, file;
    explicit Input(std::string_view bytes)
        : text(bytes.substr(0, bytes.find('\0'))), file(bytes.substr(std::min(text.size() + 1, bytes.size()))) {}
    pipeline::FileLoader loader() const {
        return [this](std::string_view name) -> pipeline::Result<pipeline::NamedFile> {
            return pipeline::NamedFile{std::string(file), std::string(name)};
        };
    }
};

}  // namespace fuzz
