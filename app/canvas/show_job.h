#pragma once
#include <memory>
#include <optional>

#include "app/canvas/overlays.h"
#include "app/canvas/shown_buffer.h"
#include "app/frames/other_source.h"
#include "app/jobs/background_job.h"
#include "app/look/window_look.h"
#include "lessons/expression/condition.h"
#include "pipeline/compare/verdict.h"
#include "pipeline/study/shadow_verdict.h"

namespace app {

// B of a comparison.
struct OtherRequest {
    OtherSource source;
    pipeline::FramePtr frame;  // that has B; of a file, the frame of A
    pipeline::AnyBuffer buffer;
};

// What a view is to show of a frame, as values.
struct ShowRequest {
    pipeline::FramePtr frame;
    pipeline::AnyBuffer buffer;                // of the frame, or derived from it
    std::optional<pipeline::AnyBuffer> mix{};  // in its place, with its range
    lessons::ShownChannel channel = lessons::ShownChannel::All;
    std::optional<pipeline::PaletteRange> range{};  // nothing: one that shows all
    OverlaySet overlays{};
    std::shared_ptr<const pipeline::ShadowVerdicts> hatches{};  // of a buffer that is a map of them
    std::shared_ptr<const pipeline::ShadowVerdicts> shadows{};  // laid over it
    std::shared_ptr<const lessons::ConditionMask> veil{};       // likewise
    std::shared_ptr<const std::vector<bool>> drawn{};  // of a difference: which elements hold something; empty: all
    std::optional<OtherRequest> other{};
    std::shared_ptr<const ElementCounts> counts{};            // of a moment ago; nothing: counted
    std::shared_ptr<const pipeline::foreign::Report> mine{};  // for what is laid over of somebody else's renderer
    WindowLook look{};
};
bool operator==(const ShowRequest& a, const ShowRequest& b);

// On any thread. Incomplete when it is stopped.
ShownBuffer show(const ShowRequest& request, const std::stop_token& stop = {});

struct ShownOther {
    pipeline::AnyBuffer buffer;        // or its luminance, beside a luminance
    std::string whyNotComparable;      // empty where it is
    std::optional<ShownBuffer> shown;  // where one may look from one to the other
    std::vector<bool> drawnA, drawnB;  // as a comparison takes them
};

struct ShowAnswer {
    ShowRequest request;
    ShownBuffer shown;
    std::optional<ShownOther> other;
};

// Computes what a view shows, in the background if the frame is large. The last result is kept: repeating a request
// costs nothing.
class ShowJob : public QObject {
    Q_OBJECT
public:
    explicit ShowJob(QObject* parent = nullptr);

    // The result at once for a small frame. Otherwise the latest result or null, and ready() follows.
    std::shared_ptr<const ShowAnswer> answer(const ShowRequest& request);
    bool busy() const { return m_job.busy(); }
    void cancel() { m_job.forget(); }  // the answer before stays, also where the same is asked again
    void retry() { m_asked.reset(); }
    void forget();

signals:
    void ready();
    void busyChanged(bool busy);

private:
    std::optional<ShowRequest> m_asked;  // the newest
    std::shared_ptr<const ShowAnswer> m_answer;
    BackgroundJob m_job;
};

}  // namespace app
