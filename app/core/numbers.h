#pragma once
#include <QString>

namespace app {

// How a person reads numbers in the window. Minus is U+2212; from 1 000 on, groups of three
// stand apart by U+2009, before the point only; NaN, +∞ and −∞ are words of that form.

// A point in what the C library and those that use it read and write. An application object of Qt takes on the user's
// locale for them too, in which it may be a comma; to be called after one is made.
void keepPointInNumbers();

QString number(double value, int decimals);
QString dotProduct(double value);  // 4 decimals; products and weights too
QString intensity(double value);   // 3 decimals
// A component of a unit vector: 3 decimals, exact 0, 1 and −1 without.
QString component(double value);
QString vectorText(double x, double y, double z);  // "(0, 0.894, 0.447)"
// As many decimals as tell neighbours of the format apart: 4 in float at 10³.
QString depth(double value, bool isDouble = false);
QString angle(double degrees);            // "39.2°"
QString errorText(double value);          // two digits: "3.9e-6", "0"
QString milliseconds(double value);       // three digits: "0.161 ms", "12.3 ms"
QString sixDigits(double value);          // as short as six digits that matter are: "−0.25", "1e-07"
QString count(qint64 value);              // "2 686"
QString withGroups(const QString& text);  // "2686 fragments" as "2 686 fragments", every number in it
QString fullPrecision(double value);      // the shortest text that reads back as the same double; plain ASCII

}  // namespace app
