#include "app/core/study_images.h"

#include <memory>

#include "app/core/text.h"
#include "pipeline/export/study_pictures.h"

namespace app {
namespace {

using pipeline::ErrorFinder;
using pipeline::Scene;

QImage toImage(const pipeline::Buffer2D<pipeline::Color8>& picture) {
    if (picture.empty()) return {};
    QImage image(picture.size.x, picture.size.y, QImage::Format_RGB32);
    for (int y = 0; y < picture.size.y; ++y)
        for (int x = 0; x < picture.size.x; ++x) {
            const pipeline::Color8& c = picture.at({x, y});
            image.setPixel(x, y, qRgb(c.r, c.g, c.b));
        }
    return image;
}

SettingPictures toPictures(const pipeline::PointPictures& shown) {
    const pipeline::ComparedPictures compared = comparedPictures(shown);
    return {toImage(compared.image), toImage(compared.reference), toImage(compared.error),
            shown.reference ? toQString(shown.reference->name) : QString("There is no reference of the true surfaces."),
            compared.largest};
}

}  // namespace

StudyImages::StudyImages(QObject* parent)
    : QObject(parent), m_thread([this](const std::stop_token& quit) { work(quit); }) {}

StudyImages::~StudyImages() {
    m_thread.request_stop();
    {
        const std::lock_guard lock(m_mutex);
        m_stop.request_stop();
    }
    m_thread.join();
}

void StudyImages::ask(std::shared_ptr<const Scene> scene, const std::vector<pipeline::SweepAxis>& axes,
                      const pipeline::StudyPoint& point) {
    {
        const std::lock_guard lock(m_mutex);
        m_next = Job{std::move(scene), axes, point, ++m_ticket};
        m_stop.request_stop();
    }
    m_arrived.notify_one();
}

void StudyImages::forget() {
    const std::lock_guard lock(m_mutex);
    ++m_ticket;
    m_next.reset();
    m_stop.request_stop();
}

void StudyImages::work(const std::stop_token& quit) {
    std::optional<ErrorFinder> finder;
    std::shared_ptr<const Scene> scene;
    std::vector<pipeline::SweepAxis> axes;
    while (!quit.stop_requested()) {
        Job job;
        std::stop_token stop;
        {
            std::unique_lock lock(m_mutex);
            if (!m_arrived.wait(lock, quit, [this] { return m_next.has_value(); })) return;
            job = std::move(*m_next);
            m_next.reset();
            // Fresh under the lock: a request from here on stops this one. Quitting may have been asked for in between.
            m_stop = std::stop_source();
            if (quit.stop_requested()) return;
            stop = m_stop.get_token();
        }
        if (!finder || *scene != *job.scene || axes != job.axes) {
            scene = job.scene;
            axes = job.axes;
            pipeline::StudyRequest request;
            request.scene = scene;
            request.sweep.axes = axes;
            finder.emplace(request);
        }
        const auto shown = finder->show(job.point, stop);
        if (!shown || stop.stop_requested()) continue;
        // Runs later in this object's own thread, and not at all once it is gone; an older one is no news.
        QMetaObject::invokeMethod(
            this,
            [this, pictures = toPictures(*shown), ticket = job.ticket] {
                if (ticket == m_ticket) emit ready(pictures);
            },
            Qt::QueuedConnection);
    }
}

}  // namespace app
