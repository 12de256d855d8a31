// Defects within stage 6, at its points, sums and frame buffer.
#include <algorithm>
#include <array>
#include <cmath>

#include "pipeline/core/elementary.h"
#include "pipeline/core/numerics.h"
#include "pipeline/defects/defect_ways.h"
#include "pipeline/defects/drawing_hooks.h"
#include "pipeline/defects/hooks.h"
#include "pipeline/defects/own_hooks.h"
#include "pipeline/stages/interpolate.h"
#include "pipeline/stages/shading.h"
#include "pipeline/stages/translucent.h"

namespace pipeline {

template <class Real>
void spoilSurface(const ShadingInputs& inputs, Surface<Real>& surface) {
    if (inputs.planted.own) return ownSurface(inputs, surface);
    if (inputs.planted.defect == Defect::EyeAtOrigin)
        surface.V = inputs.planted.way == 0   ? normalized(-surface.position, inputs.illumination.detail.unit)
                    : inputs.planted.way == 1 ? -surface.V
                                              : -Vec3<Real>(inputs.shadow.eye->forward);
    // Who forgets the division still looks from the eye.
    const bool looksFromEye = modelFacts(inputs.illumination.model).viewer == Viewer::Camera;
    if (inputs.planted.defect == Defect::HalfAngle && looksFromEye)
        surface.V = normalized(Vec3<Real>(inputs.shadow.eye->eye) - surface.position, inputs.illumination.detail.unit);
    if (inputs.planted.defect == Defect::LightInEye) {  // V's numbers too
        const View& view = *inputs.shadow.eye;
        const Vec3d v(surface.V);
        const double along = inputs.planted.way % 2 == 0 ? -v.z : v.z;
        surface.V = Vec3<Real>(v.x * view.right + v.y * view.up + along * view.forward);
    }
}

namespace {

// The weights of vertices that are sorted by their rows, for values that stay in the order of the file.
template <class Real>
VertexWeights<Real> sortedAlone(const TransformOutput<Real>& in, const VertexWeights<Real>& right) {
    std::array<std::size_t, 4> order{0, 1, 2, 3};
    const auto row = [&](std::size_t i) {
        const Vec3<Real> v = in.viewSpace(right.vertices[i]);
        return in.view.perspective && v.z > 0 ? -v.y / v.z : -v.y;
    };
    std::stable_sort(order.begin(), order.begin() + std::ptrdiff_t(right.count),
                     [&](std::size_t a, std::size_t b) { return row(a) < row(b); });
    VertexWeights<Real> out = right;
    for (std::size_t i = 0; i < right.count; ++i) out.weights[i] = right.weights[order[i]];
    return out;
}

// Weights that are right in perspective, from those of a picture without it; as they are where a vertex is behind the eye.
template <class Real>
VertexWeights<Real> dividedByDepth(const TransformOutput<Real>& in, const VertexWeights<Real>& flat) {
    VertexWeights<Real> out = flat;
    Real sum(0);
    for (std::size_t i = 0; i < out.count; ++i) {
        const Real z = in.viewSpace(out.vertices[i]).z;
        if (!(z > 0)) return flat;
        sum += out.weights[i] /= z;
    }
    for (std::size_t i = 0; i < out.count; ++i) out.weights[i] /= sum;
    return out;
}

// A surface's normal becomes another one, on the same side: that of a back face has been turned round.
template <class Real>
void turnTo(Vec3<Real>& normal, Vec3<Real> other) {
    normal = glm::dot(other, normal) < 0 ? -other : other;
}

// The interpolated normal of a way of normal-short.
template <class Real>
Vec3<Real> wrongNormal(const ShadingInputs& inputs, const ShadingSources<Real>& in, VertexWeights<Real> weights) {
    const auto normalOf = [&](std::uint32_t vertex) { return in.normals.vertex[vertex]; };
    switch (inputs.planted.way) {
        case kOneVertex: return normalOf(weights.vertices[0]);
        case kAlike: weights.weights.fill(1 / Real(weights.count)); break;
        case kSortedAlone: weights = sortedAlone(in.transform, weights); break;
        case kExchanged: std::swap(weights.weights[0], weights.weights[1]); break;
        default: return interpolated(weights, normalOf);  // not made unit
    }
    return normalized(interpolated(weights, normalOf), inputs.illumination.detail.unit);
}

}  // namespace

template <class Real>
void spoilPixel(const ShadingInputs& inputs, const ShadingSources<Real>& in, const VertexWeights<Real>& weights,
                Surface<Real>& surface) {
    const auto placeOf = [&](std::uint32_t vertex) { return in.transform.world[vertex]; };
    if (inputs.planted.defect == Defect::Affine) {
        surface.position = interpolated(weights, placeOf);
        if (modelFacts(inputs.illumination.model).viewer == Viewer::Camera)
            surface.V = towardsEye(in.transform.view, surface.position, inputs.illumination.detail.unit);
    }
    if (inputs.planted.defect == Defect::HalfAngle) {
        const VertexWeights<Real> divided = dividedByDepth(in.transform, weights);
        surface.position = interpolated(divided, placeOf);
        if (!in.normals.vertex.empty())
            turnTo(surface.N, normalized(interpolated(divided, [&](auto v) { return in.normals.vertex[v]; }),
                                         inputs.illumination.detail.unit));
    }
    spoilSurface(inputs, surface);
    if (inputs.planted.own) return ownPixel(*inputs.planted.own, in, weights, surface);
    if (inputs.planted.defect != Defect::NormalShort || in.normals.vertex.empty()) return;
    turnTo(surface.N, wrongNormal(inputs, in, weights));
}

template <class Real>
void spoilAmbient(const Planted& planted, std::size_t light, Real shadow, Vec3<Real> whole, Vec3<Real>& ambient,
                  Vec3<Real>& intensity) {
    const Vec3<Real> before = ambient;
    const bool isRight = planted.way > 0;  // the term itself, in a buffer of its own; the sum is not
    switch (planted.defect) {
        case Defect::AmbientInShadow:
            if (light == 0 && planted.way < kHighlightInShadow) ambient = shadow * whole;
            break;
        case Defect::AmbientPerLight:
            if (light > 0) ambient += whole;
            break;
        case Defect::NoAmbient: ambient = Vec3<Real>(0); break;
        default: return;
    }
    intensity += ambient - before;
    if (isRight) ambient = before;
}

void spoilFrameBuffer(const Planted& planted, Vec3d intensity, double iMax, Color8& value) {
    if (planted.own) return ownFrameBuffer(*planted.own, intensity, iMax, value);
    constexpr double kGammas[]{2.2, 1.8, 2.4};
    for (int c = 0; c < 3; ++c) {
        const double share = iMax > 0 && std::isfinite(intensity[c]) ? intensity[c] / iMax : 0;
        const double within = std::clamp(share, 0.0, 1.0);
        switch (planted.defect) {
            case Defect::Integer: value[c] = std::uint8_t(int(within) * 255); break;
            case Defect::Wrap: {
                const double byte = std::fmod(std::floor(share * 255 + 0.5), 256.0);
                value[c] = std::uint8_t(byte < 0 ? byte + 256 : byte);
                break;
            }
            case Defect::Gamma:
                value[c] = std::uint8_t(
                    pow(within, 1.0 / kGammas[std::min<std::size_t>(planted.way, std::size(kGammas) - 1)]) * 255 + 0.5);
                break;
            case Defect::NoScale:
                value[c] = std::uint8_t(std::isfinite(intensity[c]) ? std::clamp(intensity[c], 0.0, 255.0) + 0.5 : 0);
                break;
            default: break;
        }
    }
    if (planted.defect == Defect::Bgr) std::swap(value.r, value.b);
}

template <class Real>
void spoilTile(const Planted& planted, Tile tile, ShadingOutput<Real>& out) {
    if (planted.defect != Defect::BlocksOfFour) return;
    const int side = planted.way == kFourByFour ? 4 : 2;  // divides that of a tile
    auto& intensity = out.vectors[index(BufferId::Intensity)][0].pixels;
    for (int y = tile.min.y; y < tile.max.y; ++y) {
        for (int x = tile.min.x; x < tile.max.x; ++x) {
            const std::size_t at = out.color.offset({x, y}), first = out.color.offset(glm::ivec2(x, y) / side * side);
            intensity[at] = intensity[first], out.color.pixels[at] = out.color.pixels[first];
        }
    }
}

template <class Real>
void spoilLayers(const Planted& planted, std::vector<Layer<Real>>& layers) {
    if (planted.defect != Defect::Unsorted) return;
    // One number for pixel and triangle: a picture has fewer than 2^16 columns and rows.
    const auto inTheFile = [](const Layer<Real>& layer) {
        return std::uint64_t(layer.pixel.y) << 48 | std::uint64_t(layer.pixel.x) << 32 | layer.triangle;
    };
    std::ranges::stable_sort(layers, {}, inTheFile);
}

#define SHADESCOPE_INSTANTIATE(Real)                                                                        \
    template void spoilSurface(const ShadingInputs&, Surface<Real>&);                                       \
    template void spoilPixel(const ShadingInputs&, const ShadingSources<Real>&, const VertexWeights<Real>&, \
                             Surface<Real>&);                                                               \
    template void spoilAmbient(const Planted&, std::size_t, Real, Vec3<Real>, Vec3<Real>&, Vec3<Real>&);    \
    template void spoilTile(const Planted&, Tile, ShadingOutput<Real>&);                                    \
    template void spoilLayers(const Planted&, std::vector<Layer<Real>>&);
SHADESCOPE_FOR_EVERY_REAL(SHADESCOPE_INSTANTIATE)
#undef SHADESCOPE_INSTANTIATE

}  // namespace pipeline
