#pragma once
#include <QColor>

#include "pipeline/study/plot.h"

class QPainter;

namespace app {

// Marks of a plot in the theme's colours.
QColor plotColor(pipeline::PlotInk ink);
void draw(QPainter& painter, const pipeline::PlotLine& line);
void draw(QPainter& painter, const pipeline::PlotMarker& marker);
void draw(QPainter& painter, const pipeline::PlotText& text);

}  // namespace app
