#include "app/study/study_images.h"

#include "app/look/shown_name.h"
#include "pipeline/export/study/study_pictures.h"

namespace app {
namespace {

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
            shown.reference ? onOneLine(shown.reference->name) : QString("There is no reference of the true surfaces."),
            compared.largest};
}

}  // namespace

StudyImages::StudyImages(QObject* parent) : QObject(parent) {}

void StudyImages::ask(std::shared_ptr<const Scene> scene, const std::vector<pipeline::SweepAxis>& axes,
                      const pipeline::StudyPoint& point) {
    const auto show = [this, scene = std::move(scene), axes, point](const BackgroundJob::Control& control) {
        if (!m_finder || *m_scene != *scene || m_axes != axes) {
            m_scene = scene;
            m_axes = axes;
            pipeline::StudyRequest request;
            request.scene = scene;
            request.sweep.axes = axes;
            m_finder.emplace(request);
        }
        const auto shown = m_finder->show(point, control.stop);
        return shown ? std::optional(toPictures(*shown)) : std::nullopt;
    };
    m_job.ask(show, [this](const std::optional<SettingPictures>& pictures) {
        if (pictures) emit ready(*pictures);
    });
}

void StudyImages::forget() { m_job.forget(); }

}  // namespace app
