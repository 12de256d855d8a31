#pragma once
#include <QFont>
#include <QPainterPath>

#include "app/drawing3d/drawing.h"

namespace app {

QFont fontOf(Label::Kind kind);

// A label's text set as the equation sets it: single letters italic, those of vectors bold too, words and numbers upright,
// digits behind ^ raised, and subscripts lowered. Captions are words throughout. The baseline begins at the origin.
QPainterPath pathOf(const Label& label);
// What the text takes, logical pixels.
QSizeF sizeOf(const Label& label);

}  // namespace app
