#pragma once
#include <QIcon>
#include <QString>

namespace app {

// An icon of resources/icons by its file's name ("fit"), in the theme's colour for its state:
// text2 as a rule, accent where it is on, text3 where it is disabled. It follows the theme.
QIcon icon(const QString& name);
// The same in one colour of the caller's.
QPixmap iconPixmap(const QString& name, const QColor& color, int pixels, double devicePixelRatio);

}  // namespace app
