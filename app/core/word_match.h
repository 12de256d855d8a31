#pragma once
#include <QString>

namespace app {

// How the words typed stand in a text, in any order: not all of them, all, or all at beginnings of words. Case does not
// matter; nothing typed is found everywhere.
enum class WordMatch { None, Inside, Beginnings };
WordMatch matchWords(const QString& typed, const QString& text);

}  // namespace app
