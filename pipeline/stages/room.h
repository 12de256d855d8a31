#pragma once
#include <algorithm>
#include <cstddef>

#include "pipeline/stages/shading.h"

// The pixels of the last two stages: room for them, which costs nothing, and what pixels [begin, end) hold before anything
// is drawn. Clearing a large picture takes seconds, so the runner looks at a stop between pieces of it.
namespace pipeline {

template <class Real>
ZBufferOutput<Real> roomForZBuffer(Tile extent, DepthFormat format, const Planted& planted);
template <class Real>
void clearZBuffer(DepthFormat format, std::size_t begin, std::size_t end, ZBufferOutput<Real>& out);

template <class Real>
ShadingOutput<Real> roomForShading(const ShadingInputs& inputs, const ShadingSources<Real>& in, BufferSet wanted);
template <class Real>
void clearShading(const ShadingInputs& inputs, std::size_t begin, std::size_t end, ShadingOutput<Real>& out);

// Gives pixels [begin, end) of a buffer one value, where there is one.
template <class T, class Value>
void clearPixels(Buffer2D<T>& buffer, std::size_t begin, std::size_t end, const Value& value) {
    if (!buffer.empty()) std::fill_n(buffer.pixels.begin() + std::ptrdiff_t(begin), end - begin, T(value));
}

}  // namespace pipeline
