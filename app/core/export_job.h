#pragma once
#include "app/core/thread_job.h"
#include "app/derived/derived_buffer.h"
#include "pipeline/export/export_frame.h"

namespace app {

// Writes an export on a thread of its own: computes the frame that holds all its buffers, then
// the files. One job, one export.
class ExportJob : public ThreadJob {
    Q_OBJECT
public:
    // `before` may be null; what it holds is reused. Derived buffers that the request names are made after the recipe.
    ExportJob(std::shared_ptr<const pipeline::Scene> scene, pipeline::FramePtr before, pipeline::ExportRequest request,
              DerivedRecipe recipe, QObject* parent = nullptr);

signals:
    void progressed(double share, const QString& file);
    void finished(const pipeline::ExportSummary& summary);
    void failed(const pipeline::Errors& errors);
};

}  // namespace app
