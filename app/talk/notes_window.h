#pragma once
#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

#include "app/jobs/background_job.h"
#include "app/talk/cue_model.h"

class QLabel;
class QListView;

namespace app {

// The lecturer's window: the audience's picture, the next cue's picture, the notes, the cues, elapsed and planned time,
// and the clock.
class NotesWindow : public QWidget {
    Q_OBJECT
public:
    // audience: what the others see; grabbed now and then.
    NotesWindow(CueModel& cues, QWidget& audience);

    QString place() const;  // "cue 6 of 9"
    QString timer() const;  // "23:41" since it was opened
    QString notes() const;
    bool hasNextPicture() const { return m_hasNext; }

signals:
    void asked(int cue);
    void left();

protected:
    void resizeEvent(QResizeEvent* event) override;
    void closeEvent(QCloseEvent* event) override;

private:
    QWidget* makePictures();
    QWidget* makeRight();
    QWidget* makeFoot();
    void showCue();
    void showNote();
    QString votesText() const;
    void showTime();
    void showAudience();
    void computeNext();
    void applyTheme();

    CueModel& m_cues;
    QWidget& m_audience;
    QLabel *m_nowTitle, *m_now, *m_nextTitle, *m_next;
    QLabel *m_notesTitle, *m_notes, *m_timer, *m_left, *m_clock, *m_keys;
    QListView* m_list;
    QElapsedTimer m_since;
    QTimer m_second, m_grab;
    QImage m_nextImage;
    bool m_hasNext = false;
    BackgroundJob m_job;
};

}  // namespace app
