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

// Every moment of a whole frame, and every buffer's state there. Immutable: any thread may ask. A moment's state is
// computed when asked for, from the outputs of the stages before it, so that stepping back gives the same bits.
class Steps {
public:
    // whole: a frame with all its stages. Counts what they do; takes about as long as the z-buffer stage.
    explicit Steps(FramePtr whole);

    const FramePtr& frame() const { return m_frame; }
    bool runs(StageId stage) const;           // false: left out, and no moment lies in it
    std::int64_t total(StageId stage) const;  // of its smallest steps; may be 0 although it runs
    Moment first() const { return {StageId::Transform, 0}; }
    Moment last() const { return {StageId::Shading, total(StageId::Shading)}; }
    // The nearest moment of this frame: within the stage's steps, or at the end of the stage before where it is left out.
    Moment fitting(Moment moment) const;

    // The end of the next step, and of the one before; nothing at the last and the first moment. From a moment that
    // is the end of a step, back is the inverse of forth.
    std::optional<Moment> next(Moment moment, StepLevel level) const;
    std::optional<Moment> previous(Moment moment, StepLevel level) const;

    // The stage's algorithm with the line that the moment is at and the values that it has there; between two steps the
    // last line of the one before. Nothing where no text is for the stage. Every value comes from the stage's own outputs.
    std::optional<AlgorithmState> algorithmAt(Moment moment) const;
    // Of each stage the texts that this frame goes through, in order; of a stage that is left out, or has nothing to do,
    // the one that it would.
    std::vector<Algorithm> algorithms() const;
    // Where a text's first step begins; nothing where it has none.
    std::optional<Moment> beginOf(const Algorithm& algorithm) const;

    // Steps of a level in a stage, and how many of them are over. How many lines a step has is known when it is reached:
    // of lines the count is that of pixels.
    std::int64_t count(StageId stage, StepLevel level) const;
    std::int64_t made(Moment moment, StepLevel level) const;
    // Where they end, in smallest steps, ascending; nothing where there are more than atMost.
    std::vector<std::int64_t> ends(StageId stage, StepLevel level, std::int64_t atMost) const;

    Place placeOf(Moment moment) const;  // momentOf gives the moment back
    Moment momentOf(const Place& place) const;
    // Whether this frame comes to the place. Else momentOf gives the moment at which that would have been over.
    bool comesTo(const Place& place) const;

    // The pixel that was drawn or shaded last, or at a line the one that is now, where the stage goes by pixels.
    std::optional<glm::ivec2> pixelOf(Moment moment) const;
    // Likewise, of each smallest step from there to the end of the polygon or piece that it lies in, in order.
    std::vector<glm::ivec2> pixelsToCome(Moment moment) const;
    // The polygon that the stage was last at, over all objects; nothing where it was at none.
    std::optional<std::uint32_t> polygonOf(Moment moment) const;

    // The end of the next smallest step that draws into a pixel or shades it; that is at a polygon, a vertex, or an
    // object. Nothing where none comes.
    std::optional<Moment> nextAt(Moment moment, glm::ivec2 pixel) const;
    enum class Thing : std::uint8_t { Object, Polygon, Vertex };
    std::optional<Moment> nextAt(Moment moment, Thing thing, std::uint32_t number) const;

    // Per polygon, over all objects: 1 where the stage (of shading what it is at) is done with it, in the transform
    // stage with all its vertices.
    std::vector<std::uint8_t> polygonsDone(Moment moment) const;

    // What has been done of what the stage is at: "2 233 of 5 372 fragments" in parts, the unit in the plural.
    struct Progress {
        std::int64_t done = 0, of = 0;
        std::string unit;
    };
    Progress progress(Moment moment) const;
    // "polygon 2, row 270, x 258": the step that has been made last, as far down as `level` goes, or farther where the
    // moment lies inside such a step.
    std::string words(Moment moment, StepLevel level) const;

    // Every buffer's state. Later stages have not run. At last() its buffers equal the frame's.
    // Null when stopped.
    FramePtr frameAt(Moment moment, int threads = 0, Stop stop = {}) const;

private:
    struct Spot {  // an element
        StageId stage;
        const StepPhase* phase;
        std::size_t element;
    };
    struct Found {
        Moment moment;
        bool isThere;  // as the place says
    };
    Found find(const Place& place) const;      // without its line
    Found findLine(const Place& place) const;  // with it
    const std::vector<StepPhase>& phases(StageId stage) const;
    // The end of the first step after `moment` that endIn(spot, steps of the element already over) gives, in steps of
    // the element; it gives 0 where the element has none.
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
    Place placeOfStep(StageId stage, std::int64_t tick) const;  // as far down as it goes

    FramePtr m_frame;
    std::shared_ptr<const StepSource> m_source;
    // The step that was walked through last: its lines are asked for one after the other.
    mutable std::mutex m_walkMutex;
    mutable Moment m_walked{};
    mutable std::shared_ptr<const Walk> m_walk;
};

}  // namespace pipeline
