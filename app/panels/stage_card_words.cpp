// What of a card's words it has room for.
#include <QRegularExpression>
#include <algorithm>
#include <utility>

#include "app/core/numbers.h"
#include "app/panels/stage_card.h"

namespace app {
namespace {

// Three digits of a number from 10 000 on: "498k", "1.00M". The rounded value decides: 999 700 is 1.00M, not 1000k.
QString shortNumber(double value) {
    const auto [unit, letter] = value < 999.5e3 ? std::pair(1e3, 'k') : std::pair(1e6, 'M');
    const double shown = value / unit;
    return number(shown, shown < 9.995 ? 2 : shown < 99.95 ? 1 : 0) + QLatin1Char(letter);
}

}  // namespace

QString withShortNumbers(QString text) {
    static const QRegularExpression grouped(QStringLiteral("\\d{1,3}(?:\\x{2009}\\d{3})+"));
    for (qsizetype from = 0;;) {
        const QRegularExpressionMatch match = grouped.match(text, from);
        if (!match.hasMatch()) return text;
        const double value = match.captured().remove(QChar(0x2009)).toDouble();
        const QString shown = value >= 10000 ? shortNumber(value) : match.captured();
        text.replace(match.capturedStart(), match.capturedLength(), shown);
        from = match.capturedStart() + shown.size();
    }
}

QString fittingError(QString error, const std::function<bool(const QString&)>& fits) {
    for (const QChar end : {QChar(','), QChar(' ')})
        if (!fits(error)) error = error.section(end, 0, 0);
    return error;
}

QString fittingCounts(const QString& counts, const std::function<bool(const QString&)>& fits) {
    if (const QString exact = fitting(counts, fits); !exact.isEmpty()) return exact;
    const QString brief = withShortNumbers(counts);
    const QString part = fitting(brief, fits);
    return part.isEmpty() ? fitting(QString(brief).remove(QStringLiteral(" polygons")), fits) : part;
}

QString fitting(QString text, const std::function<bool(const QString&)>& fits) {
    while (!text.isEmpty() && !fits(text)) {
        const auto sign =
            std::find_if(text.crbegin(), text.crend(), [](QChar c) { return c == u';' || c == u':' || c == u','; });
        text.truncate(std::max<qsizetype>(0, text.crend() - sign - 1));
    }
    return text;
}

}  // namespace app
