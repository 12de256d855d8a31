#pragma once
#include "app/buffer_view/buffer_feature.h"
#include "app/jobs/background_job.h"

namespace app {

// Outlines what is selected in the scene.
class SelectionMark : public BufferFeature {
public:
    explicit SelectionMark(BufferView& view);

    void show() override;
    bool busy() const override { return m_job.busy(); }
    void cancel() override { m_job.forget(); }

private:
    BackgroundJob m_job;
};

}  // namespace app
