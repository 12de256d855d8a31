#pragma once
#include <QObject>
#include <thread>

#include "pipeline/check/case.h"

namespace app {

// Runs cases of the catalogue on threads of its own. One job, one run.
class CheckJob : public QObject {
    Q_OBJECT
public:
    explicit CheckJob(pipeline::check::Filter filter, QObject* parent = nullptr);
    ~CheckJob() override;  // cancels what has not begun, and waits for the rest

    void cancel() { m_thread.request_stop(); }

signals:
    void arrived(const pipeline::check::CaseResult& result);
    void finished(double seconds, bool cancelled);

private:
    std::jthread m_thread;
};

}  // namespace app
