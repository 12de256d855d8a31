#include "app/start/scene_gallery.h"
#include "pipeline/plan/memory_limit.h"

#include <algorithm>

#include "app/start/start_order.h"
#include "pipeline/buffers/palette.h"
#include "pipeline/run/runner.h"
#include "pipeline/scene/settings_table.h"
#include "pipeline/study/errors.h"

namespace app {
namespace {

constexpr int kWidth = 480, kHeight = 360;

QRect drawnIn(const pipeline::Frame& frame) {
    QRect drawn;
    if (const auto ids = frame.buffer({pipeline::BufferId::PolygonId}))
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x)
                if (ids->value(std::size_t(x), std::size_t(y)) >= 0) drawn |= QRect(x, y, 1, 1);
    return drawn;
}

// A picture whose scene is small in it is cut to the scene, so that it can be recognised.
ScenePicture cutToScene(const QImage& picture, const QRect& drawn) {
    if (drawn.isEmpty() || drawn.width() > kWidth / 2 || drawn.height() > kHeight / 2) return {picture, drawn};
    const int width = std::max(drawn.width(), drawn.height() * kWidth / kHeight) * 3 / 2,
              height = width * kHeight / kWidth;
    QRect part(0, 0, width, height);
    part.moveCenter(drawn.center());
    const int times = std::max(1, kWidth / width);  // whole pixels, to be seen as such
    return {picture.copy(part).scaled(width * times, height * times),
            QRect((drawn.topLeft() - part.topLeft()) * times, drawn.size() * times)};
}

// Intensities from 0 to white.
QImage termImage(const pipeline::Frame& frame, const pipeline::BufferName& name) {
    const auto buffer = frame.buffer(name);
    if (!buffer) return {};
    QImage image(int(buffer->columns()), int(buffer->rows()), QImage::Format_RGB888);
    const pipeline::PaletteRange range{0, pipeline::whiteOf(frame.scene())};
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const auto color = elementColor(*buffer, std::size_t(x), std::size_t(y), range);
            image.setPixel(x, y, qRgb(color.r, color.g, color.b));
        }
    return image;
}

ScenePicture render(const pipeline::BuiltInScene& builtIn, const pipeline::BufferName& buffer, std::stop_token stop) {
    auto scene = pipeline::readScene(builtIn.file);
    if (!scene || !pipeline::checkSceneAndMemory(*scene).empty()) return {};
    auto small = std::make_shared<pipeline::Scene>(std::move(scene).value());
    // A spherical camera fixes the pixels per screen unit, not the field of view.
    small->camera.pixelsPerUnit *= double(kHeight) / small->settings.height;
    small->settings.width = kWidth;
    small->settings.height = kHeight;
    const auto frame = pipeline::runFrame(
        std::move(small),
        {.wanted = pipeline::setOf({buffer.id, pipeline::BufferId::PolygonId}), .threads = 1, .stop = std::move(stop)},
        nullptr);
    if (!frame) return {};
    const QRect drawn = drawnIn(*frame);
    return buffer.id == pipeline::BufferId::Color ? cutToScene(colorImage(*frame), drawn)
                                                  : ScenePicture{termImage(*frame, buffer), drawn};
}

}  // namespace

QImage colorImage(const pipeline::Frame& frame) {
    const auto color = frame.buffer({pipeline::BufferId::Color});
    if (!color) return {};
    const auto& bytes = std::get<std::span<const std::uint8_t>>(color->data);
    const int width = int(color->columns()), height = int(color->rows());
    return QImage(bytes.data(), width, height, 3 * qsizetype(width), QImage::Format_RGB888).copy();
}

SceneGallery::SceneGallery(QObject* parent) : QObject(parent), m_scenes(pipeline::builtInScenes()) {
    for (std::size_t i = 0; i < m_scenes.size(); ++i) m_terms.push_back({i, {pipeline::BufferId::Color}});
    for (const StartLecture& lecture : startOrder())
        for (const StartView::Part& part : lecture.first.parts) {
            const auto scene = std::ranges::find(m_scenes, part.scene, &pipeline::BuiltInScene::name);
            if (scene != m_scenes.end() && !find(part.scene, part.buffer))
                m_terms.push_back({std::size_t(scene - m_scenes.begin()), part.buffer});
        }
    m_pictures.resize(m_terms.size());
    m_thread = std::jthread([this, scenes = m_scenes, terms = m_terms](const std::stop_token& stop) {
        for (std::size_t i = 0; i < terms.size() && !stop.stop_requested(); ++i) {
            std::unique_lock lock(m_mutex);
            if (!m_changed.wait(lock, stop, [this] { return m_watched; })) return;
            lock.unlock();
            QMetaObject::invokeMethod(
                this,
                [this, i, picture = render(scenes[terms[i].scene], terms[i].buffer, stop)] {
                    m_pictures[i] = picture;
                    emit pictureReady(i);
                },
                Qt::QueuedConnection);
        }
    });
}

std::optional<std::size_t> SceneGallery::find(const std::string& scene, const pipeline::BufferName& buffer) const {
    for (std::size_t i = 0; i < m_terms.size(); ++i)
        if (m_scenes[m_terms[i].scene].name == scene && m_terms[i].buffer == buffer) return i;
    return std::nullopt;
}

void SceneGallery::setWatched(bool watched) {
    {
        const std::lock_guard lock(m_mutex);
        m_watched = watched;
    }
    m_changed.notify_all();
}

SceneGallery::~SceneGallery() {
    m_thread.request_stop();
    m_thread.join();
}

}  // namespace app
