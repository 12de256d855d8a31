#include "app/buffer_view/buffer_features.h"

#include "app/buffer_view/buffer_captions.h"
#include "app/buffer_view/buffer_channels.h"
#include "app/buffer_view/buffer_compare_choice.h"
#include "app/buffer_view/buffer_condition.h"
#include "app/buffer_view/buffer_copies.h"
#include "app/buffer_view/buffer_counts.h"
#include "app/buffer_view/buffer_flip.h"
#include "app/buffer_view/buffer_holds.h"
#include "app/buffer_view/buffer_loupe.h"
#include "app/buffer_view/buffer_overlays.h"
#include "app/buffer_view/buffer_pinch.h"
#include "app/buffer_view/buffer_pins.h"
#include "app/buffer_view/buffer_range.h"
#include "app/buffer_view/buffer_readout.h"
#include "app/buffer_view/buffer_region.h"
#include "app/buffer_view/buffer_selection.h"
#include "app/buffer_view/buffer_source.h"
#include "app/buffer_view/buffer_stale.h"
#include "app/buffer_view/buffer_step.h"
#include "app/buffer_view/buffer_zoom.h"

namespace app {

// The entries of the menu stand in the order in which the features are made, as do the labels that overlap.
BufferFeatures makeFeatures(BufferView& view) {
    BufferFeatures f{};
    f.zoom = new PictureZoom(view);
    f.compare = new CompareChoice(view);
    BufferCompare& compare = f.compare->compare();
    f.channel = new ChannelChoice(view);
    f.overlays = new OverlayChoice(view);
    f.condition = new ConditionVeil(view);
    f.source = new BufferSource(view, compare);
    f.loupe = new LoupeToggle(view);
    f.selection = new SelectionMark(view);
    f.readout = new PixelReadout(view, compare);
    f.captions = new BufferCaptions(view, compare);
    f.copies = new BufferCopies(view);
    f.pins = new PinMarks(view, *f.readout);
    f.region = new RegionMark(view);
    f.flip = new FlipToggle(view);
    f.range = new RangeChoice(view, compare, *f.channel);
    f.counts = new PictureCounts(view);
    // A comparison is of what the source gives, and a range of what the comparison shows.
    f.all = {f.zoom,   f.channel, f.overlays, f.condition, f.source,  f.loupe,    f.selection, f.readout,
             f.copies, f.pins,    f.region,   f.flip,      f.compare, f.captions, f.range,     f.counts};
    f.holds = new BufferHolds(view);
    f.all.push_back(f.holds);
    // Nobody asks for them by a name.
    f.all.push_back(new StepMark(view));
    f.all.push_back(new LateVeil(view));
    new PinchZoom(view);
    return f;
}

}  // namespace app
