#pragma once
#include <memory>

#include "app/core/background_job.h"
#include "pipeline/inspect/pixel_report.h"
#include "pipeline/run/frame.h"

namespace app {

class Document;

// A pixel's report and the frame that it is of.
struct InspectedPixel {
    pipeline::FramePtr frame;
    pipeline::PixelReport report;
};

// What is known about a document's picked pixel in the frame on show: found once for all who show it, and beside the
// window where there are many polygons to look at.
class PixelInspection : public QObject {
    Q_OBJECT
public:
    explicit PixelInspection(Document& document);

    // The newest; null where no pixel is picked. While busy it is that of the pixel or the frame before.
    const std::shared_ptr<const InspectedPixel>& newest() const { return m_newest; }
    bool busy() const { return m_job.busy(); }

signals:
    void changed();
    void busyChanged(bool busy);

private:
    void ask();
    void take(std::shared_ptr<const InspectedPixel> inspected);

    Document& m_document;
    std::shared_ptr<const InspectedPixel> m_newest;
    pipeline::FramePtr m_askedFrame;
    glm::ivec2 m_askedPixel{0};
    BackgroundJob m_job;
};

}  // namespace app
