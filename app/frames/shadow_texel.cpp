#include "app/frames/shadow_texel.h"

#include "pipeline/run/frame_data.h"
#include "pipeline/stages/interpolate.h"
#include "pipeline/stages/shadow_factor.h"
#include "pipeline/stages/z_buffer.h"

namespace app {
namespace {

template <class Real>
std::optional<glm::ivec2> texelOf(const pipeline::FrameData<Real>& data, std::size_t light, glm::ivec2 pixel) {
    if (!data.shadowBuffer || !data.zBuffer || light >= data.shadowBuffer->lights.size()) return {};
    const auto& samples = data.shadowBuffer->lights[light];
    const pipeline::Buffer2D<std::uint32_t>& triangles = *data.zBuffer->triangle;
    if (samples.empty() || pixel.x >= triangles.size.x || pixel.y >= triangles.size.y) return {};
    const std::uint32_t triangle = triangles.at(pixel);
    if (triangle == pipeline::kNoTriangle) return {};
    const pipeline::TransformOutput<Real>& in = *data.transform;
    const auto position = pipeline::interpolated(in.world, in.topology->triangles[triangle].vertices,
                                                 pipeline::barycentricAt(in, *data.zBuffer, pixel));
    const std::size_t middle = samples.size() / 2;
    pipeline::ShadowSettings settings = data.keys.shading.shadow;
    settings.bias = pipeline::ShadowBias::Constant;  // the only one that asks for no normal
    const auto test = pipeline::shadowTest(samples[middle], settings, position, {});
    const glm::ivec2 size = samples[middle].depth[test.face]->size;
    if (glm::any(glm::lessThan(test.texel, glm::ivec2(0))) || glm::any(glm::greaterThanEqual(test.texel, size)))
        return {};
    const auto faces = int(middle * samples[middle].faces.size() + test.face);
    return glm::ivec2(test.texel.x, faces * size.y + test.texel.y);
}

}  // namespace

std::optional<glm::ivec2> shadowTexel(const pipeline::Frame& frame, std::size_t light, glm::ivec2 pixel) {
    return pipeline::readStages(frame, [&](const auto& data) { return texelOf(data, light, pixel); });
}

}  // namespace app
