// A student's functions in the shadow test and in stage 5.
#include <algorithm>
#include <limits>

#include "pipeline/core/numerics.h"
#include "pipeline/defects/drawing_hooks.h"
#include "pipeline/defects/own_hooks.h"
#include "pipeline/stages/rasterize.h"
#include "pipeline/stages/texel_test.h"
#include "pipeline/stages/z_buffer.h"

namespace pipeline {
namespace {

// A depth that is none, or behind the eye, is as far away as one can be.
template <class Real>
Real usableDepth(Real z, bool perspective) {
    constexpr double kFarthest = 1e18;
    return isfinite(z) && (!perspective || z > 0) ? z : Real(kFarthest);
}

}  // namespace

template <class Real>
void ownTest(const DepthCode& code, const RasterTriangle<Real>& triangle, const std::array<std::int64_t, 3>& e,
             ZBufferOutput<Real>& out, std::size_t at, Fragment<Real>& fragment, double& depth, bool& won) {
    const Own& own = *out.planted.own;
    const bool linear = code.format == DepthFormat::Linear;
    const glm::ivec2 size = out.zView->size;
    const glm::ivec2 pixel = out.origin + glm::ivec2(int(at) % size.x, int(at) / size.x);
    const Vec3<Real> lambda = Vec3<Real>(Real(e[0]), Real(e[1]), Real(e[2])) * triangle.inverseArea2;
    const Vec3d z = 1.0 / Vec3d(double(triangle.w[0]), double(triangle.w[1]), double(triangle.w[2]));
    OwnCall call(own);
    switch (own.function) {
        case OwnFunction::Weights:
            for (const glm::i64vec2& corner : triangle.snapped.corners) call << glm::dvec2(corner) / double(kSubPixels);
            call << glm::dvec2(pixel) + 0.5;
            if (const auto l = call.result(OwnPlace::Pixel, at))
                interpolateWith(triangle, vectorOf<Real>(*l), code.perspective, fragment);
            else
                return;
            break;
        case OwnFunction::DepthAt:
        case OwnFunction::PerspectiveWeights: {
            if (!code.perspective) return;
            call << lambda << z;
            const auto found = call.result(OwnPlace::Pixel, at);
            if (!found) return;
            if (own.function == OwnFunction::PerspectiveWeights) {
                const Vec3<Real> b = vectorOf<Real>(*found);
                fragment.barycentric =
                    b.x * triangle.weights[0] + b.y * triangle.weights[1] + b.z * triangle.weights[2];
                return;
            }
            fragment.z = Real(found->at[0]);
            break;
        }
        case OwnFunction::DepthCode: {
            if (!code.perspective || isReversed(code.format)) return;
            call << double(fragment.z) << code.near << code.far;
            const auto found = call.result(OwnPlace::Pixel, at);
            if (!found || linear) return;
            depth = found->at[0];
            won = out.triangle->pixels[at] == kNoTriangle || code.nearer(depth, out.depth.pixels[at]);
            return;
        }
        case OwnFunction::Setpixel: {
            if (!linear) return;
            const std::uint32_t there = out.triangle->pixels[at];
            const double mine = triangle.id, stored = there == kNoTriangle ? -1.0 : double(there);
            Real& storedZ = out.zView->pixels[at];
            call << pixel.x << pixel.y << mine << double(fragment.z) << double(storedZ) << stored;
            const auto found = call.result(OwnPlace::Pixel, at);
            if (!found) return;
            won = found->at[1] == mine && mine != stored;
            // What was not drawn to stays at infinity.
            const bool isNothing = !(found->at[0] < 1e18);
            const Real written = isNothing ? std::numeric_limits<Real>::infinity() : Real(found->at[0]);
            (won ? fragment.z : storedZ) = written;
            return;
        }
        default: return;
    }
    fragment.z = usableDepth(fragment.z, code.perspective);
    fragment.inverseZ = code.perspective ? 1 / fragment.z : Real(0);
    const AtLeastDouble<Real> exact(fragment.z);
    depth = code.encode(exact, 1 / exact);
    won = linear ? fragment.z < out.zView->pixels[at]
                 : out.triangle->pixels[at] == kNoTriangle || code.nearer(depth, out.depth.pixels[at]);
}

template <class Real>
void spoilCoverage(const Planted& planted, const View& view, const RasterTriangle<Real>& triangle, Tile tile,
                   const std::function<void(glm::ivec2 pixel, const std::array<std::int64_t, 3>& e)>& visit,
                   bool& isDrawn) {
    if (!planted.own || planted.own->function != OwnFunction::IsInside) return;
    isDrawn = true;
    constexpr double kEdge = 1e-3;  // share of the triangle's area: nearer to an edge rounding decides
    const std::array<glm::i64vec2, 3>& c = triangle.snapped.corners;
    const std::array<EdgeFunction, 3> edges{EdgeFunction(c[1], c[2]), EdgeFunction(c[2], c[0]),
                                            EdgeFunction(c[0], c[1])};
    const double least = kEdge * double(triangle.snapped.area2());
    const Tile box = triangle.snapped.pixels();
    const glm::ivec2 min = glm::max(tile.min, box.min), max = glm::min(tile.max, box.max);
    for (int y = min.y; y < max.y; ++y)
        for (int x = min.x; x < max.x; ++x) {
            std::array<std::int64_t, 3> e;
            bool isInside = true, isNear = false;
            Real w = 0;
            for (std::size_t i = 0; i < 3; ++i) {
                e[i] = edges[i].atPixel({x, y});
                isInside = isInside && edges[i].covers(e[i]);
                isNear = isNear || std::abs(double(e[i])) < least;
                w += Real(e[i]) * triangle.w[i];
            }
            if (!isNear) {
                OwnCall call(*planted.own);
                // Counter-clockwise as seen, as a front face runs.
                for (const std::size_t i : {0u, 2u, 1u}) call << glm::dvec2(c[i]) / double(kSubPixels);
                call << glm::dvec2(x, y) + 0.5;
                const std::size_t at = std::size_t(y) * std::size_t(view.size.x) + std::size_t(x);
                if (const auto covered = call.result(OwnPlace::Pixel, at)) isInside = covered->at[0] != 0;
            }
            // Outside of the triangle its plane may be behind the eye.
            if (isInside && (!view.perspective || w > 0)) visit({x, y}, e);
        }
}

template <class Real>
void spoilLightPlace(const ShadowSettings& settings, const View& face, Vec3<Real> position, Vec2<Real>& place,
                     Real& z) {
    const Own* const own = settings.planted.own;
    if (!own || own->function != OwnFunction::ToLight || face.perspective) return;
    OwnCall call(*own);
    call << position << face.pivot - face.pivotDepth * face.forward << face.right << face.up << face.forward
         << face.scale << double(face.size.x);
    if (const auto found = call.result()) place = {Real(found->at[0]), Real(found->at[1])}, z = Real(found->at[2]);
}

template <class Real>
void spoilShadowed(const ShadowSettings& settings, const ShadowTest<Real>& test, TexelTest<Real>& found) {
    const Own* const own = settings.planted.own;
    if (!own || own->function != OwnFunction::ShadowFactor || !isfinite(found.stored)) return;
    OwnCall call(*own);
    call << double(test.z) << double(found.stored) << double(found.bias);
    if (const auto factor = call.result()) found.shadowed = factor->at[0] < 0.5;
}

#define SHADESCOPE_INSTANTIATE(Real)                                                                                \
    template void ownTest(const DepthCode&, const RasterTriangle<Real>&, const std::array<std::int64_t, 3>&,        \
                          ZBufferOutput<Real>&, std::size_t, Fragment<Real>&, double&, bool&);                      \
    template void spoilCoverage(const Planted&, const View&, const RasterTriangle<Real>&, Tile,                     \
                                const std::function<void(glm::ivec2, const std::array<std::int64_t, 3>&)>&, bool&); \
    template void spoilLightPlace(const ShadowSettings&, const View&, Vec3<Real>, Vec2<Real>&, Real&);              \
    template void spoilShadowed(const ShadowSettings&, const ShadowTest<Real>&, TexelTest<Real>&);
SHADESCOPE_FOR_EVERY_REAL(SHADESCOPE_INSTANTIATE)
#undef SHADESCOPE_INSTANTIATE

}  // namespace pipeline
