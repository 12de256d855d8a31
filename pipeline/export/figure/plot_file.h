#pragma once
#include <array>
#include <string>

#include "pipeline/study/plot.h"

namespace pipeline {

// The themes of the window, by the same names and colours.
enum class PlotTheme : std::uint8_t { Light, Dark, Projector };

// sRGB. Text stands out from the background by a contrast of at least 4.5 (WCAG 2), the series'
// colours can be told apart with each kind of colour blindness.
struct PlotColors {
    Color8 background, text, secondary, grid, front, equal, failed;
    std::array<Color8, kPlotColors> series;
};
const PlotColors& plotColors(PlotTheme theme);
Color8 colorOf(const PlotColors& colors, PlotInk ink);

// The bytes of an SVG file. Texts are outlines: it looks the same wherever it is shown.
std::string plotSvg(const PlotDrawing& drawing, PlotTheme theme);
// The bytes of a PNG file, pixelsPerPoint times the drawing's size; empty where that is more than
// the format's library can hold.
std::string plotPng(const PlotDrawing& drawing, PlotTheme theme, double pixelsPerPoint = 2);

}  // namespace pipeline
