#pragma once
#include <QObject>
#include <QTimer>
#include <map>
#include <set>
#include <vector>

#include "app/core/background_job.h"
#include "pipeline/steps/steps.h"

namespace app {

using StepsPtr = std::shared_ptr<const pipeline::Steps>;

// Where the window stands inside the frame: at its end, which is the frame as every view knows it, or at a moment
// before, when it shows the state there. Plays, keeps bookmarks, and computes off the GUI thread. The place is known
// by name, so that it holds while the scene changes.
class Stepper : public QObject {
    Q_OBJECT
public:
    using Level = pipeline::StepLevel;

    explicit Stepper(QObject* parent = nullptr);

    // The newest whole frame; null forgets all, bookmarks too.
    void setWhole(pipeline::FramePtr whole);
    // Of that frame or, until it is counted, of an earlier one; null before the first is.
    const StepsPtr& steps() const { return m_steps; }

    bool isInside() const { return m_place.has_value(); }
    const std::optional<pipeline::Place>& place() const { return m_place; }
    // Where the handle stands: the place among steps(); at the end of the stage on show where it is not inside. Nothing
    // before there are steps.
    std::optional<pipeline::Moment> moment() const;
    bool isSettled() const { return !m_job.busy(); }  // nothing is being computed
    void cancel() { m_job.forget(); }
    void resume() { request(); }
    QString words() const;  // "polygon 2, row 270, x 258"

    void goTo(const pipeline::Place& place);
    void goTo(pipeline::Moment moment);
    void leave();                            // the whole frame again, with the stage that is on show
    void setStage(pipeline::StageId stage);  // the stage on show, from whose end steps lead on and back
    void toLast();                           // likewise, with the last stage
    void step(int direction);                // 1 on, -1 back, by the level; from the end of a stage into it or the next
    bool canStep(int direction) const;
    void toFirst();

    Level level() const { return m_level; }
    void setLevel(Level level);
    bool isPlaying() const { return m_timer.isActive(); }
    void setPlaying(bool playing);
    // Play ends at the earliest of these moments that lies ahead, and stopped() tells whose it is. Nothing takes it away.
    void setStop(const QObject* who, std::optional<pipeline::Moment> moment);
    // Play waits where it is, while `who` looks for its stop.
    void setHeld(const QObject* who, bool held);
    // The stage's algorithm is shown beside the step: in the clean view, and in the window as a panel.
    bool showsAlgorithm() const { return m_showsAlgorithm; }
    void setShowsAlgorithm(bool shows);
    double speed() const { return m_speed; }  // 0.25 to 16
    void setSpeed(double speed);

    // In the order of the frame.
    const std::vector<pipeline::Place>& bookmarks() const { return m_bookmarks; }
    // The bookmark here, if there is one: its place in that order, else -1.
    int bookmarkHere() const;
    void toggleBookmark();
    void removeBookmark(std::size_t i);
    void setBookmarks(std::vector<pipeline::Place> bookmarks);  // in the order of the frame

signals:
    void busyChanged(bool busy);
    void changed();                               // anything of the above
    void shown(const pipeline::FramePtr& frame);  // the state at the place
    void left();                                  // the whole frame is to be shown again
    void stageReached(pipeline::StageId stage);
    void stopped(const QObject* who);  // by its setStop

private:
    void request();
    struct Answer {
        StepsPtr steps;            // of the whole frame that was asked about
        pipeline::FramePtr shown;  // its state at the place; null where it is shown whole
    };
    void take(const Answer& answer);
    void tick();

    pipeline::FramePtr m_whole;
    StepsPtr m_steps;
    std::optional<pipeline::Place> m_place;
    pipeline::StageId m_stage = pipeline::StageId::Shading;
    Level m_level = Level::Polygon;
    bool m_showsAlgorithm = false;
    double m_speed = 1, m_due = 0;  // steps that are due while it plays
    std::vector<pipeline::Place> m_bookmarks;
    std::map<const QObject*, pipeline::Moment> m_stops;
    std::set<const QObject*> m_held;
    QTimer m_timer;       // plays
    QTimer m_count;       // counts the steps of a frame once no other follows at once
    int m_waiting = 0;    // steps asked for before they were counted
    StepsPtr m_counted;   // of the newest frame; the job's thread alone
    BackgroundJob m_job;  // last: it ends before what its work looks at
};

}  // namespace app
