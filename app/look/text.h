#pragma once
#include <string_view>

#include <QString>

namespace app {

// The pipeline speaks UTF-8.
inline QString toQString(std::string_view text) { return QString::fromUtf8(text.data(), qsizetype(text.size())); }

}  // namespace app
