#pragma once
#include <QObject>
#include <map>
#include <memory>
#include <optional>

#include "app/frames/frame_check.h"
#include "app/frames/frame_pacing.h"
#include "app/frames/scene_step.h"
#include "pipeline/run/frame.h"

namespace app {

class FrameWorker;
class Stepper;
class WorkList;

// The frames of the scene on show. Views say which buffers they want; the FrameWorker computes them, and the newest
// finished frame is shown. Inside a frame the stepper gives the frame so far. Lives in the GUI thread.
class FrameFeed : public QObject {
    Q_OBJECT
public:
    FrameFeed(Stepper& stepper, WorkList& work, QObject* parent = nullptr);
    ~FrameFeed() override;

    // The newest finished frame; null before the first. It may be of an earlier state of the scene while a slider
    // moves; shown()->scene() is the state that it shows. While the user steps inside a frame, it is the frame so far.
    const pipeline::FramePtr& shown() const { return m_shown; }
    // The frame with all its stages, wherever the stepper is.
    const pipeline::FramePtr& whole() const { return m_whole; }
    bool busy() const { return m_busy; }                   // a frame is being computed
    bool isMoving() const { return m_pacing.isMoving(); }  // a slider or a handle is being dragged
    // One for each stage, computed in idle time after each frame; empty before.
    const StageErrors& errors() const { return m_check.errors; }
    // The number of NaN values in the frame's buffers; known together with the errors.
    std::optional<std::size_t> nanCount() const { return m_checked ? std::optional(m_check.nan) : std::nullopt; }

    // The buffers that `who` shows; buffers that nobody wants are not computed. Forgotten when `who` is deleted.
    // AtRest: not while a slider or a handle moves.
    enum class When { Always, AtRest };
    void want(const QObject* who, pipeline::BufferSet buffers, When when = When::Always);
    // `who`, which wants buffers, has not begun to draw the newest frame. While the scene moves, the next frame waits
    // for it, but not longer than 1/60 s: the other views go on, and `who` skips frames.
    void hold(const QObject* who, bool holds);

    void reset(ScenePtr scene);     // another scene: there is no frame, and none of the old scene comes
    void setScene(ScenePtr scene);  // a new state of the same scene
    void setLive(bool live);        // true with each step of a drag, false at its end
    void requestSoon();

signals:
    void frameReady();   // shown()
    void errorsReady();  // errors() and nanCount() belong to whole()
    void stateReady();   // the first whole frame of a state of the scene
    void busyChanged(bool busy);
    void outOfMemory();  // no new frame; shown() stays until something changes

private:
    void observeWork();
    void show(const pipeline::FramePtr& frame);
    void request();
    void cancel();
    void take(pipeline::FramePtr frame, long ticket);
    void takeFailure(long ticket);
    void takeCheck(const pipeline::FramePtr& frame, const FrameCheck& check);
    void forgetCheck();
    void setBusy(bool busy);
    pipeline::BufferSet wanted() const;

    Stepper& m_stepper;
    WorkList& m_work;
    FramePacing m_pacing;
    ScenePtr m_scene;
    pipeline::FramePtr m_shown, m_whole;
    FrameCheck m_check;
    bool m_checked = false;
    struct Want {
        pipeline::BufferSet buffers;
        When when = When::Always;
    };
    std::map<const QObject*, Want> m_wants;
    struct Tickets {
        long newest = 0, taken = 0;  // of the newest request; of m_whole
        long oldestValid = 0;        // older tickets belong to a closed scene or were cancelled
        bool computes() const { return newest > taken; }
    };
    Tickets m_tickets;
    struct Request {
        ScenePtr scene;
        pipeline::BufferSet buffers;
    };
    Request m_requested;
    bool m_pending = false;  // request() runs when control returns to the event loop
    bool m_busy = false;
    std::unique_ptr<FrameWorker> m_worker;  // last: it calls the rest
};

}  // namespace app
