#pragma once
#include <QWidget>
#include <memory>

#include "app/document/document.h"
#include "app/study/study_job.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;
class QStackedWidget;

namespace app {

// A row with the planned measurement or the progress of the study, the button for the set-up, and the button that
// starts the study or stops it.
class StudyRun : public QWidget {
    Q_OBJECT
public:
    explicit StudyRun(Document& document, QWidget* parent = nullptr);

    // What is to be measured, or why nothing can be.
    void setSweep(pipeline::Result<pipeline::Sweep> sweep);
    void setAgain(bool again);         // a study is on show already
    QWidget& how() { return *m_how; }  // fields for the set-up: frames and threads
    bool running() const { return m_job != nullptr; }
    void begin();
    void cancel();

signals:
    void setUpAsked();
    void begun();
    void told(const QString& doing);                     // what is being measured; empty: nothing is
    void reported(const pipeline::StudyReport& report);  // after a first look at the times, and at the end

private:
    void finish(const QString& words);
    void showState();
    QString summary() const;

    Document& m_document;
    pipeline::Result<pipeline::Sweep> m_sweep;
    std::unique_ptr<StudyJob> m_job;
    bool m_anything = false;   // was reported
    bool m_leftScene = false;  // cancelled because another one was opened
    QWidget* m_how;
    QSpinBox *m_repeats, *m_threads;
    QString m_end;  // how the last study ended, until another one is chosen
    QLabel *m_summary, *m_left;
    QProgressBar* m_bar;
    QStackedWidget* m_one;  // begin or cancel, in one place
    QPushButton *m_begin, *m_cancel;
};

}  // namespace app
