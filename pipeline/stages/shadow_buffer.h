#pragma once
#include <limits>
#include <span>
#include <vector>

#include "pipeline/buffers/block_buffer.h"
#include "pipeline/buffers/late_buffer.h"
#include "pipeline/stages/bin.h"
#include "pipeline/stages/transform.h"

namespace pipeline {

// Stage 4: for each casting light, the distance Z' from the light to the closest surface.
// L. Williams, "Casting curved shadows on curved surfaces", SIGGRAPH 1978.

struct ShadowBufferInputs {
    // Per light: where it stands, for an area light each of its samples; nothing where it gets no
    // shadow buffer. The intensity of a light does not matter here, so changing it keeps the buffer.
    struct Caster {
        LightKind kind = LightKind::AtInfinity;
        std::vector<Vec3d> places{};
        bool operator==(const Caster&) const = default;
    };
    std::vector<Caster> casters;
    int size;  // texels along a side
    ShadowCull cull = ShadowCull::None;
    bool operator==(const ShadowBufferInputs&) const = default;
};

template <class Real>
using ShadowBufferOutput = LightDepths<Real>;

// Gives a view whose `forward` is set its axes right and up across it, the sides of the texels: left-handed with
// `forward`, as every view space.
void placeAxes(View& view);

// The smallest box along the axes of a view around what was added.
struct Bounds {
    Vec3d low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};
    void add(Vec3d p) { low = glm::min(low, p), high = glm::max(high, p); }
};
// Of points in world space as a view sees them, toView in double; and the largest of their components, without its sign.
template <class Real>
Bounds boundsIn(const View& view, std::span<const Vec3<Real>> points);
template <class Real>
Real largestIn(std::span<const Vec3<Real>> points);

// The two of them, and whether there is to be room for Z': pipeline/simd finds them with the same bits, and makes its own.
template <class Real>
struct ShadowPreparation {
    Bounds (*bounds)(const View& view, std::span<const Vec3<Real>> points) = boundsIn<Real>;
    Real (*largest)(std::span<const Vec3<Real>> points) = largestIn<Real>;
    bool makesRoom = true;
};
template <class Real>
ShadowBufferOutput<Real> prepareShadowBuffer(const ShadowBufferInputs& inputs, const TransformOutput<Real>& in,
                                             const ShadowPreparation<Real>& by = {});

// What is left out of a shadow buffer of these objects.
template <class Real>
FacingFilter facingFilter(ShadowCull cull, const TransformOutput<Real>& in);

// The scene's triangles as one face of a light sees them; drawn: as in binTriangles.
template <class Real>
TriangleBins<Real> binForLight(const TransformOutput<Real>& in, const View& face, ShadowCull cull = ShadowCull::None,
                               std::span<const std::uint8_t> drawn = {}, TriangleRange range = {});

// Draws the triangles of tile `tile` of `bins` into the depth of that face.
template <class Real>
void shadowBuffer(const View& face, const TriangleBins<Real>& bins, std::size_t tile, Buffer2D<Real>& depth);

// Which of the six faces a point seen from a point light falls on; 0 for a light at infinity.
template <class Real>
std::size_t faceOf(const LightView<Real>& light, Vec3<Real> world);

}  // namespace pipeline
