#include "app/export/export_job.h"

#include "app/jobs/memory_notice.h"
#include "app/look/text.h"
#include "pipeline/run/runner.h"

namespace app {
namespace {

using pipeline::ExportSummary;

using Exported = pipeline::Result<ExportSummary>;

Exported runExport(std::shared_ptr<const pipeline::Scene> scene, const pipeline::FramePtr& before,
                   pipeline::ExportRequest request, const lessons::DerivedRecipe& recipe, const WriteMore& more,
                   const std::stop_token& stop, const pipeline::ExportProgress& progress) {
    const ExportSummary cancelled{.cancelled = true, .files = {}};
    pipeline::FrameRequest wanted{.wanted = {}, .stop = stop};
    for (const pipeline::BufferName& name : request.buffers) {
        if (!pipeline::isDerived(name.id)) {
            wanted.wanted.set(index(name.id));
            continue;
        }
        const auto needed = buffersFor(name, recipe, *scene);
        if (!needed) return needed.errors();
        wanted.wanted |= *needed;
    }
    const pipeline::FramePtr frame = pipeline::runFrame(std::move(scene), wanted, before);
    if (!frame) return cancelled;
    for (const pipeline::BufferName& name : request.buffers) {
        if (!pipeline::isDerived(name.id)) continue;
        const std::string words = name.text();
        const auto tell = [&](double share) { progress(share, words); };
        auto made = derive(name, recipe, *frame, {.stop = stop, .progress = tell});
        if (stop.stop_requested()) return cancelled;
        if (!made) return made.errors();
        request.derived.push_back({made->buffer, made->meaning});
    }
    if (more) request.writeMore = [&](const std::filesystem::path& folder) { return more(*frame, folder); };
    return exportFrame(*frame, request, progress);
}

}  // namespace

ExportJob::ExportJob(std::shared_ptr<const pipeline::Scene> scene, pipeline::FramePtr before,
                     pipeline::ExportRequest request, lessons::DerivedRecipe recipe, WriteMore more, QObject* parent)
    : ThreadJob(parent) {
    start([this, scene = std::move(scene), before = std::move(before), request = std::move(request),
           recipe = std::move(recipe), more = std::move(more)](const std::stop_token& stop, const auto& later) {
        const auto progress = [&](double share, std::string_view file) {
            later([this, share, name = toQString(file)] { emit progressed(share, name); });
            return !stop.stop_requested();
        };
        progress(0, tr("Computing the frame").toStdString());
        const auto result =
            withinMemory([&] { return runExport(scene, before, request, recipe, more, stop, progress); });
        later([this, result] {
            if (result) {
                emit finished(*result);
            } else {
                emit failed(result.errors());
            }
        });
    });
}

}  // namespace app
