#include "app/look/word_match.h"

#include <QStringList>
#include <algorithm>

namespace app {
namespace {

WordMatch matchWord(const QString& word, const QString& text) {
    WordMatch best = WordMatch::None;
    for (qsizetype at = text.indexOf(word, 0, Qt::CaseInsensitive); at >= 0;
         at = text.indexOf(word, at + 1, Qt::CaseInsensitive)) {
        if (at == 0 || !text[at - 1].isLetterOrNumber()) return WordMatch::Beginnings;
        best = WordMatch::Inside;
    }
    return best;
}

}  // namespace

WordMatch matchWords(const QString& typed, const QString& text) {
    WordMatch all = WordMatch::Beginnings;
    for (const QString& word : typed.split(' ', Qt::SkipEmptyParts)) all = std::min(all, matchWord(word, text));
    return all;
}

}  // namespace app
