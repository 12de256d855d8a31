#include "lessons/expression/function_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include <fmt/format.h>

#include "lessons/expression/changed_frames.h"
#include "lessons/expression/condition.h"
#include "lessons/expression/elements.h"
#include "lessons/expression/held_frame.h"
#include "pipeline/core/angles.h"
#include "pipeline/core/elementary.h"
#include "pipeline/core/text.h"
#include "pipeline/inspect/compare.h"
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

Result<Value> element(const Node& call, Operands operands, const Context& context) {
    const auto buffer = bufferOf(call, context.frame);
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

Result<Value> count(const Node& call, Operands, const Context& context) {
    const auto values = ElementValues::of(call.operands[0], context);
    if (!values) return values.errors();
    double holding = 0;
    const bool whole = goThrough(*values, values->count(), context.stop, [&](std::size_t, const auto& truths) {
        holding += std::accumulate(truths.begin(), truths.end(), 0.0);
    });
    if (!whole) return error(call, "stopped");
    return number(holding);
}

Result<Value> pixels(const Node& call, Operands, const Context& context) {
    const auto mask = maskOf(call.operands[0], context);
    if (!mask) return mask.errors();
    return number(double(mask->count));
}

// Where the best finite number of a buffer is, the first of equals; isBetter(a, b): a before b.
template <class IsBetter>
Result<std::pair<std::size_t, double>> best(const Node& call, const Frame& frame, IsBetter isBetter) {
    const auto buffer = bufferOf(call, frame);
    if (!buffer) return buffer.errors();
    const auto channels = std::size_t(buffer->channels());
    std::optional<std::pair<std::size_t, double>> found;
    const std::size_t step = call.channel ? channels : 1;
    for (std::size_t i = std::size_t(call.channel.value_or(0)); i < buffer->count(); i += step) {
        const double value = buffer->flat(i);
        if (std::isfinite(value) && (!found || isBetter(value, found->second))) found = {i / channels, value};
    }
    if (!found) return error(call, call.buffer->text() + " holds no finite number");
    return *found;
}

template <class IsBetter>
Result<Value> extreme(const Node& call, Operands, const Context& context) {
    const auto found = best(call, context.frame, IsBetter());
    if (!found) return found.errors();
    return number(found->second);
}

template <class IsBetter>
Result<Value> placeOfExtreme(const Node& call, Operands, const Context& context) {
    const auto found = best(call, context.frame, IsBetter());
    if (!found) return found.errors();
    const std::size_t columns = bufferOf(call, context.frame)->columns(), row = found->first / columns;
    return Value{{double(found->first % columns), double(row)}, {}};
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

Result<Value> pixel(const Node& call, Operands operands, const Context& context) {
    const auto report = reportAt(call, operands, context.frame);
    if (!report) return report.errors();
    if (call.word == "fragments") return number(double(report->fragments.size()));
    if (call.word == "culled") return number(double(report->culled.size()));
    if (call.word == "i_max") return number(report->iMax);
    if (!report->covered) return error(call, "nothing is drawn at this pixel", "a pixel that a polygon covers");
    if (call.word == "polygon") return number(report->polygon);
    if (call.word == "object") return number(report->object);
    return number(call.word == "depth" ? report->depth : report->zView);
}

Result<Value> fragment(const Node& call, Operands operands, const Context& context) {
    const auto report = reportAt(call, operands, context.frame);
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

Result<std::size_t> polygonFrom(const Node& call, Operands operands, const Frame& frame) {
    const pipeline::CullOutput* const cull = cullOf(frame);
    if (!cull) return error(call, "no verdicts in this frame: cull has not run");
    return indexFrom(call, operands[0], cull->verdicts.size());
}

Result<Value> signedArea(const Node& call, Operands operands, const Context& context) {
    const auto polygon = polygonFrom(call, operands, context.frame);
    if (!polygon) return polygon.errors();
    const auto area = pipeline::readStages(
        context.frame, [&](const auto& data) { return pipeline::signedArea(*data.transform, *data.cull, *polygon); });
    if (area) return number(*area);
    return error(call, fmt::format("polygon {} has no area in the picture: {}", *polygon,
                                   name(cullOf(context.frame)->verdicts[*polygon])));
}

Result<Value> verdict(const Node& call, Operands operands, const Context& context) {
    const auto polygon = polygonFrom(call, operands, context.frame);
    if (!polygon) return polygon.errors();
    return words(name(cullOf(context.frame)->verdicts[*polygon]));
}

Result<Value> setting(const Node& call, Operands, const Context& context) {
    const double value = call.setting->get(context.frame.scene());
    const auto choices = call.setting->setting->choices;
    return choices.empty() ? number(value) : words(choices[std::size_t(value)]);
}

// The frame of a call's changes.
Result<pipeline::FramePtr> changedFrame(const Node& call, const Context& context) {
    ChangedFrames own;
    auto frame =
        (context.changed ? *context.changed : own).frame(context.frame, call.changes, call.changed, context.stop);
    if (frame) return frame;
    Error first = frame.errors().front();
    first.where = call.where;
    return first;
}

Result<Value> with(const Node& call, Operands, const Context& context) {
    const auto frame = changedFrame(call, context);
    if (!frame) return frame.errors();
    // What is changed within is changed from this frame on: it has frames of its own.
    const HeldFrame held(**frame);
    return evaluate(Expression{{}, call.operands[0], {}, 0},
                    Context{.frame = **frame, .pick = context.pick, .stop = context.stop});
}

Result<Value> differing(const Node& call, Operands, const Context& context) {
    const auto before = bufferOf(call, context.frame);
    if (!before) return before.errors();
    const auto frame = changedFrame(call, context);
    if (!frame) return frame.errors();
    const auto after = bufferOf(call, **frame);
    if (!after) return after.errors();
    if (after->count() != before->count())
        return error(call, "the changes give " + call.buffer->text() + " another size");
    const auto channels = std::size_t(before->channels());
    double places = 0;
    for (std::size_t i = 0; i < before->count(); i += channels) {
        std::size_t c = 0;
        while (c < channels && before->flat(i + c) == after->flat(i + c)) ++c;
        places += c < channels;
    }
    return number(places);
}

// A buffer that only one of the two scenes has a use for differs.
Result<Value> firstDifference(const Node& call, Operands, const Context& context) {
    const auto changed = changedFrame(call, context);
    if (!changed) return changed.errors();
    const pipeline::Frame &a = context.frame, &b = **changed;
    for (const pipeline::BufferInfo& info : pipeline::bufferTable()) {  // in the order of the stages
        const std::size_t lights = std::max(a.scene().lights.size(), b.scene().lights.size());
        for (int light = info.perLight ? 0 : -1; light < (info.perLight ? int(lights) : 0); ++light) {
            const pipeline::BufferName buffer{info.id, light};
            const bool inA = a.buffer(buffer).has_value(), inB = b.buffer(buffer).has_value();
            if (!inA && !inB) continue;
            if (context.stop.stop_requested()) return error(call, "stopped");
            if (inA && inB)
                if (const auto found = stageDifference(a, b, buffer); found.why.empty() && found.differing == 0)
                    continue;
            return words(pipeline::stageInfo(info.stage).name);
        }
    }
    return words("none");
}

template <double (*function)(double)>
void of(Operands a, Operands, std::span<double> result) {
    result[0] = function(a[0]);
}
double dot(Operands a, Operands b) { return std::inner_product(a.begin(), a.end(), b.begin(), 0.0); }
double degrees(double radians) { return radians * (180 / std::numbers::pi); }

using T = Takes;
constexpr auto kFunctions =
    std::to_array<Function>(
        {
            {"buffer", T::Element, "The value of a buffer at a pixel, a vertex or a polygon.", nullptr, element},
            {"pixel", T::PixelField, "The inspector's report on a pixel.", nullptr, pixel},
            {"fragment", T::FragmentField, "The record of one fragment of a pixel.", nullptr, fragment},
            {"count", T::ElementCondition,
             "The number of elements of a buffer (pixels, vertices, polygons) that meet a condition.", nullptr, count},
            {"pixels", T::PixelCondition, "The number of drawn pixels that meet a condition.", nullptr, pixels},
            {"smallest", T::Buffer, "The smallest finite number of a buffer.", nullptr, extreme<std::less<>>},
            {"largest", T::Buffer, "The largest finite number of a buffer.", nullptr, extreme<std::greater<>>},
            {"at_smallest", T::Buffer, "Column and row of the first smallest number of a buffer.", nullptr,
             placeOfExtreme<std::less<>>, Type::Vector},
            {"at_largest", T::Buffer, "Column and row of the first largest number of a buffer.", nullptr,
             placeOfExtreme<std::greater<>>, Type::Vector},
            {"signed_area", T::Polygon,
             "The area of a polygon in the picture, px²; below 0 when it is seen from behind.", nullptr, signedArea},
            {"verdict", T::Polygon, "The cull stage's verdict on a polygon, in words.", nullptr, verdict, Type::Words},
            {"setting", T::Setting, "The value of a setting of the scene; for a choice or a switch its word.", nullptr,
             setting},
            {"why", T::Stage, "Why the plan runs, reuses or leaves out a stage, in words.", nullptr,
             [](const Node& call, Operands, const Context& context) -> Result<Value> {
                 return words(context.frame.plan()[index(*call.stage)].why);
             },
             Type::Words},
            {"with", T::Changes, "The value in the same scene with settings changed.", nullptr, with},
            {"differing", T::BufferChanges, "The number of elements in which a buffer differs with settings changed.",
             nullptr, differing},
            {"first_difference", T::AllChanges, "The first stage whose output differs with settings changed, or none.",
             nullptr, firstDifference, Type::Words},
            {"if", T::Choice, "The second value where the condition holds, else the third."},
            {"floor", T::Number, "The largest integer that is not above it.", of<std::floor>},
            {"ceil", T::Number, "The smallest integer that is not below it.", of<std::ceil>},
            {"round", T::Number, "The nearest integer, halves away from 0.", of<std::round>},
            {"abs", T::Number, "The absolute value.", of<std::abs>},
            {"sqrt", T::Number, "Square root.", of<std::sqrt>},
            {"exp", T::Number, "e to this power.", of<pipeline::exp>},
            {"log", T::Number, "Natural logarithm.", of<pipeline::log>},
            {"sin", T::Number, "Sine of an angle in degrees.", of<pipeline::sinDegrees>},
            {"cos", T::Number, "Cosine of an angle in degrees.", of<pipeline::cosDegrees>},
            {"tan", T::Number, "Tangent of an angle in degrees.",
             [](Operands a, Operands, std::span<double> r) {
                 r[0] = pipeline::sinDegrees(a[0]) / pipeline::cosDegrees(a[0]);
             }},
            {"asin", T::Number, "The angle from -90 to 90 with this sine, degrees.",
             [](Operands a, Operands, std::span<double> r) {
                 r[0] = degrees(pipeline::atan2(a[0], std::sqrt((1 - a[0]) * (1 + a[0]))));
             }},
            {"acos", T::Number, "The angle from 0 to 180 with this cosine, degrees.",
             [](Operands a, Operands, std::span<double> r) { r[0] = degrees(pipeline::acos(a[0])); }},
            {"atan2", T::TwoNumbers, "The angle from -180 to 180 of the point with this y and x, degrees.",
             [](Operands a, Operands b, std::span<double> r) { r[0] = degrees(pipeline::atan2(a[0], b[0])); }},
            {"mod", T::TwoNumbers, "The remainder of the first by the second, with the sign of the second.",
             [](Operands a, Operands b, std::span<double> r) { r[0] = a[0] - b[0] * std::floor(a[0] / b[0]); }},
            {"min", T::TwoNumbers, "The smaller of two.",
             [](Operands a, Operands b, std::span<double> r) { r[0] = std::min(a[0], b[0]); }},
            {"max", T::TwoNumbers, "The larger of two.",
             [](Operands a, Operands b, std::span<double> r) { r[0] = std::max(a[0], b[0]); }},
            {"length", T::Vector, "The length of a vector.",
             [](Operands a, Operands, std::span<double> r) { r[0] = std::sqrt(dot(a, a)); }},
            {"unit", T::Vector, "The vector of length 1 in the same direction.",
             [](Operands a, Operands, std::span<double> r) {
                 for (std::size_t i = 0; i < r.size(); ++i) r[i] = a[i] / std::sqrt(dot(a, a));
             },
             nullptr, Type::Vector},
            {"dot", T::TwoVectors, "The dot product of two vectors.",
             [](Operands a, Operands b, std::span<double> r) { r[0] = dot(a, b); }},
            {"cross", T::TwoVectors, "The cross product of two vectors.",
             [](Operands a, Operands b, std::span<double> r) {
                 for (std::size_t i = 0; i < 3; ++i)
                     r[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
             },
             nullptr, Type::Vector},
        });

}  // namespace

std::span<const Function> functionTable() { return kFunctions; }

std::span<const std::string_view> fieldsOf(Takes takes) {
    if (takes == Takes::PixelField) return kPixelFields;
    if (takes == Takes::FragmentField) return kFragmentFields;
    return {};
}

std::string_view callText(Takes takes) {
    switch (takes) {
        case Takes::Number: return "(number)";
        case Takes::TwoNumbers: return "(number, number)";
        case Takes::Vector: return "(vector)";
        case Takes::TwoVectors: return "(vector, vector)";
        case Takes::Choice: return "(condition, value, value)";
        case Takes::Buffer: return "(BUFFER, channel)";
        case Takes::Element: return "(BUFFER, place, channel)";
        case Takes::ElementCondition: return "(BUFFER > number)";
        case Takes::PixelCondition: return "(condition)";
        case Takes::PixelField: return "(x, y).FIELD";
        case Takes::FragmentField: return "(x, y, i).FIELD";
        case Takes::Polygon: return "(polygon)";
        case Takes::Setting: return "(KEY)";
        case Takes::Stage: return "(STAGE)";
        case Takes::Changes: return "(KEY=VALUE, …; value)";
        case Takes::BufferChanges: return "(BUFFER; KEY=VALUE, …)";
        case Takes::AllChanges: return "(KEY=VALUE, …)";
    }
    return "";
}

}  // namespace lessons
