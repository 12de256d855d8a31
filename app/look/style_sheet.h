#pragma once
#include <QString>
#include <functional>

#include "app/look/theme.h"

namespace app {

// The application's style sheet: the template of style_sheet.cpp with the theme's colours and
// scaled lengths in it. It sets no font, so that QWidget::setFont keeps its meaning.
// What a widget is, it says by a property:
//   QFrame  kind = "panel" | "overlay"          a surface with a hairline and round corners
//   QWidget  kind = "page"                      what scrolls in a panel
//   QPushButton  kind = "primary" | "link"      the one thing to do here | a link in a line of text
//   QToolButton, QPushButton  kind = "segment"  one of several, joined
//   QLabel  tone = "2" | "3"                    a label or second line | a hint or a previous value
QString styleSheet(const ThemeColors& colors, const std::function<int(double)>& px);

}  // namespace app
