#include "app/core/export_job.h"

#include "app/core/text.h"
#include "pipeline/run/runner.h"

namespace app {
namespace {

using pipeline::ExportSummary;

pipeline::Result<ExportSummary> runExport(std::shared_ptr<const pipeline::Scene> scene,
                                          const pipeline::FramePtr& before, const pipeline::ExportRequest& request,
                                          const std::stop_token& stop, const pipeline::ExportProgress& progress) {
    pipeline::FrameRequest wanted{.wanted = {}, .stop = stop};
    for (const pipeline::BufferName& name : request.buffers) wanted.wanted.set(index(name.id));
    const pipeline::FramePtr frame = pipeline::runFrame(std::move(scene), wanted, before);
    if (!frame) return ExportSummary{.cancelled = true, .files = {}};
    return exportFrame(*frame, request, progress);
}

}  // namespace

ExportJob::ExportJob(std::shared_ptr<const pipeline::Scene> scene, pipeline::FramePtr before,
                     pipeline::ExportRequest request, QObject* parent)
    : QObject(parent) {
    // Signals leave in this object's own thread, and not at all once it is gone.
    const auto later = [this](auto call) { QMetaObject::invokeMethod(this, std::move(call), Qt::QueuedConnection); };
    m_thread = std::jthread([this, later, scene = std::move(scene), before = std::move(before),
                             request = std::move(request)](const std::stop_token& stop) {
        const auto progress = [&](double share, std::string_view file) {
            later([this, share, name = toQString(file)] { emit progressed(share, name); });
            return !stop.stop_requested();
        };
        const auto result = runExport(scene, before, request, stop, progress);
        later([this, result] {
            if (result) {
                emit finished(*result);
            } else {
                emit failed(result.errors());
            }
        });
    });
}

ExportJob::~ExportJob() {
    m_thread.request_stop();
    m_thread.join();
}

}  // namespace app
