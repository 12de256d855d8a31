#include "app/drawing3d/face_colors.h"

#include <algorithm>
#include <cmath>

#include "app/drawing3d/view_mesh.h"
#include "pipeline/illumination/illumination.h"
#include "pipeline/scene/opacity.h"
#include "pipeline/stages/cull.h"

namespace app {

using pipeline::BufferId;

namespace {

// FB / 255 of lecture 1, before rounding: I / I_max, limited to 0..1. No light at all gives black.
glm::vec3 frameBufferColor(Vec3d intensity, double iMax) {
    if (!(iMax > 0)) return glm::vec3(0);
    glm::vec3 color;
    for (int c = 0; c < 3; ++c)
        color[c] = std::isfinite(intensity[c]) ? float(std::clamp(intensity[c] / iMax, 0.0, 1.0)) : 0.0f;
    return color;
}

// Phong shading evaluates per pixel; a vertex of this view is one such pixel, taken as lit.
Vec3d intensityAt(const pipeline::Scene& scene, const std::vector<pipeline::Light>& lights,
                  const pipeline::Material& material, const pipeline::Surface<double>& at) {
    const pipeline::Illumination illumination = pipeline::illuminationOf(scene.settings);
    Vec3d sum = pipeline::emissionTerm<double>(illumination.model, material) +
                at.color * pipeline::ambientTerm<double>(illumination.model, scene.ambient, material);
    for (const pipeline::Light& light : lights) {
        const auto sample = pipeline::sampleLight<double>(illumination, light, material, at);
        sum += sample.ambient + sample.diffuse + sample.specular;
    }
    return sum;
}

}  // namespace

void colorFaces(const pipeline::Frame& frame, const pipeline::Topology& topology, ViewMesh& mesh,
                const std::stop_token& stop) {
    const pipeline::Scene& scene = frame.scene();
    const pipeline::Shading shading = scene.settings.shading;
    const double iMax = pipeline::maximumIntensity(scene);
    const bool hasRun = frame.until() >= pipeline::StageId::Shading;
    const auto verdicts = frame.buffer({BufferId::PolygonsVerdict});
    const auto flat = frame.buffer({BufferId::PolygonsIntensity});
    const auto gouraud = frame.buffer({BufferId::VerticesIntensity});
    const auto normals = frame.buffer({BufferId::VerticesNormal});
    const pipeline::View eye = pipeline::makeView(scene);
    const std::vector<pipeline::Light> lights = pipeline::lightsInWorldSpace(scene, eye);

    const auto phongColor = [&](std::size_t vertex, const pipeline::Material& material) {
        const Vec3d position = mesh.positions[vertex];
        const Vec3d towardsEye = eye.perspective ? pipeline::normalized(eye.eye - position) : -eye.forward;
        return frameBufferColor(
            intensityAt(scene, lights, material,
                        {position, row3(*normals, vertex), towardsEye, topology.vertexColor(vertex)}),
            iMax);
    };
    const auto vertexColor = [&](std::size_t vertex, const pipeline::Material& material) {
        if (hasRun && shading == pipeline::Shading::Gouraud && gouraud)
            return frameBufferColor(row3(*gouraud, vertex), iMax);
        if (hasRun && shading == pipeline::Shading::Phong && normals) return phongColor(vertex, material);
        return glm::vec3(material.diffuse * topology.vertexColor(vertex));
    };
    if (hasRun && shading == pipeline::Shading::Flat && flat) {
        mesh.polygonColors.reserve(topology.polygonCount());
        for (std::size_t p = 0; p < topology.polygonCount(); ++p)
            mesh.polygonColors.push_back(frameBufferColor(row3(*flat, p), iMax));
    } else {
        // Faces share their vertices, and a vertex has one object's material.
        mesh.vertexColors.resize(mesh.positions.size());
        for (std::size_t v = 0; v < mesh.positions.size() && !stop.stop_requested(); ++v)
            mesh.vertexColors[v] = vertexColor(v, scene.objects[topology.objectOfVertex(v)].material);
    }
    for (Face& face : mesh.faces) {
        if (stop.stop_requested()) return;
        const auto polygon = static_cast<std::size_t>(face.polygon);
        face.alpha = float(pipeline::opacity(scene.objects[topology.objectOfPolygon(polygon)].material));
        if (!verdicts) continue;
        const double code = verdicts->flat(polygon);
        face.shaded = pipeline::goesOn(static_cast<pipeline::Verdict>(int(code)));
    }
}

}  // namespace app
