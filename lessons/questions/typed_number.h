#pragma once
#include <string_view>

#include "pipeline/core/result.h"

namespace lessons {

// A number as somebody answers with it.
struct TypedNumber {
    enum class Form : std::uint8_t { Decimal, DecimalComma, Formula };  // 0.5; 0,5; 1/2 or sqrt(2)/2
    double value = 0;                                                   // finite
    Form form = Form::Decimal;
    double lastPlace = 0;  // of a decimal: the worth of its last digit, 0.01 for 0.67; 0 of a formula
};

// Takes 0.5, 0,5, −3, 1e-3, and what formulas calculate without a frame: 1/2, sqrt(2)/2, 2*pi, acos(0.5). The unit may
// stand behind it. An error says what somebody can type instead; it has no place.
pipeline::Result<TypedNumber> typedNumber(std::string_view text, std::string_view unit = {});

}  // namespace lessons
