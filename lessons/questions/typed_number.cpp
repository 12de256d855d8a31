#include "lessons/questions/typed_number.h"

#include <algorithm>
#include <cmath>

#include "lessons/expression/expression.h"
#include "lessons/expression/function_table.h"
#include "lessons/lesson_text.h"
#include "pipeline/core/text.h"

namespace lessons {

namespace {

constexpr std::size_t kMostTyped = 200;  // characters
constexpr char kExpected[] = "a number such as 0.5, 0,5, 1/2 or sqrt(2)/2";

// Whether only numbers are calculated: a typed answer reads no buffer and no setting.
bool isPlain(const Node& node) {
    const bool calculates = node.kind != Node::Kind::Call || node.function->calculate;
    return calculates && !node.varies && node.kind != Node::Kind::Picked && std::ranges::all_of(node.operands, isPlain);
}

double lastPlaceOf(std::string_view digits) {
    const std::size_t point = digits.find_first_of(".,");
    const std::size_t exponent = std::min(digits.find_first_of("eE"), digits.size());
    const double power = exponent < digits.size() ? numberIn(digits.substr(exponent + 1)).value_or(0) : 0;
    const double decimals = point < exponent ? double(exponent - point - 1) : 0;
    return std::pow(10.0, power - decimals);
}

std::string_view withoutUnit(std::string_view text, std::string_view unit) {
    if (!unit.empty() && text.ends_with(unit)) text.remove_suffix(unit.size());
    return trimmed({text, {}}).text;
}

}  // namespace

pipeline::Result<TypedNumber> typedNumber(std::string_view text, std::string_view unit) {
    const std::string_view plain = withoutUnit(trimmed({text, {}}).text, unit);
    const auto refused = [&] { return pipeline::Error{{}, pipeline::inQuotes(text) + " is not a number", kExpected}; };
    if (plain.empty()) return pipeline::Error{{}, "The answer is empty", kExpected};
    if (plain.size() > kMostTyped) return refused();
    if (const auto number = numberIn(plain)) {
        const bool comma = plain.find(',') != plain.npos;
        return TypedNumber{*number, comma ? TypedNumber::Form::DecimalComma : TypedNumber::Form::Decimal,
                           lastPlaceOf(plain)};
    }
    std::string formula(plain);
    for (std::size_t at; (at = formula.find("\u2212")) != std::string::npos;) formula.replace(at, 3, 1, '-');
    static const pipeline::Scene kNoScene{};
    const auto expression = parseExpression(formula, {}, {kNoScene});
    if (!expression || expression->root.type != Type::Number || !isPlain(expression->root)) return refused();
    static const pipeline::Frame kNoFrame{};  // a plain formula reads none
    const auto value = evaluate(*expression, {.frame = kNoFrame});
    if (!value) return pipeline::Error{{}, pipeline::inQuotes(text) + " has no finite value", kExpected};
    return TypedNumber{value->numbers.front(), TypedNumber::Form::Formula, 0};
}

}  // namespace lessons
