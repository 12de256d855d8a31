#pragma once
#include <QObject>
#include <QString>
#include <thread>

#include "pipeline/core/result.h"
#include "pipeline/study/run_study.h"

namespace app {

// Measures a study on a thread of its own: the errors point by point, then the times. One job, one study.
class StudyJob : public QObject {
    Q_OBJECT
public:
    explicit StudyJob(pipeline::StudyRequest request, QObject* parent = nullptr);
    ~StudyJob() override;  // cancels what still runs, and waits

    void cancel() { m_thread.request_stop(); }

signals:
    // share: of all the work, 0 to 1. secondsLeft: below 0 while nothing is known.
    void progressed(double share, const QString& what, double secondsLeft);
    void reported(const pipeline::StudyReport& report);  // what is known so far
    void finished(bool cancelled);

private:
    std::jthread m_thread;
};

}  // namespace app
