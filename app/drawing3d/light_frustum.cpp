#include "app/drawing3d/light_frustum.h"

#include <algorithm>
#include <cmath>

#include "pipeline/buffers/palette.h"
#include "pipeline/run/frame_data.h"

namespace app {

namespace {

constexpr int kMostTexels = 512;  // along a side; a larger buffer is thinned out evenly

template <class Real>
LightFrustum frustumOf(int light, int face, const pipeline::View& view, const pipeline::Buffer2D<Real>& depth) {
    LightFrustum result;
    result.light = light;
    result.face = face;
    result.view = view;
    result.end = 0;
    bool first = true;
    for (const Real& value : depth.pixels) {
        const auto z = double(value);
        if (!std::isfinite(z)) continue;
        result.begin = first ? z : std::min(result.begin, z);
        result.end = first ? z : std::max(result.end, z);
        first = false;
        ++result.texels;
    }
    // A face that sees nothing is shown as far as another one would see.
    if (result.texels == 0) result.end = view.far / 2;
    const double range = result.end - result.begin;
    const double least = range > 0 ? range : std::max(std::abs(result.end), 1.0);
    // Before what it shows: by a third of its depth, or for a point light half way to the nearest.
    result.plane = view.perspective ? result.begin / 2 : result.begin - 0.35 * least;
    if (result.texels == 0) result.plane = view.perspective ? result.end / 4 : view.near;
    const int step = std::max(1, (depth.size.x + kMostTexels - 1) / kMostTexels);
    result.picture.size = (depth.size + step - 1) / step;
    result.picture.pixels.reserve(std::size_t(result.picture.size.x) * std::size_t(result.picture.size.y));
    for (int y = 0; y < depth.size.y; y += step)
        for (int x = 0; x < depth.size.x; x += step)
            result.picture.pixels.push_back(pipeline::paletteColor(
                pipeline::Palette::Sequential, double(depth.at({x, y})), result.begin, result.begin + least));
    return result;
}

}  // namespace

std::vector<LightFrustum> lightFrusta(const pipeline::Frame& frame) {
    if (frame.until() < pipeline::StageId::ShadowBuffer) return {};
    std::vector<LightFrustum> result;
    pipeline::readStages(frame, [&](const auto& data) {
        if (!data.shadowBuffer) return;
        const auto& lights = data.shadowBuffer->lights;
        for (std::size_t k = 0; k < lights.size(); ++k) {
            if (lights[k].empty()) continue;
            const auto& sample = lights[k][lights[k].size() / 2];
            const auto first = std::ptrdiff_t(result.size());
            for (std::size_t face = 0; face < sample.faces.size(); ++face) {
                result.push_back(frustumOf(int(k), int(face), sample.faces[face], *sample.depth[face]));
                result.back().faces = int(sample.faces.size());
            }
            std::stable_sort(result.begin() + first, result.end(),
                             [](const LightFrustum& a, const LightFrustum& b) { return a.texels > b.texels; });
        }
    });
    return result;
}

}  // namespace app
