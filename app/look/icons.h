#pragma once
#include <QIcon>
#include <QString>

namespace app {

// An icon of resources/icons by its file's name ("fit"), in the theme's colour for its state: text2, accent when
// checked, text3 when disabled. It follows the theme.
QIcon icon(const QString& name);
// The same icon in a given colour.
QPixmap iconPixmap(const QString& name, const QColor& color, int pixels, double devicePixelRatio);

}  // namespace app
