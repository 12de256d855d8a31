#pragma once
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "pipeline/core/stop.h"
#include "pipeline/run/frame.h"
#include "pipeline/steps/drawing.h"
#include "pipeline/steps/moment.h"

namespace pipeline {

// A sequence of elements of one kind that a stage works through. Smallest steps are counted within the phase.
struct StepPhase {
    ElementKind kind = ElementKind::Polygon;
    int light = -1;                         // of a shadow buffer
    std::int64_t first = 0;                 // smallest steps of the stage before this phase
    std::size_t count = 0;                  // elements
    std::vector<std::uint32_t> numbers{};   // of the elements; empty: 0, 1, 2…
    std::vector<std::uint32_t> polygons{};  // of the elements, if their numbers are not polygons
    std::vector<std::int64_t> ends{};       // smallest steps of the first i + 1 elements; empty: one step each
    std::vector<std::int64_t> rows{};       // rows of the first i + 1 elements; empty if the phase has no rows

    std::uint32_t number(std::size_t i) const { return numbers.empty() ? std::uint32_t(i) : numbers[i]; }
    std::int64_t end(std::size_t i) const { return ends.empty() ? std::int64_t(i) + 1 : ends[i]; }
    std::int64_t begin(std::size_t i) const { return i == 0 ? 0 : end(i - 1); }
    std::int64_t total() const { return count == 0 ? 0 : end(count - 1); }
};

// The steps of a frame's stages and its state between them, in the frame's precision.
struct Bindings;
struct StepSource {
    std::array<std::vector<StepPhase>, kStageCount> phases;
    std::array<bool, kStageCount> runs{};

    virtual ~StepSource() = default;
    // The pixels of an element, for a phase with rows.
    virtual std::vector<PixelSpan> spans(StageId stage, std::size_t element) const = 0;
    // Binds the names of the stage's algorithm for smallest step number `within` of an element of the phase.
    virtual void bind(StageId stage, const StepPhase& phase, std::size_t element, std::int64_t within,
                      Bindings& out) const = 0;
    virtual FramePtr at(Moment moment, int threads, Stop stop) const = 0;
};
std::shared_ptr<const StepSource> makeStepSource(FramePtr whole);

// The part of an element's pixels that its first `done` steps cover.
Reach reachOf(const std::vector<PixelSpan>& spans, std::int64_t done);

}  // namespace pipeline
