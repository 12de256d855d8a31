#include "app/core/check_job.h"

#include <chrono>

namespace app {

using pipeline::check::CaseResult;

CheckJob::CheckJob(pipeline::check::Filter filter, QObject* parent) : QObject(parent) {
    // Signals leave in this object's own thread, and not at all once it is gone.
    const auto later = [this](auto call) { QMetaObject::invokeMethod(this, std::move(call), Qt::QueuedConnection); };
    m_thread = std::jthread([this, later, filter = std::move(filter)](const std::stop_token& stop) {
        const auto start = std::chrono::steady_clock::now();
        runChecks(filter, 0, stop, [&](const CaseResult& result) { later([this, result] { emit arrived(result); }); });
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        later([this, seconds, cancelled = stop.stop_requested()] { emit finished(seconds, cancelled); });
    });
}

CheckJob::~CheckJob() {
    m_thread.request_stop();
    m_thread.join();
}

}  // namespace app
