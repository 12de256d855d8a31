#include "lessons/condition.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lessons {

namespace {

using pipeline::AnyBuffer;
using pipeline::Error;
using pipeline::Frame;
using Kind = ConditionNode::Kind;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// A run of pixels at a time: a node's numbers of them stay in the cache.
constexpr std::size_t kRun = 1024;

// The numbers of a node at a run of pixels, `channels` of each; truth is 1 and 0.
using Numbers = std::vector<double>;

struct Evaluation {
    const Frame& frame;
    std::vector<AnyBuffer> buffers;  // those that the condition names
    std::size_t width = 0;

    const AnyBuffer& buffer(const pipeline::BufferName& name) const {
        return *std::ranges::find(buffers, name, &AnyBuffer::name);
    }

    Numbers read(const ConditionNode& node, std::size_t first, std::size_t count) const {
        const AnyBuffer& from = buffer(*node.buffer);
        const auto channels = std::size_t(from.channels()), taken = std::size_t(node.channels);
        const std::size_t offset = std::size_t(std::max(0, node.channel));
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

    Numbers call(const ConditionNode& node, const std::vector<Numbers>& operands, std::size_t count) const {
        Numbers numbers(count);
        const Node nowhere;
        for (std::size_t i = 0; i < count; ++i) {
            double given[2]{operands[0][i], operands.size() > 1 ? operands[1][i] : 0};
            const auto value = node.function->evaluate(nowhere, std::span(given, operands.size()), frame);
            numbers[i] = value && value->numbers.size() == 1 ? value->numbers[0] : kNone;
        }
        return numbers;
    }

    template <class Operation>
    static Numbers each(const std::vector<Numbers>& operands, Operation operation) {
        Numbers numbers(operands[0].size());
        for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = operation(operands[0][i], operands[1][i]);
        return numbers;
    }

    // A number before a vector multiplies each of its channels.
    static std::vector<Numbers> spread(const ConditionNode& node, std::vector<Numbers> operands) {
        for (std::size_t k = 0; k < operands.size(); ++k) {
            if (node.operands[k].channels == node.channels) continue;
            Numbers wide;
            for (const double value : operands[k]) wide.insert(wide.end(), std::size_t(node.channels), value);
            operands[k] = std::move(wide);
        }
        return operands;
    }

    static Numbers dots(const Numbers& a, const Numbers& b) {
        Numbers numbers(a.size() / 3);
        for (std::size_t i = 0; i < numbers.size(); ++i)
            numbers[i] = a[3 * i] * b[3 * i] + a[3 * i + 1] * b[3 * i + 1] + a[3 * i + 2] * b[3 * i + 2];
        return numbers;
    }

    Numbers operator()(const ConditionNode& node, std::size_t first, std::size_t count) const {
        std::vector<Numbers> of;
        for (const ConditionNode& operand : node.operands) of.push_back((*this)(operand, first, count));
        Numbers numbers(count * std::size_t(std::max(1, node.channels)));
        const auto truth = [&](auto holds) {
            return each(of, [&](double a, double b) { return holds(a, b) ? 1.0 : 0.0; });
        };
        switch (node.kind) {
            case Kind::Number: std::ranges::fill(numbers, node.number); break;
            case Kind::Column:
                for (std::size_t i = 0; i < count; ++i) numbers[i] = double((first + i) % width);
                break;
            case Kind::Row:
                for (std::size_t i = 0; i < count; ++i) {
                    const std::size_t row = (first + i) / width;
                    numbers[i] = double(row);
                }
                break;
            case Kind::Buffer: return read(node, first, count);
            case Kind::Negate:
                for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = -of[0][i];
                break;
            case Kind::Add: return each(of, [](double a, double b) { return a + b; });
            case Kind::Subtract: return each(of, [](double a, double b) { return a - b; });
            case Kind::Multiply: return each(spread(node, std::move(of)), [](double a, double b) { return a * b; });
            case Kind::Divide: return each(spread(node, std::move(of)), [](double a, double b) { return a / b; });
            case Kind::Power: return each(of, [](double a, double b) { return std::pow(a, b); });
            case Kind::Call: return call(node, of, count);
            case Kind::Length:
                numbers = dots(of[0], of[0]);
                for (double& value : numbers) value = std::sqrt(value);
                break;
            case Kind::Dot: return dots(of[0], of[1]);
            case Kind::Less: return truth([](double a, double b) { return a < b; });
            case Kind::LessEqual: return truth([](double a, double b) { return a <= b; });
            case Kind::Greater: return truth([](double a, double b) { return a > b; });
            case Kind::GreaterEqual: return truth([](double a, double b) { return a >= b; });
            case Kind::Equal: return truth([](double a, double b) { return a == b; });
            case Kind::NotEqual: return truth([](double a, double b) { return a < b || a > b; });
            case Kind::Not:
                for (std::size_t i = 0; i < count; ++i) numbers[i] = 1 - of[0][i];
                break;
            case Kind::And: return truth([](double a, double b) { return a != 0 && b != 0; });
            case Kind::Or: return truth([](double a, double b) { return a != 0 || b != 0; });
        }
        return numbers;
    }
};

// Every buffer that a node and those below it name.
std::optional<Error> addBuffers(const ConditionNode& node, const Frame& frame, std::vector<AnyBuffer>& buffers) {
    if (node.buffer) {
        const auto found = frame.buffer(*node.buffer);
        if (!found) return Error{{}, "no " + node.buffer->text() + " in this frame: " + frame.whyAbsent(*node.buffer)};
        buffers.push_back(*found);
    }
    for (const ConditionNode& operand : node.operands)
        if (auto error = addBuffers(operand, frame, buffers)) return error;
    return {};
}

// take(i, number) for every pixel i, in reading order, where something was drawn, with the root's number there.
template <class Take>
std::optional<Error> goThrough(const Condition& condition, const Frame& frame, const AnyBuffer& polygons,
                               const std::stop_token& stop, Take take) {
    const auto ids = std::get<std::span<const std::int32_t>>(polygons.data);
    const auto layers = frame.buffer({pipeline::BufferId::Layers});
    const auto isDrawn = [&](std::size_t i) { return ids[i] >= 0 || (layers && layers->flat(i) > 0); };
    Evaluation evaluation{frame, {}, polygons.columns()};
    if (auto error = addBuffers(condition.root, frame, evaluation.buffers)) return error;
    for (std::size_t first = 0; first < ids.size(); first += kRun) {
        if (stop.stop_requested()) return Error{{}, "stopped"};
        const std::size_t count = std::min(kRun, ids.size() - first);
        std::size_t i = first;
        while (i < first + count && !isDrawn(i)) ++i;
        if (i == first + count) continue;
        const Numbers numbers = evaluation(condition.root, first, count);
        for (; i < first + count; ++i)
            if (isDrawn(i)) take(i, numbers[i - first]);
    }
    return {};
}

constexpr const char* kNoPolygons = "no polygon_id in this frame: the z-buffer has not run";

}  // namespace

pipeline::Result<ConditionMask> evaluate(const Condition& condition, const Frame& frame, const std::stop_token& stop) {
    const auto polygons = frame.buffer({pipeline::BufferId::PolygonId});
    if (!polygons) return Error{{}, kNoPolygons};
    ConditionMask mask{{int(polygons->columns()), int(polygons->rows())}, std::vector<bool>(polygons->count())};
    const auto error = goThrough(condition, frame, *polygons, stop, [&](std::size_t i, double truth) {
        ++mask.drawn;
        if (truth == 0) return;
        mask.holds[i] = true;
        ++mask.count;
    });
    if (error) return *error;
    return mask;
}

AnyBuffer bufferOf(const ConditionMask& mask) {
    const auto owner = std::make_shared<std::vector<std::uint8_t>>(mask.holds.begin(), mask.holds.end());
    return {{pipeline::BufferId::Condition},
            &bufferInfo(pipeline::BufferId::Condition),
            {std::size_t(mask.size.y), std::size_t(mask.size.x)},
            std::span<const std::uint8_t>(*owner),
            owner};
}

pipeline::Result<AnyBuffer> evaluateNumbers(const Condition& expression, const Frame& frame,
                                            const std::stop_token& stop) {
    const auto polygons = frame.buffer({pipeline::BufferId::PolygonId});
    if (!polygons) return Error{{}, kNoPolygons};
    const auto owner = std::make_shared<std::vector<double>>(polygons->count());
    const auto error =
        goThrough(expression, frame, *polygons, stop, [&](std::size_t i, double number) { (*owner)[i] = number; });
    if (error) return *error;
    return AnyBuffer{{pipeline::BufferId::Expression},
                     &bufferInfo(pipeline::BufferId::Expression),
                     {polygons->rows(), polygons->columns()},
                     std::span<const double>(*owner),
                     owner};
}

std::optional<glm::ivec2> nextHolding(const ConditionMask& mask, std::optional<glm::ivec2> from, bool forward) {
    const std::size_t n = mask.holds.size();
    if (mask.count == 0) return {};
    const auto width = std::size_t(mask.size.x);
    std::size_t at = forward ? n - 1 : 0;
    if (from) at = std::size_t(from->y) * width + std::size_t(from->x);
    for (std::size_t i = 0; i < n; ++i) {
        at = forward ? (at + 1) % n : (at + n - 1) % n;
        if (mask.holds[at]) return glm::ivec2(at % width, at / width);
    }
    return {};
}

}  // namespace lessons
