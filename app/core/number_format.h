#pragma once
#include <QObject>
#include <QString>
#include <optional>

#include "pipeline/inspect/formula.h"

namespace app {

// How real numbers are written in buffers, tables and the inspector.
struct NumberFormat {
    enum class Form {
        AsStored,     // in the digits of what they are: a depth in those of its format, a dot product in four
        Fixed,        // so many digits after the point
        Scientific,   // the same of a mantissa, with its power of ten
        Hexadecimal,  // every bit of it: 0x1.8p-1 is 1.5 / 2
    };
    static constexpr int kMostDigits = 17;                  // what tells any two doubles apart
    static constexpr int kLeastPower = 1, kMostPower = 15;  // of ten, from which on it is written out
    Form form = Form::AsStored;
    int digits = 6;            // of Fixed and Scientific, and of what is written with a power
    std::optional<int> power;  // AsStored and Fixed: from 10^power on and below 10^-power with a power; else never
    bool operator==(const NumberFormat&) const = default;
};

// Nothing where the format leaves the digits to what the number is. At most `characters` long if that is > 0, by leaving
// out digits; hexadecimal numbers stay whole.
std::optional<QString> written(const NumberFormat& format, double value, int characters = 0);

// The format in force: one object for the program, as the theme is.
class NumberStyle : public QObject {
    Q_OBJECT
public:
    static NumberStyle& current();
    const NumberFormat& format() const { return s_worn ? *s_worn : m_format; }
    void set(const NumberFormat& format);

signals:
    void changed();

private:
    friend class WornLook;
    NumberStyle() = default;
    static thread_local const NumberFormat* s_worn;  // as the theme's
    NumberFormat m_format;
};

// written() in the format in force.
std::optional<QString> chosenText(double value, int characters = 0);
pipeline::NumberText chosenNumbers();

}  // namespace app
