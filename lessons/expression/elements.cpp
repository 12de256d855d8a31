#include "lessons/expression/elements.h"

#include <algorithm>

#include "lessons/expression/function_table.h"
#include "lessons/expression/operations.h"

namespace lessons {

using pipeline::AnyBuffer;
using pipeline::Error;
using Kind = Node::Kind;
using Numbers = std::vector<double>;

pipeline::Result<ElementValues> ElementValues::of(const Node& root, const Context& context) {
    ElementValues values(root);
    values.m_columns = std::size_t(context.frame.scene().settings.width);
    if (auto error = values.prepare(root, context)) return *error;
    return values;
}

std::optional<Error> ElementValues::prepare(const Node& node, const Context& context) {
    if (!node.varies) {
        const auto value = evaluate(Expression{{}, node, {}, 0}, context);
        if (!value) return value.errors().front();
        m_constants[&node] = value->numbers;
        return {};
    }
    if (node.kind == Kind::Element) {
        const auto buffer = context.frame.buffer(*node.buffer);
        if (!buffer)
            return Error{node.where,
                         "no " + node.buffer->text() + " in this frame: " + context.frame.whyAbsent(*node.buffer)};
        const std::size_t count = buffer->count() / std::size_t(buffer->channels());
        if (m_count != 0 && m_count != count)
            return Error{node.where, node.buffer->text() + " has another size than the buffers before it"};
        m_count = count;
        m_columns = buffer->columns();
        m_buffers.emplace(&node, *buffer);
    }
    for (const Node& operand : node.operands)
        if (auto error = prepare(operand, context)) return error;
    return {};
}

Numbers ElementValues::numbers(std::size_t first, std::size_t count) const { return at(*m_root, first, count); }

Numbers ElementValues::read(const Node& node, std::size_t first, std::size_t count) const {
    const AnyBuffer& from = m_buffers.at(&node);
    const auto channels = std::size_t(from.channels()), taken = std::size_t(node.size);
    const auto offset = std::size_t(node.channel.value_or(0));
    Numbers numbers(count * taken);
    std::visit(
        [&](const auto& values) {
            for (std::size_t i = 0; i < count; ++i)
                for (std::size_t c = 0; c < taken; ++c)
                    numbers[i * taken + c] = double(values[(first + i) * channels + offset + c]);
        },
        from.data);
    return numbers;
}

namespace {

// A number before or behind a vector goes with each of its numbers.
Numbers spread(Numbers numbers, int from, int to) {
    if (from == to) return numbers;
    Numbers wide;
    wide.reserve(numbers.size() * std::size_t(to));
    for (const double value : numbers) wide.insert(wide.end(), std::size_t(to), value);
    return wide;
}

// Whether all `size` numbers of a and b together are equal, or whether any differ.
Numbers joined(const Numbers& parts, std::size_t size, bool all) {
    Numbers numbers(parts.size() / size);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const auto first = parts.begin() + std::ptrdiff_t(i * size);
        const auto isTrue = [](double truth) { return truth != 0; };
        numbers[i] = double(all ? std::all_of(first, first + std::ptrdiff_t(size), isTrue)
                                : std::any_of(first, first + std::ptrdiff_t(size), isTrue));
    }
    return numbers;
}

Numbers operated(const Node& node, Numbers a, Numbers b) {
    const int size = std::max(node.operands[0].size, node.operands[1].size);
    a = spread(std::move(a), node.operands[0].size, size);
    b = spread(std::move(b), node.operands[1].size, size);
    Numbers numbers(a.size());
    withOperation(node.kind, [&](auto operation) {
        for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = operation(a[i], b[i]);
    });
    return size == node.size ? numbers : joined(numbers, std::size_t(size), node.kind == Kind::Equal);
}

Numbers called(const Node& node, const std::vector<Numbers>& operands, std::size_t count) {
    const auto size = std::size_t(node.size);
    Numbers numbers(count * size);
    if (node.function->takes == Takes::Choice) {
        for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = operands[operands[0][i / size] != 0 ? 1 : 2][i];
        return numbers;
    }
    const auto part = [&](std::size_t k, std::size_t i) {
        if (k >= operands.size()) return std::span<const double>();
        const auto width = std::size_t(node.operands[k].size);
        return std::span(operands[k]).subspan(i * width, width);
    };
    for (std::size_t i = 0; i < count; ++i)
        node.function->calculate(part(0, i), part(1, i), std::span(numbers).subspan(i * size, size));
    return numbers;
}

}  // namespace

Numbers ElementValues::at(const Node& node, std::size_t first, std::size_t count) const {
    const auto size = std::size_t(node.size);
    if (!node.varies) {
        const Numbers& value = m_constants.at(&node);
        Numbers numbers;
        numbers.reserve(count * size);
        for (std::size_t i = 0; i < count; ++i) numbers.insert(numbers.end(), value.begin(), value.end());
        return numbers;
    }
    if (node.kind == Kind::Element) return read(node, first, count);
    std::vector<Numbers> of;
    for (const Node& operand : node.operands) of.push_back(at(operand, first, count));
    Numbers numbers(count * size);
    switch (node.kind) {
        case Kind::Column:
            for (std::size_t i = 0; i < count; ++i) numbers[i] = double((first + i) % m_columns);
            return numbers;
        case Kind::Row:
            for (std::size_t i = 0; i < count; ++i) {
                const std::size_t row = (first + i) / m_columns;
                numbers[i] = double(row);
            }
            return numbers;
        case Kind::Negate:
            for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = -of[0][i];
            return numbers;
        case Kind::Not:
            for (std::size_t i = 0; i < count; ++i) numbers[i] = double(of[0][i] == 0);
            return numbers;
        case Kind::Vector:
            for (std::size_t i = 0; i < count; ++i)
                for (std::size_t c = 0; c < size; ++c) numbers[i * size + c] = of[c][i];
            return numbers;
        case Kind::Component: {
            const auto width = std::size_t(node.operands[0].size);
            for (std::size_t i = 0; i < count; ++i) numbers[i] = of[0][i * width + std::size_t(*node.channel)];
            return numbers;
        }
        case Kind::Call: return called(node, of, count);
        default: return operated(node, std::move(of[0]), std::move(of[1]));
    }
}

}  // namespace lessons
