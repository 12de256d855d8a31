#pragma once
#include "app/core/thread_job.h"
#include "lessons/derived_buffer.h"
#include "pipeline/export/export_frame.h"

namespace app {

// Writes more files of a frame into a folder, such as pictures of its 3D views, and gives their names.
using WriteMore = std::function<pipeline::Result<std::vector<std::filesystem::path>>(
    const pipeline::Frame& frame, const std::filesystem::path& folder)>;

// Writes an export on a thread of its own: computes the frame that holds all its buffers, then
// the files. One job, one export.
class ExportJob : public ThreadJob {
    Q_OBJECT
public:
    // `before` may be null; what it holds is reused. Derived buffers that the request names are made after the recipe.
    // `more` may be empty.
    ExportJob(std::shared_ptr<const pipeline::Scene> scene, pipeline::FramePtr before, pipeline::ExportRequest request,
              lessons::DerivedRecipe recipe, WriteMore more, QObject* parent = nullptr);

signals:
    void progressed(double share, const QString& file);
    void finished(const pipeline::ExportSummary& summary);
    void failed(const pipeline::Errors& errors);
};

}  // namespace app
