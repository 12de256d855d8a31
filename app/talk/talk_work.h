#pragma once
#include <QFrame>
#include <QTimer>

namespace app {

class SceneOpener;
class WorkList;

// Over a talk: the scene that is being read, and what takes long, each with a button to cancel. Hidden without work.
class TalkWork : public QFrame {
    Q_OBJECT
public:
    TalkWork(WorkList& work, const SceneOpener& opener, QWidget* parent);

    bool stopReading();  // false where no scene is being read
    bool stopRunning();  // false where nothing else runs
    // Work was on show until a moment ago: a key that was meant to stop it is not meant for the talk.
    bool hasJustEnded() const { return m_endTime.isActive(); }

signals:
    void cancelAsked();  // of the scene that is being read
    void changed();      // its size, or whether it is shown

private:
    void showWork();

    WorkList& m_work;
    const SceneOpener& m_opener;
    QTimer m_endTime;
    bool m_works = false;
};

}  // namespace app
