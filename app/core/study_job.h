#pragma once
#include <QString>

#include "app/core/thread_job.h"
#include "pipeline/core/result.h"
#include "pipeline/study/run_study.h"

namespace app {

// Measures a study on a thread of its own: the errors point by point, then the times. One job, one study.
class StudyJob : public ThreadJob {
    Q_OBJECT
public:
    explicit StudyJob(pipeline::StudyRequest request, QObject* parent = nullptr);

signals:
    // share: of all the work, 0 to 1. secondsLeft: below 0 while nothing is known.
    void progressed(double share, const QString& what, double secondsLeft);
    void reported(const pipeline::StudyReport& report);  // what is known so far
    void finished(bool cancelled);
};

}  // namespace app
