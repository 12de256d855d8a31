#pragma once
#include "lessons/expression/expression.h"
#include "pipeline/core/elementary.h"

namespace lessons {

// use(operation) with the arithmetic of an operator on two numbers; truth is 1 and 0. Both evaluators call it, so that
// they agree. Comparisons with NaN are false. No operator, or one of one operand: nothing is done.
template <class Use>
void withOperation(Node::Kind kind, Use use) {
    using Kind = Node::Kind;
    switch (kind) {
        case Kind::Add: return use([](double a, double b) { return a + b; });
        case Kind::Subtract: return use([](double a, double b) { return a - b; });
        case Kind::Multiply: return use([](double a, double b) { return a * b; });
        case Kind::Divide: return use([](double a, double b) { return a / b; });
        case Kind::Power: return use([](double a, double b) { return pipeline::pow(a, b); });
        case Kind::Less: return use([](double a, double b) { return double(a < b); });
        case Kind::LessEqual: return use([](double a, double b) { return double(a <= b); });
        case Kind::Greater: return use([](double a, double b) { return double(a > b); });
        case Kind::GreaterEqual: return use([](double a, double b) { return double(a >= b); });
        case Kind::Equal: return use([](double a, double b) { return double(a == b); });
        case Kind::NotEqual: return use([](double a, double b) { return double(a < b || a > b); });
        case Kind::And: return use([](double a, double b) { return double(a != 0 && b != 0); });
        case Kind::Or: return use([](double a, double b) { return double(a != 0 || b != 0); });
        default: return;
    }
}

}  // namespace lessons
