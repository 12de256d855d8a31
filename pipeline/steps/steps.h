#pragma once
#include <memory>
#include <mutex>
#include <vector>

#include "pipeline/core/stop.h"
#include "pipeline/run/frame.h"
#include "pipeline/steps/algorithm.h"
#include "pipeline/steps/moment.h"

namespace pipeline {

struct StepSource;  // what is drawn and shaded at which step; pipeline/steps/step_source.h
struct StepPhase;

// All moments of a whole frame, and the buffers at each of them. Immutable: any thread may ask. The state at a moment
// is computed on request from the outputs of the stages before it, so stepping back gives the same bits.
class Steps {
public:
    // whole: a frame with all its stages. Counts their steps, which takes about as long as the z-buffer stage.
    explicit Steps(FramePtr whole);

    const FramePtr& frame() const { return m_frame; }
    bool runs(StageId stage) const;           // false: left out, so no moment is in it
    std::int64_t total(StageId stage) const;  // number of its smallest steps; may be 0 although the stage runs
    Moment first() const { return {StageId::Transform, 0}; }
    Moment last() const { return {StageId::Shading, total(StageId::Shading)}; }
    // The nearest moment of this frame: within the stage's steps, or at the end of the previous stage if it is left
    // out.
    Moment fitting(Moment moment) const;

    // The end of the next step, and of the previous one. Empty at the last and the first moment. From the end of a
    // step, previous() is the inverse of next().
    std::optional<Moment> next(Moment moment, StepLevel level) const;
    std::optional<Moment> previous(Moment moment, StepLevel level) const;

    // The stage's algorithm with the current line and its values; between two steps the last line of the previous step.
    // Empty if the stage has no text. All values come from the stage's own outputs.
    std::optional<AlgorithmState> algorithmAt(Moment moment) const;
    // The texts of each stage in this frame, in order. If a stage is left out or has nothing to do, the text that it
    // would use.
    std::vector<Algorithm> algorithms() const;
    // The beginning of a text's first step; empty if it has none.
    std::optional<Moment> beginOf(const Algorithm& algorithm) const;

    // The number of steps of a level in a stage, and how many of them are over. The number of lines in a step is known
    // only when it is reached, so for lines both count pixels.
    std::int64_t count(StageId stage, StepLevel level) const;
    std::int64_t made(Moment moment, StepLevel level) const;
    // Their ends in smallest steps, ascending; empty if there are more than atMost.
    std::vector<std::int64_t> ends(StageId stage, StepLevel level, std::int64_t atMost) const;

    Place placeOf(Moment moment) const;  // the inverse of momentOf
    Moment momentOf(const Place& place) const;
    // Whether this frame reaches the place. If not, momentOf gives the moment at which it would have been over.
    bool comesTo(const Place& place) const;

    // The pixel that was drawn or shaded last, or the current one at a line. Empty if the stage does not go by pixels.
    std::optional<glm::ivec2> pixelOf(Moment moment) const;
    // The same for each smallest step from there to the end of the polygon or piece, in order.
    std::vector<glm::ivec2> pixelsToCome(Moment moment) const;
    // The polygon that the stage was last at, over all objects; empty if there is none.
    std::optional<std::uint32_t> polygonOf(Moment moment) const;

    // The end of the next smallest step that draws into or shades a pixel, or that is at a polygon, a vertex or an
    // object. Empty if there is none.
    std::optional<Moment> nextAt(Moment moment, glm::ivec2 pixel) const;
    enum class Thing : std::uint8_t { Object, Polygon, Vertex };
    std::optional<Moment> nextAt(Moment moment, Thing thing, std::uint32_t number) const;

    // For each polygon over all objects: 1 if the stage is done with it. In shading the current phase counts, in the
    // transform stage all vertices of the polygon.
    std::vector<std::uint8_t> polygonsDone(Moment moment) const;

    // The progress of the stage: "2 233 of 5 372 fragments" in parts, with the unit in the plural.
    struct Progress {
        std::int64_t done = 0, of = 0;
        std::string unit;
    };
    Progress progress(Moment moment) const;
    // "polygon 2, row 270, x 258": the last step that was done, down to `level`, or further if the moment is inside
    // such a step.
    std::string words(Moment moment, StepLevel level) const;

    // The state of every buffer. Later stages have not run. At last() its buffers equal the frame's. Null when stopped.
    FramePtr frameAt(Moment moment, int threads = 0, Stop stop = {}) const;

private:
    struct Spot {  // an element
        StageId stage;
        const StepPhase* phase;
        std::size_t element;
    };
    struct Found {
        Moment moment;
        bool isThere;  // exactly as the place says
    };
    Found find(const Place& place) const;      // without its line
    Found findLine(const Place& place) const;  // with it
    const std::vector<StepPhase>& phases(StageId stage) const;
    // The end of the first step after `moment` for which endIn(spot, number of its steps already over) is not 0. endIn
    // counts in steps of the element; 0 means that it has none.
    template <class EndIn>
    std::optional<Moment> search(Moment moment, EndIn endIn) const;
    Spot at(StageId stage, std::int64_t tick) const;  // the element that makes step number `tick`
    std::uint32_t objectOf(const Spot& spot) const;
    std::optional<std::uint32_t> polygonOf(const Spot& spot) const;
    std::vector<std::int64_t> rowEnds(const Spot& spot) const;
    std::int64_t end(StageId stage, std::int64_t tick, StepLevel level) const;
    std::int64_t begin(StageId stage, std::int64_t tick, StepLevel level) const;

    std::shared_ptr<const Walk> walk(StageId stage, std::int64_t tick) const;
    int lineCount(StageId stage, std::int64_t tick) const;
    std::optional<Moment> nextLine(Moment moment) const;
    std::optional<Moment> previousLine(Moment moment) const;
    Place placeOfStep(StageId stage, std::int64_t tick) const;  // as detailed as possible

    FramePtr m_frame;
    std::shared_ptr<const StepSource> m_source;
    // The step that was walked through last, because its lines are asked for in sequence.
    mutable std::mutex m_walkMutex;
    mutable Moment m_walked{};
    mutable std::shared_ptr<const Walk> m_walk;
};

}  // namespace pipeline
