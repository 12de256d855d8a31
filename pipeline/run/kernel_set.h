#pragma once
#include <span>
#include <type_traits>

#include "pipeline/run/parallel.h"
#include "pipeline/simd/cull.h"
#include "pipeline/simd/normals.h"
#include "pipeline/simd/relight.h"
#include "pipeline/simd/shade_pixels.h"
#include "pipeline/simd/transform.h"
#include "pipeline/stages/shading.h"

// The pieces of a stage as the runner calls them. Overloads choose the SIMD kernel of pipeline/simd in float, and the
// scalar stage in every other precision. Both give the same bits.
namespace pipeline::piece {

template <class Real>
void transform(const TransformInputs& inputs, std::size_t object, std::size_t begin, std::size_t end,
               TransformOutput<Real>& out) {
    pipeline::transform(inputs, object, begin, end, out);
}
inline void transform(const TransformInputs& inputs, std::size_t object, std::size_t begin, std::size_t end,
                      TransformOutput<float>& out) {
    transformInVectors(inputs, object, begin, end, out);
}

// Room for the snapped vertices, which only kernels read.
template <class Real>
void makeRoomForSnapped(TransformOutput<Real>&) {}
inline void makeRoomForSnapped(TransformOutput<float>& out) {
    out.snapped.bits = out.view.subPixelBits;
    out.snapped.of.resize(out.world.size());
}
// Snaps vertices again after the view has moved.
template <class Real>
void snap(std::size_t, std::size_t, TransformOutput<Real>&) {}
inline void snap(std::size_t begin, std::size_t end, TransformOutput<float>& out) {
    snapInVectors(out.view, out.world, begin, end, out.snapped);
}

template <class Real>
void cull(const CullInputs& inputs, const TransformOutput<Real>& in, std::size_t begin, std::size_t end,
          CullOutput& out) {
    pipeline::cull(inputs, in, begin, end, out);
}
inline void cull(const CullInputs& inputs, const TransformOutput<float>& in, std::size_t begin, std::size_t end,
                 CullOutput& out) {
    cullInVectors(inputs, in, begin, end, out);
}

template <class Real>
void polygonNormals(const NormalsInputs& inputs, const TransformOutput<Real>& in, std::size_t begin, std::size_t end,
                    NormalsOutput<Real>& out) {
    pipeline::polygonNormals(inputs, in, begin, end, out);
}
inline void polygonNormals(const NormalsInputs& inputs, const TransformOutput<float>& in, std::size_t begin,
                           std::size_t end, NormalsOutput<float>& out) {
    polygonNormalsInVectors(inputs, in, begin, end, out);
}
template <class Real>
void unitVertexNormals(const NormalsInputs& inputs, const TransformOutput<Real>& in, std::size_t object,
                       std::size_t begin, std::size_t end, NormalsOutput<Real>& out) {
    pipeline::unitVertexNormals(inputs, in, object, begin, end, out);
}
inline void unitVertexNormals(const NormalsInputs& inputs, const TransformOutput<float>& in, std::size_t object,
                              std::size_t begin, std::size_t end, NormalsOutput<float>& out) {
    unitVertexNormalsInVectors(inputs, in, object, begin, end, out);
}

// Without memory for the faces: drawShadows allocates each face, because there may be thousands, and a stop in between.
template <class Real>
ShadowBufferOutput<Real> prepareShadowBuffer(const ShadowBufferInputs& inputs, const TransformOutput<Real>& in) {
    return pipeline::prepareShadowBuffer(inputs, in, {boundsIn<Real>, largestIn<Real>, false});
}
inline ShadowBufferOutput<float> prepareShadowBuffer(const ShadowBufferInputs& inputs,
                                                     const TransformOutput<float>& in) {
    return pipeline::prepareShadowBuffer(inputs, in, {boundsInVectors, largestInVectors, false});
}

template <class Real>
ShadingCounts shadePixels(const ShadingInputs& inputs, const ShadingSources<Real>& in, Tile tile,
                          ShadingOutput<Real>& out) {
    return pipeline::shadePixels(inputs, in, tile, out);
}
inline ShadingCounts shadePixels(const ShadingInputs& inputs, const ShadingSources<float>& in, Tile tile,
                                 ShadingOutput<float>& out) {
    return inputs.parts[Part::ShadedInVectors] ? shadePixelsInVectors(inputs, in, tile, out)
                                               : pipeline::shadePixels(inputs, in, tile, out);
}
template <class Real>
ShadeLayers<Real> layerShader(const ShadingInputs& inputs) {
    if constexpr (std::is_same_v<Real, float>)
        if (inputs.parts[Part::ShadedInVectors]) return &shadeLayersInVectors;
    return &pipeline::shadeLayers<Real>;
}
// A tile in which nothing was drawn. The scalar stage has cleared it before.
template <class Real>
void leaveDark(const ShadingInputs&, Tile, ShadingOutput<Real>&) {}
inline void leaveDark(const ShadingInputs& inputs, Tile tile, ShadingOutput<float>& out) {
    if (inputs.parts[Part::ShadedInVectors]) leaveTileDark(tile, out);
}
// Whether the light that the last frame kept for tile i suffices to shade it.
template <class Real>
bool relight(const ShadingInputs&, std::span<const Look>, std::size_t, Tile, ShadingOutput<Real>&, ShadingCounts&) {
    return false;
}
inline bool relight(const ShadingInputs& inputs, std::span<const Look> looks, std::size_t i, Tile pixels,
                    ShadingOutput<float>& out, ShadingCounts& counts) {
    return !out.incidence.empty() && out.incidence[i] &&
           relightInVectors(inputs, looks, *out.incidence[i], pixels, out, counts);
}

}  // namespace pipeline::piece
