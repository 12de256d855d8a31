#include "lessons/expression.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "pipeline/core/angles.h"
#include "pipeline/core/text.h"
#include "pipeline/inspect/pixel_report.h"
#include "pipeline/run/frame_data.h"
#include "pipeline/stages/cull.h"

namespace lessons {

namespace {

using pipeline::AnyBuffer;
using pipeline::Error;
using pipeline::Frame;
using pipeline::Result;
using Operands = std::span<const double>;

Value number(double value) { return {{value}, {}}; }
Value words(std::string_view text) { return {{}, std::string(text)}; }
Error error(const Node& node, std::string found, std::string expected = {}) {
    return {node.where, std::move(found), std::move(expected)};
}

Result<AnyBuffer> bufferOf(const Node& call, const Frame& frame) {
    if (auto buffer = frame.buffer(*call.buffer)) return *std::move(buffer);
    return error(call, "no " + call.buffer->text() + " in this frame: " + frame.whyAbsent(*call.buffer));
}

// An operand as an index below count.
Result<std::size_t> indexFrom(const Node& call, double operand, std::size_t count) {
    if (operand >= 0 && operand < double(count) && operand == std::trunc(operand)) return std::size_t(operand);
    return error(call, "found the place " + pipeline::shortestText(operand),
                 "a whole number from 0 to " + pipeline::shortestText(double(count) - 1));
}

Result<Value> element(const Node& call, Operands operands, const Frame& frame) {
    const auto buffer = bufferOf(call, frame);
    if (!buffer) return buffer.errors();
    const bool picture = operands.size() == 2;
    const auto column = picture ? indexFrom(call, operands[0], buffer->columns()) : Result<std::size_t>(std::size_t(0));
    if (!column) return column.errors();
    const auto row = indexFrom(call, operands.back(), buffer->rows());
    if (!row) return row.errors();
    if (call.channel) return number(buffer->value(*column, *row, *call.channel));
    Value value;
    for (int c = 0; c < buffer->channels(); ++c) value.numbers.push_back(buffer->value(*column, *row, c));
    return value;
}

bool holds(double left, std::string_view comparison, double right) {
    if (comparison == "=") return left == right;
    if (comparison == "!=") return left != right;
    if (comparison == "<") return left < right;
    if (comparison == "<=") return left <= right;
    if (comparison == ">") return left > right;
    return left >= right;
}

Result<Value> count(const Node& call, Operands operands, const Frame& frame) {
    const auto buffer = bufferOf(call, frame);
    if (!buffer) return buffer.errors();
    std::size_t places = 0;
    for (std::size_t i = 0; i < buffer->count(); ++i)
        if (holds(buffer->flat(i), call.word, operands[0])) ++places;
    return number(double(places));
}

Result<Value> extreme(const Node& call, const Frame& frame, double pipeline::BufferStatistics::*which) {
    const auto buffer = bufferOf(call, frame);
    if (!buffer) return buffer.errors();
    const pipeline::BufferStatistics found = pipeline::statistics(*buffer);
    if (found.finite == 0) return error(call, call.buffer->text() + " holds no finite number");
    return number(found.*which);
}

constexpr std::array<std::string_view, 7> kPixelFields{"polygon", "object",    "z_view", "depth",
                                                       "i_max",   "fragments", "culled"};
constexpr std::array<std::string_view, 5> kFragmentFields{"polygon", "depth", "stored", "comparison", "verdict"};

Result<pipeline::PixelReport> reportAt(const Node& call, Operands operands, const Frame& frame) {
    const auto x = indexFrom(call, operands[0], std::size_t(frame.scene().settings.width));
    if (!x) return x.errors();
    const auto y = indexFrom(call, operands[1], std::size_t(frame.scene().settings.height));
    if (!y) return y.errors();
    if (frame.until() != pipeline::StageId::Shading)
        return error(call, "this frame ends before shading", "a whole frame");
    return pipeline::inspectPixel(frame, {int(*x), int(*y)});
}

Result<Value> pixel(const Node& call, Operands operands, const Frame& frame) {
    const auto report = reportAt(call, operands, frame);
    if (!report) return report.errors();
    if (call.word == "fragments") return number(double(report->fragments.size()));
    if (call.word == "culled") return number(double(report->culled.size()));
    if (call.word == "i_max") return number(report->iMax);
    if (!report->covered) return error(call, "nothing is drawn at this pixel", "a pixel that a polygon covers");
    if (call.word == "polygon") return number(report->polygon);
    if (call.word == "object") return number(report->object);
    return number(call.word == "depth" ? report->depth : report->zView);
}

Result<Value> fragment(const Node& call, Operands operands, const Frame& frame) {
    const auto report = reportAt(call, operands, frame);
    if (!report) return report.errors();
    if (report->fragments.empty()) return error(call, "no fragment arrives at this pixel");
    const auto place = indexFrom(call, operands[2], report->fragments.size());
    if (!place) return place.errors();
    const pipeline::FragmentReport& found = report->fragments[*place];
    if (call.word == "polygon") return number(found.polygon);
    if (call.word == "comparison") return words(comparisonText(found).whole());
    if (call.word == "verdict") return words(name(found.verdict));
    return number(call.word == "depth" ? found.depth : found.stored);
}

// The outcome of the cull stage, whatever precision the frame is in.
const pipeline::CullOutput* cullOf(const Frame& frame) {
    return readStages(frame, [](const auto& data) { return data.cull.get(); });
}

Result<Value> ofPolygon(const Node& call, Operands operands, const Frame& frame,
                        Result<Value> (*give)(const Node& call, const Frame&, std::size_t polygon)) {
    const pipeline::CullOutput* const cull = cullOf(frame);
    if (!cull) return error(call, "no verdicts in this frame: cull has not run");
    const auto polygon = indexFrom(call, operands[0], cull->verdicts.size());
    if (!polygon) return polygon.errors();
    return give(call, frame, *polygon);
}

template <double (*function)(double)>
Result<Value> of(const Node&, Operands operands, const Frame&) {
    return number(function(operands[0]));
}

using T = Takes;
constexpr auto kFunctions = std::to_array<Function>({
    {"buffer", T::Element, "What a buffer holds at a pixel, a vertex or a polygon.", element},
    {"pixel", T::PixelField, "What the inspector says of a pixel.", pixel},
    {"fragment", T::FragmentField, "What happened to one of the fragments that arrived at a pixel.", fragment},
    {"count", T::Comparison, "How many numbers of a buffer compare so.", count},
    {"smallest", T::Buffer, "The smallest finite number of a buffer.",
     [](const Node& call, Operands, const Frame& frame) {
         return extreme(call, frame, &pipeline::BufferStatistics::min);
     }},
    {"largest", T::Buffer, "The largest finite number of a buffer.",
     [](const Node& call, Operands, const Frame& frame) {
         return extreme(call, frame, &pipeline::BufferStatistics::max);
     }},
    {"signed_area", T::Polygon, "The area of a polygon in the picture, px²; below 0 when it is seen from behind.",
     [](const Node& call, Operands operands, const Frame& frame) {
         return ofPolygon(call, operands, frame, [](const Node& at, const Frame& of, std::size_t i) -> Result<Value> {
             const auto area = pipeline::readStages(
                 of, [&](const auto& data) { return pipeline::signedArea(*data.transform, *data.cull, i); });
             if (area) return number(*area);
             return error(at,
                          fmt::format("polygon {} has no area in the picture: {}", i, name(cullOf(of)->verdicts[i])));
         });
     }},
    {"verdict", T::Polygon, "The cull stage's verdict on a polygon, in words.",
     [](const Node& call, Operands operands, const Frame& frame) {
         return ofPolygon(call, operands, frame, [](const Node&, const Frame& of, std::size_t i) -> Result<Value> {
             return words(name(cullOf(of)->verdicts[i]));
         });
     }},
    {"setting", T::Setting, "The value of a setting of the scene; of a choice or a switch the word.",
     [](const Node& call, Operands, const Frame& frame) -> Result<Value> {
         const double value = call.setting->get(frame.scene());
         const auto choices = call.setting->setting->choices;
         return choices.empty() ? number(value) : words(choices[std::size_t(value)]);
     }},
    {"why", T::Stage, "Why the plan runs, reuses or leaves out a stage, in words.",
     [](const Node& call, Operands, const Frame& frame) -> Result<Value> {
         return words(frame.plan()[index(*call.stage)].why);
     }},
    {"floor", T::Number, "The largest whole number that is not above it.", of<std::floor>},
    {"ceil", T::Number, "The smallest whole number that is not below it.", of<std::ceil>},
    {"round", T::Number, "The nearest whole number, halves away from 0.", of<std::round>},
    {"abs", T::Number, "Without its sign.", of<std::abs>},
    {"sqrt", T::Number, "Square root.", of<std::sqrt>},
    {"log", T::Number, "Natural logarithm.", of<std::log>},
    {"sin", T::Number, "Sine of an angle in degrees.", of<pipeline::sinDegrees>},
    {"cos", T::Number, "Cosine of an angle in degrees.", of<pipeline::cosDegrees>},
    {"acos", T::Number, "The angle with this cosine, degrees.",
     [](const Node&, Operands operands, const Frame&) -> Result<Value> {
         return number(std::acos(operands[0]) * 180 / std::acos(-1.0));
     }},
    {"min", T::TwoNumbers, "The smaller of two.",
     [](const Node&, Operands o, const Frame&) -> Result<Value> { return number(std::min(o[0], o[1])); }},
    {"max", T::TwoNumbers, "The larger of two.",
     [](const Node&, Operands o, const Frame&) -> Result<Value> { return number(std::max(o[0], o[1])); }},
});

Result<Value> evaluate(const Node& node, const Frame& frame) {
    std::vector<double> operands;
    for (const Node& part : node.operands) {
        const auto value = evaluate(part, frame);
        if (!value) return value.errors();
        if (value->numbers.size() != 1)
            return error(part, "found " + (value->numbers.empty() ? std::string("words") : std::string("a vector")),
                         "one number");
        operands.push_back(value->numbers.front());
    }
    using Kind = Node::Kind;
    switch (node.kind) {
        case Kind::Number: return number(node.number);
        case Kind::Negate: return number(-operands[0]);
        case Kind::Add: return number(operands[0] + operands[1]);
        case Kind::Subtract: return number(operands[0] - operands[1]);
        case Kind::Multiply: return number(operands[0] * operands[1]);
        case Kind::Divide: return number(operands[0] / operands[1]);
        case Kind::Power: return number(std::pow(operands[0], operands[1]));
        case Kind::Call: break;
    }
    return node.function->evaluate(node, operands, frame);
}

void collect(const Node& node, pipeline::BufferSet& buffers) {
    if (node.buffer) buffers.set(index(node.buffer->id));
    for (const Node& part : node.operands) collect(part, buffers);
}

}  // namespace

std::span<const Function> functionTable() { return kFunctions; }
std::span<const std::string_view> fieldsOf(Takes takes) {
    if (takes == Takes::PixelField) return kPixelFields;
    if (takes == Takes::FragmentField) return kFragmentFields;
    return {};
}

pipeline::BufferSet buffersOf(const Expression& expression) {
    pipeline::BufferSet buffers;
    collect(expression.root, buffers);
    return buffers;
}

pipeline::Result<Value> evaluate(const Expression& expression, const Frame& frame) {
    auto value = evaluate(expression.root, frame);
    if (!value) return value;
    for (const double part : value->numbers)
        if (!std::isfinite(part))
            return error(expression.root, expression.text + " is " + toText(number(part)), "a finite number");
    return value;
}

}  // namespace lessons
