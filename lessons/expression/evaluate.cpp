// An expression's value in a frame.
#include <algorithm>
#include <array>
#include <cmath>

#include "lessons/expression/function_table.h"
#include "lessons/expression/operations.h"

namespace lessons {

namespace {

using pipeline::Error;
using pipeline::Result;
using Kind = Node::Kind;

Value truth(bool holds) { return {{double(holds)}, holds ? "true" : "false"}; }

Result<Value> evaluate(const Node& node, const Context& context);

Result<Value> calculated(const Node& node, const std::vector<Value>& operands) {
    Value value{std::vector<double>(std::size_t(node.size)), {}};
    const auto numbers = [&](std::size_t k) {
        return k < operands.size() ? std::span<const double>(operands[k].numbers) : std::span<const double>();
    };
    node.function->calculate(numbers(0), numbers(1), value.numbers);
    return value;
}

Result<Value> called(const Node& node, const Context& context) {
    if (node.function->takes == Takes::Choice) {  // what is not chosen need not have a value
        const auto condition = evaluate(node.operands[0], context);
        if (!condition) return condition;
        return evaluate(node.operands[condition->numbers[0] != 0 ? 1 : 2], context);
    }
    // The formulas of all elements, and of other frames, are the function's own affair.
    const bool itself = node.function->takes == Takes::ElementCondition ||
                        node.function->takes == Takes::PixelCondition || node.function->takes == Takes::Changes;
    std::vector<Value> values;
    std::vector<double> numbers;
    if (!itself)
        for (const Node& operand : node.operands) {
            auto value = evaluate(operand, context);
            if (!value) return value;
            if (value->numbers.size() == 1) numbers.push_back(value->numbers[0]);
            values.push_back(std::move(value).value());
        }
    return node.function->calculate ? calculated(node, values) : node.function->read(node, numbers, context);
}

bool dependsOnPick(const Node& node) {
    return node.kind == Kind::Picked || std::ranges::any_of(node.operands, dependsOnPick);
}

Result<Value> calledOnce(const Node& node, const Context& context) {
    if (!context.kept || dependsOnPick(node)) return called(node, context);
    const std::pair key(&node, &context.frame);
    if (const auto known = context.kept->of.find(key); known != context.kept->of.end()) return known->second;
    auto value = called(node, context);
    if (value) context.kept->of.emplace(key, *value);
    return value;
}

Result<Value> operated(const Node& node, const Context& context) {
    const auto left = evaluate(node.operands[0], context);
    if (!left) return left;
    if (node.kind == Kind::Negate) {
        Value value = *left;
        for (double& number : value.numbers) number = -number;
        return value;
    }
    if (node.kind == Kind::Not) return truth(left->numbers[0] == 0);
    if (node.kind == Kind::Component) return Value{{left->numbers[std::size_t(*node.channel)]}, {}};
    // What is settled by its first part need not have a second.
    if (node.kind == Kind::And && left->numbers[0] == 0) return left;
    if (node.kind == Kind::Or && left->numbers[0] != 0) return left;
    const auto right = evaluate(node.operands[1], context);
    if (!right) return right;
    if (node.operands[0].type == Type::Words) return truth((left->words == right->words) == (node.kind == Kind::Equal));
    const std::size_t size = std::max(left->numbers.size(), right->numbers.size());
    const auto part = [](const Value& value, std::size_t i) {
        return value.numbers[value.numbers.size() == 1 ? 0 : i];
    };
    Value value;
    withOperation(node.kind, [&](auto operation) {
        for (std::size_t i = 0; i < size; ++i) value.numbers.push_back(operation(part(*left, i), part(*right, i)));
    });
    if (node.type != Type::Truth) return value;
    const auto isTrue = [](double number) { return number != 0; };
    return truth(node.kind == Kind::Equal ? std::ranges::all_of(value.numbers, isTrue)
                                          : std::ranges::any_of(value.numbers, isTrue));
}

Result<Value> evaluate(const Node& node, const Context& context) {
    if (context.stop.stop_requested()) return error(node, "stopped");
    switch (node.kind) {
        case Kind::Number: return Value{{node.number}, {}};
        case Kind::Words: return Value{{}, node.word};
        case Kind::Picked:
            if (const auto found = context.pick ? context.pick->*node.picked->value : std::nullopt)
                return Value{{*found}, {}};
            return error(node, "nothing of this kind was picked");
        case Kind::Vector: {
            Value vector;
            for (const Node& part : node.operands) {
                const auto value = evaluate(part, context);
                if (!value) return value;
                vector.numbers.push_back(value->numbers[0]);
            }
            return vector;
        }
        case Kind::Call: return calledOnce(node, context);
        default: return operated(node, context);
    }
}

}  // namespace

std::span<const PickField> pickFields() {
    static constexpr std::array<PickField, 6> kFields{{{"x", &Pick::x},
                                                       {"y", &Pick::y},
                                                       {"polygon", &Pick::polygon},
                                                       {"vertex", &Pick::vertex},
                                                       {"object", &Pick::object},
                                                       {"light", &Pick::light}}};
    return kFields;
}

Result<Value> evaluate(const Expression& expression, const Context& context) {
    auto value = evaluate(expression.root, context);
    if (!value) return value;
    for (const double part : value->numbers)
        if (!std::isfinite(part))
            return error(expression.root, expression.text + " is " + toText(Value{{part}, {}}), "a finite number");
    return value;
}

}  // namespace lessons
