#pragma once
#include <memory>

#include "pipeline/steps/drawing.h"

namespace pipeline {

// What each stage has left after the first so many of its steps, by the functions that the stage itself consists of.
// data: the outputs of the whole frame, of which only those of the stages before are read, and of the stage itself
// what no later step changes.

template <class Real>
TransformOutput<Real> transformSoFar(const FrameData<Real>& data, std::size_t vertices);

// The polygons that it has not come to have the verdict NotYet.
template <class Real>
CullOutput cullSoFar(const FrameData<Real>& data, std::size_t polygons, Threads& threads);

template <class Real>
NormalsOutput<Real> normalsSoFar(const FrameData<Real>& data, std::size_t polygons, std::size_t vertices,
                                 Threads& threads);

// The lights before `light` are drawn, those after it cleared; of its polygons, in scene order and without those of
// transparent objects, the first so many are drawn, into all its faces and samples alike.
template <class Real>
ShadowBufferOutput<Real> shadowBuffersSoFar(const FrameData<Real>& data, std::size_t light, std::size_t polygons,
                                            Threads& threads);

// How far stage 6 has come.
struct ShadingProgress {
    std::size_t polygonTerms = 0, vertexTerms = 0;  // evaluated: all polygons and vertices with lower numbers
    // Pixels: those that show a polygon with a lower number than this, and of its own those within `reach`.
    std::uint32_t polygon = 0;
    Reach reach{};
    bool layers = false, samples = false;  // laid over; averaged
};
// The picture without translucent layers and with one sample a pixel, once all its pixels are shaded: that of the
// frame itself where it has neither.
template <class Real>
std::shared_ptr<const ShadingOutput<Real>> shadedOpaque(const FrameData<Real>& data, BufferSet made, Threads& threads);
template <class Real>
ShadingOutput<Real> shadedSoFar(const FrameData<Real>& data, const ShadingOutput<Real>& opaque, BufferSet made,
                                const ShadingProgress& progress, Threads& threads);

}  // namespace pipeline
