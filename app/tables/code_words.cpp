#include "app/tables/code_words.h"

#include <QFontMetrics>
#include <QRegularExpression>

#include "lessons/pages/talk_words.h"

namespace app {

// The words of the lectures' language, which are set bold, and what is between them.
std::vector<std::pair<QString, bool>> wordsOf(const QString& code) {
    static const QRegularExpression language(QString::fromLatin1(lessons::kLanguageWords));
    std::vector<std::pair<QString, bool>> parts;
    qsizetype begin = 0;
    for (auto found = language.globalMatch(code); found.hasNext();) {
        const QRegularExpressionMatch word = found.next();
        if (word.capturedStart() > begin) parts.emplace_back(code.mid(begin, word.capturedStart() - begin), false);
        parts.emplace_back(word.captured(), true);
        begin = word.capturedEnd();
    }
    if (begin < code.size()) parts.emplace_back(code.mid(begin), false);
    return parts;
}

QFont bold(QFont font) {
    font.setWeight(QFont::Bold);
    return font;
}

int codeWidth(const QFont& font, const QString& code) {
    int width = 0;
    for (const auto& [part, isWord] : wordsOf(code))
        width += QFontMetrics(isWord ? bold(font) : font).horizontalAdvance(part);
    return width;
}

}  // namespace app
