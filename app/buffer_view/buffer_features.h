#pragma once
#include <vector>

#include "app/buffer_view/buffer_feature.h"

namespace app {

class BufferCaptions;
class BufferCopies;
class BufferHolds;
class BufferSource;
class ChannelChoice;
class CompareChoice;
class ConditionVeil;
class FlipToggle;
class LoupeToggle;
class OverlayChoice;
class PinMarks;
class PictureZoom;
class PixelReadout;
class PictureCounts;
class RangeChoice;
class RegionMark;
class SelectionMark;

// The features of a buffer view: each by its name, and all in the order in which the view calls them.
struct BufferFeatures {
    PictureZoom* zoom;
    CompareChoice* compare;
    ChannelChoice* channel;
    OverlayChoice* overlays;
    ConditionVeil* condition;
    BufferSource* source;
    LoupeToggle* loupe;
    SelectionMark* selection;
    PixelReadout* readout;
    BufferCaptions* captions;
    BufferCopies* copies;
    PinMarks* pins;
    RegionMark* region;
    FlipToggle* flip;
    RangeChoice* range;
    PictureCounts* counts;
    BufferHolds* holds;
    std::vector<BufferFeature*> all;
};
BufferFeatures makeFeatures(BufferView& view);

}  // namespace app
