#include "pipeline/inspect/picture_vectors.h"

#include <cmath>

#include "pipeline/core/angles.h"
#include "pipeline/inspect/pixel_report.h"
#include "pipeline/scene/hold/hold.h"
#include "pipeline/scene/view.h"

namespace pipeline {

std::optional<PictureVectors> vectorsInPicture(const Frame& frame, glm::ivec2 pixel) {
    const Scene& scene = frame.scene();
    if (pixel.x < 0 || pixel.y < 0 || pixel.x >= scene.settings.width || pixel.y >= scene.settings.height) return {};
    const PixelReport report = inspectShading(frame, pixel);
    if (report.evaluations.empty() || report.evaluations[0].lights.empty()) return {};
    const auto& evaluation = report.evaluations[0];
    const View view = makeView(scene);
    const Vec3d N = evaluation.N, L = evaluation.lights[0].L;
    // Flat shading evaluates in the middle of the polygon, where N and an L from infinity are the same as here.
    const bool isSameHere = evaluation.vertex < 0 && scene.lights[0].kind == LightKind::AtInfinity;
    const Vec3d at = isSameHere ? report.position : evaluation.position;
    const double depth = view.perspective ? toView(view, at).z : 1;
    const double reach = 0.2 * view.size.y / view.scale.y * depth;
    const glm::dvec2 middle = glm::dvec2(pixel) + 0.5;
    const auto inPicture = [&](const Vec3d& direction) {
        return projected(view, at + reach * direction).value_or(middle);
    };
    PictureVectors vectors{
        .at = projected(view, at).value_or(middle), .N = inPicture(N), .L = inPicture(L), .nDotL = glm::dot(N, L)};
    const Material& material =
        effectiveMaterial(scene.objects[std::size_t(report.object)], scene.settings, report.back);
    const Model model = scene.settings.model;
    if (shines(model, material) && modelFacts(model).specularReads(usesHalfway(model, material)).H)
        vectors.H = inPicture(evaluation.lights[0].H);
    for (int i = 0; i <= 16; ++i) {
        const Vec3d between = (1 - i / 16.0) * N + i / 16.0 * L;
        const double length = glm::length(between);
        if (length > 0) vectors.arc.push_back(inPicture(0.45 / length * between));
    }
    const Vec3d side = glm::normalize(glm::cross(std::abs(N.z) < 0.9 ? Vec3d(0, 0, 1) : Vec3d(1, 0, 0), N));
    for (int i = 0; i <= 32; ++i)
        vectors.horizon.push_back(
            inPicture(0.6 * (cosDegrees(11.25 * i) * side + sinDegrees(11.25 * i) * glm::cross(N, side))));
    return vectors;
}

}  // namespace pipeline
