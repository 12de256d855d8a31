#pragma once
#include <QFont>
#include <QFontMetrics>
#include <QStringList>
#include <algorithm>

namespace app {

// The font, smaller by as much as the widest of these texts needs to fit into `width` pixels, but not than `least`: 12
// is read on any screen.
inline QFont fittingFont(QFont font, const QStringList& texts, int width, int least = 12) {
    const auto fits = [&](const QString& text) { return QFontMetrics(font).horizontalAdvance(text) <= width; };
    while (font.pixelSize() > least && !std::all_of(texts.begin(), texts.end(), fits))
        font.setPixelSize(font.pixelSize() - 1);
    return font;
}

}  // namespace app
