#pragma once
#include <memory>

#include "app/jobs/background_job.h"
#include "pipeline/inspect/pixel_report.h"
#include "pipeline/run/frame.h"

namespace app {

class FrameFeed;
class Pointing;
class WorkList;

// A pixel's report and its frame.
struct InspectedPixel {
    pipeline::FramePtr frame;
    pipeline::PixelReport report;
};

// The report on the picked pixel in the current frame. It is computed once for everybody who shows it, and in the
// background if there are many polygons.
class PixelInspection : public QObject {
    Q_OBJECT
public:
    PixelInspection(const FrameFeed& frames, const Pointing& pointing, WorkList& work);

    // The newest report; null if no pixel is picked. While busy it is that of the previous pixel or frame.
    const std::shared_ptr<const InspectedPixel>& newest() const { return m_newest; }
    bool busy() const { return m_job.busy(); }

signals:
    void changed();
    void busyChanged(bool busy);

private:
    void ask();
    void take(std::shared_ptr<const InspectedPixel> inspected);

    const FrameFeed& m_frames;
    const Pointing& m_pointing;
    std::shared_ptr<const InspectedPixel> m_newest;
    pipeline::FramePtr m_askedFrame;
    glm::ivec2 m_askedPixel{0};
    BackgroundJob m_job;
};

}  // namespace app
