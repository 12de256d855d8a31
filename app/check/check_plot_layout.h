#pragma once
#include "app/check/knob_curve.h"
#include "pipeline/study/plot.h"

namespace app {

// What the plot of a case's knob shows.
struct KnobPlot {
    const pipeline::check::Case* which = nullptr;  // with a knob
    std::vector<KnobErrors> curve{};               // may be empty: not known yet
    std::optional<KnobErrors> now{};               // at the slider, once known
    double at = 0;                                 // where the slider stands
};

// Both errors over the slider's range with the bound, a line at the slider, and the numbers there. The axis of errors
// is logarithmic: an error of 0 has a row of its own at the bottom, NaN leaves a gap.
pipeline::PlotDrawing layOut(const KnobPlot& plot, const pipeline::PlotSize& size);

}  // namespace app
