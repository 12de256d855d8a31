#include "app/look/numbers.h"

#include <QLocale>
#include <QRegularExpression>
#include <algorithm>
#include <clocale>
#include <cmath>
#include <limits>

namespace app {

namespace {

constexpr QChar kMinus(0x2212), kThinSpace(0x2009), kInfinity(0x221E);

// The word for what is no finite number, else empty.
QString wordFor(double value) {
    if (std::isnan(value)) return "NaN";
    if (std::isinf(value)) return QString(value > 0 ? QChar('+') : kMinus) + kInfinity;
    return {};
}

}  // namespace

void keepPointInNumbers() { std::setlocale(LC_NUMERIC, "C"); }

QString number(double value, int decimals) {
    if (const QString word = wordFor(value); !word.isEmpty()) return word;
    QString text = QString::number(std::abs(value), 'f', decimals);
    const qsizetype point = text.indexOf('.');
    for (qsizetype i = (point < 0 ? text.size() : point) - 3; i > 0; i -= 3) text.insert(i, kThinSpace);
    // −0.000 would claim a sign that the digits shown do not have.
    const bool isZero = std::all_of(text.begin(), text.end(), [](QChar c) { return c == '0' || c == '.'; });
    return value < 0 && !isZero ? kMinus + text : text;
}

QString dotProduct(double value) { return number(value, 4); }

QString intensity(double value) { return number(value, 3); }

QString component(double value) { return value == 0 || std::abs(value) == 1 ? number(value, 0) : number(value, 3); }

QString vectorText(double x, double y, double z) {
    return '(' + component(x) + ", " + component(y) + ", " + component(z) + ')';
}

QString depth(double value, bool isDouble) {
    if (!std::isfinite(value)) return number(value, 0);
    const double step = isDouble
                            ? std::nextafter(std::abs(value), INFINITY) - std::abs(value)
                            : double(std::nextafter(float(std::abs(value)), INFINITY)) - double(float(std::abs(value)));
    // Beside 0 neighbours are 1e-45 apart; nobody reads that many digits.
    return number(value, std::clamp(int(std::lround(-std::log10(step))), 0, isDouble ? 12 : 8));
}

QString angle(double degrees) { return number(degrees, 1) + QChar(0xB0); }

QString errorText(double value) {
    if (const QString word = wordFor(value); !word.isEmpty()) return word;
    if (value == 0) return "0";
    QString text = QString::number(value, 'e', 1);  // "3.9e-06"
    const qsizetype e = text.indexOf('e');
    return text.left(e) + 'e' + QString::number(text.mid(e + 1).toInt());
}

QString milliseconds(double value) {
    if (!std::isfinite(value)) return number(value, 0) + " ms";
    // The rounded value decides: 9.9996 is 10.0, not 10.00.
    int decimals = 3;
    while (decimals > 0 && std::abs(value) * std::pow(10.0, decimals) >= 999.5) --decimals;
    return number(value, decimals) + " ms";
}

QString sixDigits(double value) {
    const QString text = QString::number(std::abs(value), 'g', 6);
    return value < 0 ? kMinus + text : text;
}

QString count(qint64 value) { return number(double(value), 0); }

QString withGroups(const QString& text) {
    static const QRegularExpression whole("(?<![\\d.])\\d{4,18}(?!\\d)");  // not the digits after a point
    QString out;
    qsizetype end = 0;
    for (auto it = whole.globalMatch(text); it.hasNext();) {
        const QRegularExpressionMatch digits = it.next();
        out += text.mid(end, digits.capturedStart() - end) + count(digits.captured().toLongLong());
        end = digits.capturedEnd();
    }
    return out + text.mid(end);
}

QString fullPrecision(double value) { return QString::number(value, 'g', QLocale::FloatingPointShortest); }

}  // namespace app
