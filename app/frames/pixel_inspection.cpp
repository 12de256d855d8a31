#include "app/frames/pixel_inspection.h"

#include "app/frames/frame_feed.h"
#include "app/frames/large_frame.h"
#include "app/frames/pointing.h"
#include "app/jobs/work_list.h"

namespace app {

PixelInspection::PixelInspection(const FrameFeed& frames, const Pointing& pointing, WorkList& work)
    : m_frames(frames), m_pointing(pointing) {
    connect(&frames, &FrameFeed::frameReady, this, &PixelInspection::ask);
    connect(&pointing, &Pointing::pixelChanged, this, &PixelInspection::ask);
    connect(&m_job, &BackgroundJob::busyChanged, this, &PixelInspection::busyChanged);
    work.add(
        this, tr("the picked pixel"), [this] { m_job.forget(); },
        [this] {
            m_askedFrame.reset();
            ask();
        });
    connect(this, &PixelInspection::busyChanged, this, [this, &work](bool busy) { work.setBusy(this, busy); });
}

void PixelInspection::ask() {
    const pipeline::FramePtr& frame = m_frames.shown();
    const auto pixel = m_pointing.pixel();
    if (!frame || !pixel) {
        m_job.forget();
        m_askedFrame.reset();
        return take(nullptr);
    }
    // The frame may lag behind a scene whose picture has just become larger.
    const pipeline::Settings& settings = frame->scene().settings;
    if (pixel->x >= settings.width || pixel->y >= settings.height) return;
    if (frame == m_askedFrame && *pixel == m_askedPixel) return;
    m_askedFrame = frame;
    m_askedPixel = *pixel;
    const auto inspect = [frame, pixel = *pixel](const std::stop_token& stop) {
        return std::make_shared<const InspectedPixel>(InspectedPixel{frame, inspectPixel(*frame, pixel, stop)});
    };
    if (!isLarge(*frame)) {
        m_job.forget();
        return take(inspect({}));
    }
    // While the pixel follows the pointer what is under way may finish: it is better than none until the hand rests.
    m_job.ask([inspect](const BackgroundJob::Control& control) { return inspect(control.stop); },
              [this](const std::shared_ptr<const InspectedPixel>& inspected) { take(inspected); },
              BackgroundJob::Running::Finish);
}

void PixelInspection::take(std::shared_ptr<const InspectedPixel> inspected) {
    if (!inspected && !m_newest) return;
    m_newest = std::move(inspected);
    emit changed();
}

}  // namespace app
