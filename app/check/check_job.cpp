#include "app/check/check_job.h"

#include <chrono>

#include "app/jobs/memory_notice.h"

namespace app {

using pipeline::check::CaseResult;

CheckJob::CheckJob(pipeline::check::Filter filter, QObject* parent) : ThreadJob(parent) {
    start([this, filter = std::move(filter)](const std::stop_token& stop, const auto& later) {
        const auto start = std::chrono::steady_clock::now();
        bool lacksMemory = false;
        try {
            runChecks(filter, 0, stop,
                      [&](const CaseResult& result) { later([this, result] { emit arrived(result); }); });
        } catch (const std::bad_alloc&) {
            lacksMemory = true;
            later([] { emit MemoryNotice::instance().gaveUp(); });
        }
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        later([this, seconds, cancelled = lacksMemory || stop.stop_requested()] { emit finished(seconds, cancelled); });
    });
}

}  // namespace app
