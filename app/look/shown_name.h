#pragma once
#include <string_view>

#include <QFileInfo>

#include "app/look/text.h"
#include "pipeline/core/printable.h"

namespace app {

// A text from a file on one line: line ends and other control characters are escaped.
inline QString onOneLine(std::string_view text) { return toQString(pipeline::escaped(text)); }

// A file's name without its folder, as the window shows it.
inline QString shownName(const QString& file) { return onOneLine(QFileInfo(file).fileName().toStdString()); }

}  // namespace app
