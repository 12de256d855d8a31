#pragma once
#include <QObject>
#include <QTimer>
#include <map>
#include <set>
#include <vector>

#include "app/jobs/background_job.h"
#include "pipeline/steps/steps.h"

namespace app {

using StepsPtr = std::shared_ptr<const pipeline::Steps>;

// The window's place inside the frame: at its end, where every view shows the whole frame, or at an earlier moment.
// Plays, keeps bookmarks, and computes off the GUI thread. The place has a name, so it stays valid while the scene
// changes.
class Stepper : public QObject {
    Q_OBJECT
public:
    using Level = pipeline::StepLevel;

    explicit Stepper(QObject* parent = nullptr);

    // The newest whole frame; null clears everything, bookmarks too.
    void setWhole(pipeline::FramePtr whole);
    // The steps of that frame or, until they are counted, of an earlier one; null before the first.
    const StepsPtr& steps() const { return m_steps; }

    bool isInside() const { return m_place.has_value(); }
    const std::optional<pipeline::Place>& place() const { return m_place; }
    // The place of the handle in steps(). If the window is not inside a stage, the end of the current stage. Empty
    // before there are steps.
    std::optional<pipeline::Moment> moment() const;
    bool isSettled() const { return !m_job.busy(); }  // nothing is being computed
    void cancel() { m_job.forget(); }
    void resume() { request(); }
    // Whether the place is in a stage that this frame leaves out: the moment is the end of the stage before it.
    bool isLeftOut() const;
    QString words() const;  // "polygon 2, row 270, x 258"; "Shadow buffer, left out"

    void goTo(const pipeline::Place& place);
    void goTo(pipeline::Moment moment);
    void leave();                            // shows the whole frame again, at the current stage
    void setStage(pipeline::StageId stage);  // the current stage; steps go forth and back from its end
    void toLast();                           // shows the whole frame at the last stage
    void step(int direction);                // 1 forth, -1 back; from a stage's end into it or the next
    bool canStep(int direction) const;
    void toFirst();

    Level level() const { return m_level; }
    void setLevel(Level level);
    bool isPlaying() const { return m_timer.isActive(); }
    void setPlaying(bool playing);
    // Play ends at the earliest of these moments that is ahead; stopped() tells whose it is. An empty moment removes
    // the stop.
    void setStop(const QObject* who, std::optional<pipeline::Moment> moment);
    // Play pauses while `who` looks for its stop.
    void setHeld(const QObject* who, bool held);
    // Whether the stage's algorithm is shown beside the step, in the clean view and as a panel.
    bool showsAlgorithm() const { return m_showsAlgorithm; }
    void setShowsAlgorithm(bool shows);
    double speed() const { return m_speed; }  // 0.25 to 16
    void setSpeed(double speed);

    // In the order of the frame.
    const std::vector<pipeline::Place>& bookmarks() const { return m_bookmarks; }
    // Index of the bookmark at this place, or -1.
    int bookmarkHere() const;
    void toggleBookmark();
    void setBookmarks(std::vector<pipeline::Place> bookmarks);  // in the order of the frame

signals:
    void busyChanged(bool busy);
    void changed();                               // any of the above
    void shown(const pipeline::FramePtr& frame);  // the state at the place
    void left();                                  // the whole frame has to be shown again
    void stageReached(pipeline::StageId stage);
    void stopped(const QObject* who);  // reached the stop of `who`

private:
    void request();
    struct Answer {
        StepsPtr steps;            // of the requested frame
        pipeline::FramePtr shown;  // its state at the place; null if it is shown whole
    };
    void take(const Answer& answer);
    void tick();

    pipeline::FramePtr m_whole;
    StepsPtr m_steps;
    std::optional<pipeline::Place> m_place;
    pipeline::StageId m_stage = pipeline::StageId::Shading;
    Level m_level = Level::Polygon;
    bool m_showsAlgorithm = false;
    double m_speed = 1, m_due = 0;  // due: steps to do while playing
    std::vector<pipeline::Place> m_bookmarks;
    std::map<const QObject*, pipeline::Moment> m_stops;
    std::set<const QObject*> m_held;
    QTimer m_timer;       // for playing
    QTimer m_count;       // counts the steps of a frame if no other frame follows soon
    int m_waiting = 0;    // steps requested before they were counted
    StepsPtr m_counted;   // of the newest frame; used by the job's thread only
    BackgroundJob m_job;  // last: it ends before the members that its work uses
};

// Whether the place is before the end of the z-buffer stage, so that more may be drawn.
bool isStillDrawing(const Stepper& stepper);

}  // namespace app
