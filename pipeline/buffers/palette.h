#pragma once
#include <span>

#include "pipeline/buffers/any_buffer.h"
#include "pipeline/core/real.h"
#include "pipeline/scene/settings.h"

namespace pipeline {

// The colours of a palette, sRGB: stops of a scale (Sequential, Diverging), one a category
// (Categorical; Verdict in the order kept, back-facing, degenerate, outside, clipped,
// wholly transparent; ShadowVerdict lit, shadowed, acne, leak; Truth false, true). Empty where the values themselves
// are colours.
std::span<const Color8> paletteStops(Palette palette);

// The values that stand at the two ends of a palette. first > last turns a scale around.
struct PaletteRange {
    double first = 0, last = 1;
    bool operator==(const PaletteRange&) const = default;
};

// The range that shows all of a buffer. Scales begin light: distances with what is near, counts
// and shadow factors with what is more; dot products have 0 in the middle; unit vectors go
// from −1 to 1; colours from 0. `format` is the frame's: in a reversed depth larger is nearer.
PaletteRange fittingRange(const AnyBuffer& buffer, const BufferStatistics& found, DepthFormat format);

// The colour of one number. Values outside the range take the colour of its end. NaN is magenta,
// +infinity white, −infinity black; in Categorical so is a negative value (nothing drawn) white.
// In Color and Direction a grey.
Color8 paletteColor(Palette palette, double value, double first, double last);

// The colour of an element: of its three channels where they are a colour or a direction.
// Column x and row y as in AnyBuffer::value.
Color8 elementColor(const AnyBuffer& buffer, std::size_t x, std::size_t y, PaletteRange range);

}  // namespace pipeline
