#pragma once
#include "lessons/expression/expression.h"
#include "pipeline/core/elementary.h"

namespace lessons {

// use(operation) with the arithmetic of an operator on two numbers; truth is 1 and 0. Both evaluators call it, so that
// they agree. Comparisons with NaN are false. No operator, or one of one operand: nothing is done.
template <class Use>
void withOperation(Node::Kind kind, Use use) {
    using enum Node::Kind;
    switch (kind) {
        case Add: return use([](double a, double b) { return a + b; });
        case Subtract: return use([](double a, double b) { return a - b; });
        case Multiply: return use([](double a, double b) { return a * b; });
        case Divide: return use([](double a, double b) { return a / b; });
        case Power: return use([](double a, double b) { return pipeline::pow(a, b); });
        case Less: return use([](double a, double b) { return double(a < b); });
        case LessEqual: return use([](double a, double b) { return double(a <= b); });
        case Greater: return use([](double a, double b) { return double(a > b); });
        case GreaterEqual: return use([](double a, double b) { return double(a >= b); });
        case Equal: return use([](double a, double b) { return double(a == b); });
        case NotEqual: return use([](double a, double b) { return double(a < b || a > b); });
        case And: return use([](double a, double b) { return double(a != 0 && b != 0); });
        case Or: return use([](double a, double b) { return double(a != 0 || b != 0); });
        default: return;
    }
}

}  // namespace lessons
