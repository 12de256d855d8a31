#include "app/core/check_job.h"

#include <chrono>

namespace app {

using pipeline::check::CaseResult;

CheckJob::CheckJob(pipeline::check::Filter filter, QObject* parent) : ThreadJob(parent) {
    start([this, filter = std::move(filter)](const std::stop_token& stop, const auto& later) {
        const auto start = std::chrono::steady_clock::now();
        runChecks(filter, 0, stop, [&](const CaseResult& result) { later([this, result] { emit arrived(result); }); });
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        later([this, seconds, cancelled = stop.stop_requested()] { emit finished(seconds, cancelled); });
    });
}

}  // namespace app
