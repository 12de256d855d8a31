#pragma once
#include <QImage>
#include <QStringList>
#include <optional>
#include <vector>

#include "lessons/state/shown_channel.h"
#include "pipeline/buffers/palette.h"
#include "pipeline/run/frame.h"

namespace app {

// How a buffer is shown: never what it holds.
struct BufferLook {
    lessons::ShownChannel channel = lessons::ShownChannel::All;
    pipeline::PaletteRange range;
    bool operator==(const BufferLook&) const = default;
};

// The palette of a channel: one alone of a colour is grey, of a direction diverging, of an
// intensity a scale.
pipeline::Palette shownPalette(const pipeline::BufferInfo& info, lessons::ShownChannel channel);
// Unit vectors, whose numbers lie between -1 and 1.
bool isVector(const pipeline::BufferInfo& info);
// Stands on polygons or vertices, and has no pixels of its own.
bool standsOnShapes(const pipeline::BufferInfo& info);
// Values become colours by a range that can be chosen; 8-bit colours, directions and names do not.
bool hasRange(const pipeline::BufferInfo& info, lessons::ShownChannel channel);

// Numbers of one channel, or of all of them. Bytes that are colours are not looked at.
pipeline::BufferStatistics channelStatistics(const pipeline::AnyBuffer& buffer, lessons::ShownChannel channel);
// The range that shows all of it; found: channelStatistics of the same.
pipeline::PaletteRange fittingRange(const pipeline::AnyBuffer& buffer, lessons::ShownChannel channel,
                                    const pipeline::BufferStatistics& found, pipeline::DepthFormat format);

// The polygon at each pixel of a buffer of a frame, for drawnElements; none where the frame, inside a step, has not shaded
// the pixel and the buffer is shading's. Nothing of a buffer that has no pixels.
std::optional<pipeline::AnyBuffer> polygonsUnder(const pipeline::Frame& frame, const pipeline::BufferInfo& info);

// A picture in colours has its black background; any other one is nothing where nothing was drawn.
bool isColorPicture(const pipeline::BufferInfo& info, lessons::ShownChannel channel);
// Which elements of a picture hold something. Empty: all of them.
// polygonId: polygonsUnder of the same frame.
std::vector<bool> drawnElements(const pipeline::AnyBuffer& buffer, const std::optional<pipeline::AnyBuffer>& polygonId,
                                lessons::ShownChannel channel);

// One pixel per element; transparent where nothing was drawn.
QImage bufferImage(const pipeline::AnyBuffer& buffer, const BufferLook& look, const std::vector<bool>& drawn);

// How many finite numbers fall into each of `bins` equal parts from range.first to range.last.
std::vector<int> histogram(const pipeline::AnyBuffer& buffer, const BufferLook& look, const std::vector<bool>& drawn,
                           int bins);

// A value as people read it, in the digits of its format, at most `characters` long if that is > 0
// (by leaving out decimals).
QString valueText(const pipeline::AnyBuffer& buffer, double value, int characters = 0);
// All channels of an element, or the one that is shown.
QStringList elementText(const pipeline::AnyBuffer& buffer, std::size_t x, std::size_t y, lessons::ShownChannel channel,
                        int characters = 0);

}  // namespace app
