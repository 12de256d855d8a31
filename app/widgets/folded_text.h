#pragma once
#include <QStringList>

namespace app {

// A text in lines, parted at its spaces: at least one, and one word to a line where no more fits.
template <class First, class Others>
QStringList foldedAtSpaces(const QString& text, First fitsFirst, Others fitsOthers) {
    QStringList lines{{}};
    for (const QString& word : text.split(QLatin1Char(' '))) {
        const QString longer = lines.back().isEmpty() ? word : lines.back() + QLatin1Char(' ') + word;
        const bool fits = lines.size() == 1 ? fitsFirst(longer) : fitsOthers(longer);
        if (fits || lines.back().isEmpty())
            lines.back() = longer;
        else
            lines << word;
    }
    return lines;
}

}  // namespace app
