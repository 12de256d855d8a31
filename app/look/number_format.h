#pragma once
#include <QObject>
#include <QString>
#include <optional>

#include "pipeline/inspect/formula.h"

namespace app {

// How real numbers are written in buffers, tables and the inspector.
struct NumberFormat {
    enum class Form {
        AsStored,     // the digits of the stored number: a depth in those of its format, a dot product in four
        Fixed,        // that many digits after the point
        Scientific,   // that many digits of the mantissa, and a power of ten
        Hexadecimal,  // every bit: 0x1.8p-1 is 1.5 / 2
    };
    static constexpr int kMostDigits = 17;                  // enough to distinguish any two doubles
    static constexpr int kLeastPower = 1, kMostPower = 15;  // powers of ten from which an exponent is written
    Form form = Form::AsStored;
    int digits = 6;            // for Fixed and Scientific, and for numbers with an exponent
    std::optional<int> power;  // AsStored and Fixed: exponent from 10^power on and below 10^-power; else never
    bool operator==(const NumberFormat&) const = default;
};

// Empty if the format leaves the digits to the kind of number. At most `characters` long if that is > 0, by dropping
// digits; hexadecimal numbers are never shortened.
std::optional<QString> written(const NumberFormat& format, double value, int characters = 0);

// The current format: one object for the program, like the theme.
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
    static thread_local const NumberFormat* s_worn;  // like the theme's
    NumberFormat m_format;
};

// written() in the current format.
std::optional<QString> chosenText(double value, int characters = 0);
pipeline::NumberText chosenNumbers();

}  // namespace app
