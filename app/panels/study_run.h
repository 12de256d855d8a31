#pragma once
#include <QWidget>
#include <memory>

#include "app/core/document.h"
#include "app/core/study_job.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace app {

// How a study is measured, the button that begins it, and how far it is.
class StudyRun : public QWidget {
    Q_OBJECT
public:
    explicit StudyRun(Document& document, QWidget* parent = nullptr);

    // What is to be measured, or why nothing can be.
    void setSweep(pipeline::Result<pipeline::Sweep> sweep);
    bool running() const { return m_job != nullptr; }
    void begin();
    void cancel();

signals:
    void reported(const pipeline::StudyReport& report);  // after a first look at the times, and at the end

private:
    void finish(const QString& words);
    void showState();

    Document& m_document;
    pipeline::Result<pipeline::Sweep> m_sweep;
    std::unique_ptr<StudyJob> m_job;
    bool m_anything = false;   // was reported
    bool m_leftScene = false;  // cancelled because another one was opened
    QSpinBox *m_repeats, *m_threads;
    QLabel* m_words;
    QProgressBar* m_bar;
    QPushButton *m_begin, *m_cancel;
};

}  // namespace app
