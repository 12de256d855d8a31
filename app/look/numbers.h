#pragma once
#include <QString>

namespace app {

// Numbers in the form for people. Minus is U+2212. From 1 000 on, groups of three digits before the point are separated
// by U+2009. NaN, +∞ and −∞ are words.

// Keeps the decimal point in the C library and its users. Qt's application object sets the user's locale for them,
// which may have a comma, so call this after creating one.
void keepPointInNumbers();

QString number(double value, int decimals);
QString dotProduct(double value);  // 4 decimals; also for products and weights
QString intensity(double value);   // 3 decimals
// A component of a unit vector: 3 decimals; exact 0, 1 and −1 without decimals.
QString component(double value);
QString vectorText(double x, double y, double z);  // "(0, 0.894, 0.447)"
// As many decimals as are needed to distinguish neighbours of the format: 4 in float at 10³.
QString depth(double value, bool isDouble = false);
QString angle(double degrees);            // "39.2°"
QString errorText(double value);          // two digits: "3.9e-6", "0"
QString milliseconds(double value);       // three digits: "0.161 ms", "12.3 ms"
QString sixDigits(double value);          // at most six significant digits: "−0.25", "1e-07"
QString count(qint64 value);              // "2 686"
QString withGroups(const QString& text);  // "2686 fragments" as "2 686 fragments", for every number in it
QString fullPrecision(double value);      // the shortest text that reads back as the same double; plain ASCII

}  // namespace app
