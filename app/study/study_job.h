#pragma once
#include <QString>

#include "app/jobs/thread_job.h"
#include "pipeline/core/result.h"
#include "pipeline/study/run_study.h"

namespace app {

// Measures a study on a thread of its own: first all errors, then the times. One job, one study.
class StudyJob : public ThreadJob {
    Q_OBJECT
public:
    explicit StudyJob(pipeline::StudyRequest request, QObject* parent = nullptr);

signals:
    // share: of all work, 0 to 1. secondsLeft: negative while unknown.
    void progressed(double share, const QString& what, double secondsLeft);
    void reported(const pipeline::StudyReport& report);  // the results so far
    void finished(bool cancelled);
};

}  // namespace app
