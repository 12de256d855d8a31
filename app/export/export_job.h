#pragma once
#include "app/jobs/thread_job.h"
#include "lessons/derived_buffer.h"
#include "pipeline/export/export_frame.h"

namespace app {

// Writes more files of a frame to a folder, such as pictures of its 3D views, and returns their names.
using WriteMore = std::function<pipeline::Result<std::vector<std::filesystem::path>>(
    const pipeline::Frame& frame, const std::filesystem::path& folder)>;

// Writes an export on a thread of its own: computes the frame with all requested buffers, then the files. One job, one
// export.
class ExportJob : public ThreadJob {
    Q_OBJECT
public:
    // `before` may be null; its results are reused. The recipe describes the derived buffers of the request. `more` may
    // be empty.
    ExportJob(std::shared_ptr<const pipeline::Scene> scene, pipeline::FramePtr before, pipeline::ExportRequest request,
              lessons::DerivedRecipe recipe, WriteMore more, QObject* parent = nullptr);

signals:
    void progressed(double share, const QString& file);
    void finished(const pipeline::ExportSummary& summary);
    void failed(const pipeline::Errors& errors);
};

}  // namespace app
