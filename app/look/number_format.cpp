#include "app/look/number_format.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "app/look/numbers.h"

namespace app {

namespace {

QString scientific(double value, int digits) {
    if (value == 0) return "0";
    QString text = QString::number(std::abs(value), 'e', digits);  // "3.9e-06"
    const qsizetype e = text.indexOf('e');
    text = text.left(e + 1) + QString::number(text.mid(e + 1).toInt());
    return value < 0 ? QChar(0x2212) + text : text;
}

// −0 keeps its sign: it is a bit of the number.
QString hexadecimal(double value) {
    std::array<char, 32> digits;
    const auto end =
        std::to_chars(digits.data(), digits.data() + digits.size(), std::abs(value), std::chars_format::hex).ptr;
    const QString text = "0x" + QString::fromLatin1(digits.data(), end - digits.data());
    return std::signbit(value) ? QChar(0x2212) + text : text;
}

// With fewer and fewer digits until it fits.
template <class Write>
QString fitting(const Write& write, int digits, int characters) {
    QString text = write(digits);
    while (characters > 0 && text.size() > characters && digits > 0) text = write(--digits);
    return text;
}

}  // namespace

std::optional<QString> written(const NumberFormat& format, double value, int characters) {
    using Form = NumberFormat::Form;
    if (format.form != Form::AsStored && !std::isfinite(value)) return number(value, 0);
    if (format.form == Form::Hexadecimal) return hexadecimal(value);
    const double size = std::abs(value);
    const bool isFar = format.power && std::isfinite(value) && value != 0 &&
                       (size >= std::pow(10, *format.power) || size < std::pow(10, -*format.power));
    if (format.form == Form::Scientific || isFar)
        return fitting([value](int digits) { return scientific(value, digits); }, format.digits, characters);
    if (format.form == Form::Fixed)
        return fitting([value](int digits) { return number(value, digits); }, format.digits, characters);
    return {};
}

thread_local const NumberFormat* NumberStyle::s_worn = nullptr;

NumberStyle& NumberStyle::current() {
    static NumberStyle style;
    return style;
}

void NumberStyle::set(const NumberFormat& format) {
    NumberFormat next = format;
    next.digits = std::clamp(next.digits, 0, NumberFormat::kMostDigits);
    if (next.power) next.power = std::clamp(*next.power, NumberFormat::kLeastPower, NumberFormat::kMostPower);
    if (next == m_format) return;
    m_format = next;
    emit changed();
}

std::optional<QString> chosenText(double value, int characters) {
    return written(NumberStyle::current().format(), value, characters);
}

pipeline::NumberText chosenNumbers() {
    return [](double value) -> std::optional<std::string> {
        const auto text = chosenText(value);
        if (!text) return {};
        return text->toStdString();
    };
}

}  // namespace app
