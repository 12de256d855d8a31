#include "pipeline/stages/room.h"

#include <limits>

#include "pipeline/stages/depth.h"

namespace pipeline {

template <class Real>
ZBufferOutput<Real> roomForZBuffer(Tile extent, DepthFormat format, const Planted& planted) {
    const glm::ivec2 size = extent.max - extent.min;
    ZBufferOutput<Real> out;
    out.origin = extent.min;
    out.planted = planted;
    out.zView = Buffer2D<Real>(size);
    if (format != DepthFormat::Linear) out.depth = Buffer2D<double>(size);
    out.triangle = Buffer2D<std::uint32_t>(size);
    out.barycentric = Buffer2D<Vec3<Real>>(size);
    out.overdraw = Buffer2D<std::int32_t>(size);
    out.depthWrites = Buffer2D<std::int32_t>(size);
    return out;
}

template <class Real>
void clearZBuffer(DepthFormat format, std::size_t begin, std::size_t end, ZBufferOutput<Real>& out) {
    clearPixels(*out.zView, begin, end, std::numeric_limits<Real>::infinity());
    clearPixels(out.depth, begin, end, DepthCode::cleared(format));
    clearPixels(*out.triangle, begin, end, kNoTriangle);
    clearPixels(out.barycentric, begin, end, Real(0));
    clearPixels(out.overdraw, begin, end, 0);
    clearPixels(out.depthWrites, begin, end, 0);
}

template <class Real>
ZBufferOutput<Real> prepareZBuffer(Tile extent, DepthFormat format, const Planted& planted) {
    ZBufferOutput<Real> out = roomForZBuffer<Real>(extent, format, planted);
    clearZBuffer(format, 0, out.overdraw.pixels.size(), out);
    if (planted) spoilCleared(out);
    return out;
}

template <class Real>
ShadingOutput<Real> roomForShading(const ShadingInputs& inputs, const ShadingSources<Real>& in, BufferSet wanted) {
    ShadingOutput<Real> out;
    out.iMax = maximumIntensity(inputs.illumination.model, inputs.materials, inputs.lights, inputs.ambient,
                                in.transform.transparent);
    if (inputs.planted) spoilMaximum(inputs, in.transform.transparent, out.iMax);
    const glm::ivec2 size = in.transform.view.size;
    if (inputs.outlines) wanted.reset();  // nothing else is known of a line
    if (!inputs.parts[Part::ShadedInVectors]) wanted.set(index(BufferId::Intensity));
    if (inputs.samples > 1) wanted.set(index(BufferId::Antialiased));
    for (const BufferInfo& info : bufferTable()) {
        if (info.stage != StageId::Shading || info.domain != Domain::Pixel || info.element != Element::Real ||
            !wanted[index(info.id)])
            continue;
        const std::size_t lights = info.perLight ? inputs.lights.size() : 1;
        for (std::size_t k = 0; k < lights; ++k) {
            if (info.channels == 3)
                out.vectors[index(info.id)].emplace_back(size);
            else
                out.scalars[index(info.id)].emplace_back(size);
        }
    }
    out.color = Buffer2D<Color8>(size);
    if (wanted[index(BufferId::Layers)]) out.layers = Buffer2D<std::int32_t>(size);
    return out;
}

template <class Real>
void clearShading(const ShadingInputs& inputs, std::size_t begin, std::size_t end, ShadingOutput<Real>& out) {
    const bool isWritten = inputs.parts[Part::ShadedInVectors];  // colour and intensity, by the vectors
    for (const BufferInfo& info : bufferTable()) {
        if (info.id != BufferId::Intensity || !isWritten)
            for (auto& vectors : out.vectors[index(info.id)]) clearPixels(vectors, begin, end, Real(info.neutral));
        for (auto& scalars : out.scalars[index(info.id)]) clearPixels(scalars, begin, end, Real(info.neutral));
    }
    if (!isWritten) clearPixels(out.color, begin, end, Color8(0));
    clearPixels(out.layers, begin, end, 0);
}

template <class Real>
ShadingOutput<Real> prepareShading(const ShadingInputs& inputs, const ShadingSources<Real>& in, BufferSet wanted) {
    ShadingOutput<Real> out = roomForShading(inputs, in, wanted);
    clearShading(inputs, 0, out.color.pixels.size(), out);
    return out;
}

#define SHADESCOPE_INSTANTIATE(Real)                                                                           \
    template ZBufferOutput<Real> prepareZBuffer(Tile, DepthFormat, const Planted&);                            \
    template ZBufferOutput<Real> roomForZBuffer(Tile, DepthFormat, const Planted&);                            \
    template void clearZBuffer(DepthFormat, std::size_t, std::size_t, ZBufferOutput<Real>&);                   \
    template ShadingOutput<Real> prepareShading(const ShadingInputs&, const ShadingSources<Real>&, BufferSet); \
    template ShadingOutput<Real> roomForShading(const ShadingInputs&, const ShadingSources<Real>&, BufferSet); \
    template void clearShading(const ShadingInputs&, std::size_t, std::size_t, ShadingOutput<Real>&);
SHADESCOPE_FOR_EVERY_REAL(SHADESCOPE_INSTANTIATE)
#undef SHADESCOPE_INSTANTIATE

}  // namespace pipeline
