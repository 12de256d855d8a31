#pragma once
#include <QString>

namespace app {

// How the typed words match a text, in any order: not all of them, all, or all at beginnings of words. Case does not
// matter; an empty input matches everything.
enum class WordMatch { None, Inside, Beginnings };
WordMatch matchWords(const QString& typed, const QString& text);

}  // namespace app
