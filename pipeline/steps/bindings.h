#pragma once
#include <map>

#include "pipeline/inspect/formula_parts.h"
#include "pipeline/inspect/pixel_report.h"
#include "pipeline/steps/algorithm.h"
#include "pipeline/steps/drawing.h"
#include "pipeline/steps/step_source.h"

namespace pipeline {

// The values of the names in a text, for one step.
struct Bindings {
    std::vector<AlgorithmValue> values;
    std::map<std::string, bool, std::less<>> tests;
    std::map<std::string, std::vector<Bindings>, std::less<>> loops;  // of loops inside the step: one for each turn
    std::array<bool, 4> begins{true, false, false, false};            // indexed by Begins

    AlgorithmValue& word(std::string name, std::string text, std::string from = {}) {
        return values.emplace_back(AlgorithmValue{name, name, std::move(text), {}, std::move(from)});
    }
    AlgorithmValue& whole(std::string name, std::int64_t value, std::string from = {}) {
        return values.emplace_back(AlgorithmValue{name, name, std::to_string(value), {double(value)}, std::move(from)});
    }
    AlgorithmValue& number(std::string name, double value, int decimals = 4, std::string from = {}) {
        return values.emplace_back(AlgorithmValue{name, name, fixed(value, decimals), {value}, std::move(from)});
    }
    AlgorithmValue& depth(std::string name, double value, std::string from = {}) {
        return values.emplace_back(AlgorithmValue{name, name, depthText(value), {value}, std::move(from)});
    }
    AlgorithmValue& vector(std::string name, Vec3d v, int decimals = 4, std::string from = {}) {
        return values.emplace_back(
            AlgorithmValue{name,
                           name,
                           fmt::format("{}, {}, {}", fixed(v.x, decimals), fixed(v.y, decimals), fixed(v.z, decimals)),
                           {v.x, v.y, v.z},
                           std::move(from)});
    }
};

// The step to bind: number `within` of an element.
struct BoundStep {
    const StepPhase* phase;
    std::size_t element;
    std::int64_t within;
    std::uint32_t number() const { return phase->number(element); }
};
// Binds the pixel of a step, from the spans of its element: "x, y", and the loops that start with it.
glm::ivec2 bindPixel(const std::vector<PixelSpan>& spans, std::int64_t within, Bindings& out);
// Binds a loop over the elements of a phase: "polygon", 2 of 5.
void bindElement(const BoundStep& step, std::string name, Bindings& out);

template <class Real>
void bindDrawing(const FrameData<Real>& data, const Drawing<Real>& drawing, const BoundStep& step, Bindings& out);

template <class Real>
void bindGeometry(const Frame& frame, const FrameData<Real>& data, StageId stage, const BoundStep& step, Bindings& out);
// spans: the element's, if the phase goes by pixels.
template <class Real>
void bindShading(const Frame& frame, const FrameData<Real>& data, const std::vector<PixelSpan>& spans,
                 const BoundStep& step, Bindings& out);

// Goes through the lines of a text with the bindings of a step.
Walk walkThrough(Algorithm algorithm, const Bindings& bindings);

}  // namespace pipeline
