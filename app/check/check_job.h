#pragma once
#include "app/jobs/thread_job.h"
#include "pipeline/check/case.h"

namespace app {

// Runs cases of the catalogue on threads of its own. One job, one run.
class CheckJob : public ThreadJob {
    Q_OBJECT
public:
    explicit CheckJob(pipeline::check::Filter filter, QObject* parent = nullptr);

signals:
    void arrived(const pipeline::check::CaseResult& result);
    void finished(double seconds, bool cancelled);
};

}  // namespace app
