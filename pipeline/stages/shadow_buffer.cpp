#include "pipeline/stages/shadow_buffer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pipeline/core/numerics.h"

namespace pipeline {

// Chosen by the axis least aligned with it.
void placeAxes(View& view) {
    const Vec3d f = glm::abs(view.forward);
    const Vec3d axis = f.z <= f.x && f.z <= f.y ? Vec3d(0, 0, 1) : f.y <= f.x ? Vec3d(0, 1, 0) : Vec3d(1, 0, 0);
    view.right = normalized(glm::cross(view.forward, axis));
    view.up = glm::cross(view.right, view.forward);
}

template <class Real>
Bounds boundsIn(const View& view, std::span<const Vec3<Real>> points) {
    Bounds bounds;
    for (const Vec3<Real>& point : points) bounds.add(toView(view, Vec3d(point)));
    return bounds;
}

template <class Real>
Real largestIn(std::span<const Vec3<Real>> points) {
    Real largest = 0;
    for (const Vec3<Real>& point : points) largest = std::max(largest, largestComponent(point));
    return largest;
}

namespace {

// Orthographic, around everything there is, a texel wider on each side. z' counts from the plane
// through the vertex nearest to the light.
template <class Real>
View fitAtInfinity(Vec3d towardsLight, int size, const TransformOutput<Real>& in, const ShadowPreparation<Real>& by) {
    View view;
    view.perspective = false;
    view.size = {size, size};
    view.centre = glm::dvec2(view.size) / 2.0;
    view.forward = -normalized(towardsLight);
    placeAxes(view);
    Bounds bounds = by.bounds(view, in.world);
    if (!(bounds.low.x <= bounds.high.x)) bounds.low = bounds.high = Vec3d(0);

    const Vec3d middle = (bounds.low + bounds.high) / 2.0, extent = bounds.high - bounds.low;
    view.placeEye(middle.x * view.right + middle.y * view.up + bounds.low.z * view.forward);
    const double side = std::max({extent.x, extent.y, extent.z});
    const auto texels = [&](double across) {
        const double inside = std::max(1, size - 2);
        return across > 0 ? inside / across : side > 0 ? inside / side : 1.0;
    };
    view.scale = {texels(extent.x), texels(extent.y)};
    // Everything lies between; the margin keeps rounding from cutting the outermost.
    view.near = -side;
    view.far = 2 * side;
    return view;
}

// Around all vertices, world space.
template <class Real>
Bounds boundsInWorld(const TransformOutput<Real>& in) {
    Bounds bounds;
    for (const Vec3<Real>& world : in.world) bounds.add(Vec3d(world));
    return bounds;
}

// Rounding keeps the order of numbers, so that the corners of the bounds have the farthest vertex' very distance.
std::vector<View> sixFaces(Vec3d position, int size, const Bounds& world) {
    double farthest = 0;
    if (world.low.x <= world.high.x)
        farthest = std::max(largestComponent(world.low - position), largestComponent(world.high - position));
    if (farthest == 0) farthest = 1;
    std::vector<View> faces;
    for (const Vec3d axis : {Vec3d(1, 0, 0), Vec3d(0, 1, 0), Vec3d(0, 0, 1)}) {
        for (const double sign : {1.0, -1.0}) {
            View view;
            view.placeEye(position);
            view.size = {size, size};
            view.centre = view.scale = glm::dvec2(view.size) / 2.0;  // 90 degrees
            view.forward = sign * axis;
            placeAxes(view);
            view.near = farthest / (1 << 20);
            view.far = farthest * 2;
            faces.push_back(view);
        }
    }
    return faces;
}

}  // namespace

template <class Real>
std::size_t faceOf(const LightView<Real>& light, Vec3<Real> world) {
    if (light.faces.size() == 1) return 0;
    const Vec3<Real> p = world - Vec3<Real>(light.faces[0].eye), a = glm::abs(p);
    const std::size_t axis = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
    return 2 * axis + (p[int(axis)] < 0 ? 1 : 0);
}

template <class Real>
ShadowBufferOutput<Real> prepareShadowBuffer(const ShadowBufferInputs& inputs, const TransformOutput<Real>& in,
                                             const ShadowPreparation<Real>& by) {
    ShadowBufferOutput<Real> out;
    out.lights.resize(inputs.casters.size());
    const Real farthest = by.largest(in.world);
    const auto isPoint = [](const auto& caster) { return caster.kind != LightKind::AtInfinity; };
    const Bounds world = std::ranges::any_of(inputs.casters, isPoint) ? boundsInWorld(in) : Bounds();
    for (std::size_t k = 0; k < inputs.casters.size(); ++k) {
        for (const Vec3d place : inputs.casters[k].places) {
            LightView<Real>& light = out.lights[k].emplace_back();
            light.faces = inputs.casters[k].kind == LightKind::AtInfinity
                              ? std::vector<View>{fitAtInfinity(place, inputs.size, in, by)}
                              : sixFaces(place, inputs.size, world);
            light.depth.resize(light.faces.size()), light.blocks.resize(light.faces.size());
            for (std::size_t i = 0; i < light.faces.size() && by.makesRoom; ++i)
                light.depth[i] = Buffer2D<Real>(light.faces[i].size, std::numeric_limits<Real>::infinity());
            // A difference, three products and two sums, on either side of the comparison.
            const Real largest = std::max(farthest, Real(largestComponent(light.faces[0].eye)));
            light.rounding = 16 * std::numeric_limits<Real>::epsilon() * largest;
        }
    }
    return out;
}

template <class Real>
FacingFilter facingFilter(ShadowCull cull, const TransformOutput<Real>& in) {
    return {cull, in.anyMirrored() ? std::span<const std::uint8_t>(in.mirrored) : std::span<const std::uint8_t>()};
}

template <class Real>
TriangleBins<Real> binForLight(const TransformOutput<Real>& in, const View& face, ShadowCull cull,
                               std::span<const std::uint8_t> drawn, TriangleRange range) {
    return binTriangles<Real>(*in.topology, face, in.world, {}, {}, drawn, facingFilter(cull, in), range);
}

template <class Real>
void shadowBuffer(const View& face, const TriangleBins<Real>& bins, std::size_t tile, Buffer2D<Real>& depth) {
    for (const std::uint32_t i : bins.bins[tile]) {
        const RasterTriangle<Real>& triangle = bins.triangles[i];
        forEachCovered(triangle.snapped, bins.tile(tile), [&](glm::ivec2 texel, const std::array<std::int64_t, 3>& e) {
            const Real z = interpolate(triangle, texel, e, face.perspective).z;
            Real& stored = depth.at(texel);
            if (z < stored) stored = z;
        });
    }
}

#define SHADESCOPE_INSTANTIATE(Real)                                                                               \
    template std::size_t faceOf(const LightView<Real>&, Vec3<Real>);                                               \
    template Bounds boundsIn(const View&, std::span<const Vec3<Real>>);                                            \
    template Real largestIn(std::span<const Vec3<Real>>);                                                          \
    template ShadowBufferOutput<Real> prepareShadowBuffer(const ShadowBufferInputs&, const TransformOutput<Real>&, \
                                                          const ShadowPreparation<Real>&);                         \
    template FacingFilter facingFilter(ShadowCull, const TransformOutput<Real>&);                                  \
    template TriangleBins<Real> binForLight(const TransformOutput<Real>&, const View&, ShadowCull,                 \
                                            std::span<const std::uint8_t>, TriangleRange);                         \
    template void shadowBuffer(const View&, const TriangleBins<Real>&, std::size_t, Buffer2D<Real>&);
SHADESCOPE_FOR_EVERY_REAL(SHADESCOPE_INSTANTIATE)
#undef SHADESCOPE_INSTANTIATE

}  // namespace pipeline
