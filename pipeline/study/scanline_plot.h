#pragma once
#include "pipeline/inspect/scanline.h"
#include "pipeline/study/plot.h"

namespace pipeline {

// What a section along a row looks like: the depth of every polygon, the nearest on top, bold where it is what the pixel
// shows and dashed where it is hidden; the intensity with each shading method on one axis. The one above the other, or
// in a low and wide plot the one beside the other.
struct ScanlinePlot {
    const ScanlineSection* section = nullptr;
    int channel = 2;               // 0 r, 1 g, 2 b: of the intensity
    std::optional<int> picked{};   // x of the picked pixel, where it is in this row
    std::optional<int> hovered{};  // x under the cursor, with the numbers there
};

// Where a column of pixels stands: x counts pixels, a pixel's centre is at x + 0.5.
struct ScanlineAxis {
    double left = 0, right = 0;  // points
    double first = 0, last = 1;  // pixels
    double place(double x) const { return left + (right - left) * (x - first) / (last - first); }
    double centre(int pixel) const { return place(pixel + 0.5); }
    int pixelAt(double place) const;  // within first and last
};
// The same pixels in both plots, which share their axis where the one stands above the other.
struct ScanlineAxes {
    ScanlineAxis depth, intensity;
    bool isBeside = false;
    const ScanlineAxis& at(double place) const { return isBeside && place >= intensity.left ? intensity : depth; }
};
ScanlineAxes axesOf(const ScanlineSection& section, const PlotSize& size);

PlotDrawing layOut(const ScanlinePlot& plot, const PlotSize& size);

}  // namespace pipeline
