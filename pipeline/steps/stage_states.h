#pragma once
#include <memory>

#include "pipeline/steps/drawing.h"

namespace pipeline {

// The output of each stage after a number of its steps, computed with the stage's own functions. data: the outputs of
// the whole frame. Only those of earlier stages are read, and the parts of this stage's output that no later step
// changes.

template <class Real>
TransformOutput<Real> transformSoFar(const FrameData<Real>& data, std::size_t vertices);

// Polygons still to come have the verdict NotYet.
template <class Real>
CullOutput cullSoFar(const FrameData<Real>& data, std::size_t polygons, Threads& threads);

template <class Real>
NormalsOutput<Real> normalsSoFar(const FrameData<Real>& data, std::size_t polygons, std::size_t vertices,
                                 Threads& threads);

// The buffers of lights before `light` are drawn, those of later lights are cleared. Of its polygons, in scene order
// and without transparent objects, the first `polygons` are drawn, into all its faces and samples.
template <class Real>
ShadowBufferOutput<Real> shadowBuffersSoFar(const FrameData<Real>& data, std::size_t light, std::size_t polygons,
                                            Threads& threads);

// The progress of stage 6.
struct ShadingProgress {
    std::size_t polygonTerms = 0, vertexTerms = 0;  // evaluated for all polygons and vertices with lower numbers
    // Pixels: those that show a polygon with a lower number, and the pixels of this polygon within `reach`.
    std::uint32_t polygon = 0;
    Reach reach{};
    bool layers = false, samples = false;  // blended; averaged
};
// The finished picture without translucent layers and with one sample for each pixel. It is the frame's own picture if
// it has neither layers nor samples.
template <class Real>
std::shared_ptr<const ShadingOutput<Real>> shadedOpaque(const FrameData<Real>& data, BufferSet made, Threads& threads);
template <class Real>
ShadingOutput<Real> shadedSoFar(const FrameData<Real>& data, const ShadingOutput<Real>& opaque, BufferSet made,
                                const ShadingProgress& progress, Threads& threads);

}  // namespace pipeline
