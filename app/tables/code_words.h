#pragma once
#include <QFont>
#include <QString>
#include <utility>
#include <vector>

namespace app {

// A line of the lectures' code: its parts, and whether each is a word of the language, which is set bold.
std::vector<std::pair<QString, bool>> wordsOf(const QString& code);
QFont bold(QFont font);
int codeWidth(const QFont& font, const QString& code);  // pixels

}  // namespace app
