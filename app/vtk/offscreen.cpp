#include "app/vtk/offscreen.h"

#include <QBuffer>
#include <QFile>
#include <QGuiApplication>
#include <QPainter>
#include <algorithm>
#include <array>
#include <chrono>
#include <future>
#include <thread>

#include "app/drawing3d/overlay.h"
#include "app/drawing3d/point_drawing.h"
#include "app/jobs/write_file.h"
#include "app/look/numbers.h"
#include "app/look/window_look.h"
#include "app/vtk/headless_window.h"
#include "app/vtk/vtk_mutex.h"
#include "app/vtk/world_scene.h"

namespace app {

namespace {

constexpr glm::ivec2 kSize{1280, 960};
// Letters and lines as large as in a view of 800 × 600: a picture goes onto a slide.
constexpr double kPixelRatio = 1.6;

struct NamedView {
    const char* file;
    ViewPreset preset;
};
constexpr std::array<NamedView, 6> kViews{{{"world.png", ViewPreset::Iso},
                                           {"front.png", ViewPreset::Front},
                                           {"side.png", ViewPreset::Side},
                                           {"top.png", ViewPreset::Top},
                                           {"eye.png", ViewPreset::Eye},
                                           {"everything.png", ViewPreset::Everything}}};

bool savePng(const QImage& image, const std::filesystem::path& file) {
    const std::string png = pngBytes(image);
    return !png.empty() && writeFile(QFile::decodeName(file.c_str()), QByteArray::fromStdString(png)).empty();
}

glm::ivec2 tileOf(const ViewShot& shot) { return glm::min(shot.size, glm::ivec2(shot.tile)); }

// Those at the right and at the foot may reach beyond the picture.
std::vector<QRect> tilesOf(QSize picture, glm::ivec2 tile) {
    std::vector<QRect> tiles;
    for (int y = 0; y < picture.height(); y += tile.y)
        for (int x = 0; x < picture.width(); x += tile.x) tiles.emplace_back(x, y, tile.x, tile.y);
    return tiles;
}

WorldScene::Part partOf(const QRect& tile, QSize picture) {
    const double half = picture.height() / 2.0;
    const QPointF middle = QRectF(tile).center() - QRectF({}, QSizeF(picture)).center();
    return {{middle.x() / half, -middle.y() / half}, {tile.width() / 2.0 / half, tile.height() / 2.0 / half}};
}

// Row by row: a painter would have to convert.
void copyInto(QImage& image, QPoint at, const QImage& tile) {
    const QRect inside = QRect(at, tile.size()) & image.rect();
    const qsizetype bytes = image.depth() / 8;
    for (int y = 0; y < inside.height(); ++y)
        std::copy_n(tile.constScanLine(y), inside.width() * bytes, image.scanLine(at.y() + y) + at.x() * bytes);
}

class ViewRenderer {
public:
    ViewRenderer(std::shared_ptr<HeadlessWindow> window, std::shared_ptr<const ViewContent> content,
                 const ViewOptions& options, glm::ivec2 size, double pixelRatio)
        : m_window(std::move(window)),
          m_content(std::move(content)),
          m_options(options),
          m_size(glm::dvec2(size) / pixelRatio),
          m_pixelRatio(pixelRatio),
          m_scene(m_window->window()) {
        m_scene.setColors(Theme::current().colors());
        m_scene.setContent(m_content, groundLines(*m_content));
        m_scene.setOptions(m_options);
    }

    QImage render(ViewPreset preset) {
        const ViewFrame view{presetCamera(preset, *m_content, m_options, m_size, false, takenFoot()), m_size,
                             Theme::current().scale()};
        return paint(view, drawWorld(*m_content, m_options, view), true);
    }

    // Tile by tile, the other views taking their turns in between. Null where it was given up.
    QImage renderShot(const OrbitCamera& camera, const ViewShot& shot, const ShotProgress& progress) {
        std::unique_lock turn(vtkMutex());
        m_scene.setContent(m_content, shot.hasGround ? groundLines(*m_content) : std::vector<InkedLine>{});
        const ViewFrame view{camera, m_size, Theme::current().scale()};
        const Drawing drawing = (shot.isPoint ? drawPoint : drawWorld)(*m_content, m_options, view);
        m_scene.setView(view, drawing, m_pixelRatio);
        QImage image({shot.size.x, shot.size.y},
                     shot.transparent ? QImage::Format_ARGB32_Premultiplied : QImage::Format_RGB888);
        const std::vector<QRect> tiles = tilesOf(image.size(), tileOf(shot));
        for (std::size_t i = 0; i < tiles.size(); ++i) {
            m_scene.setPart(partOf(tiles[i], image.size()));
            copyInto(image, tiles[i].topLeft(), shot.transparent ? renderTransparent() : m_window->render());
            turn.unlock();
            if (progress && !progress(double(i + 1) / double(tiles.size()))) return {};
            std::this_thread::sleep_for(std::chrono::milliseconds(1));  // else the lock would hardly be given away
            turn.lock();
        }
        turn.unlock();
        QPainter painter(&image);
        painter.scale(m_pixelRatio, m_pixelRatio);
        const bool hasLegend = m_content->point && m_content->map.keepsLengths();
        paintOverlay(painter, drawing, view,
                     placeLabels(drawing, view, hasLegend ? std::vector{legendAt(m_size)} : std::vector<QRectF>{}));
        if (hasLegend) paintLegend(painter, legendAt(m_size), m_options);
        return image;
    }

    // "At the point"; from then on the window shows `point` in place of the world.
    QImage renderPoint(std::shared_ptr<const ViewContent> point) {
        m_scene.setContent(point, {});
        const ViewFrame view{pointCamera(ViewPreset::Iso, *point, {}, m_size, false, takenFoot()), m_size,
                             Theme::current().scale()};
        return paint(view, drawPoint(*point, m_options, view), false);
    }

private:
    double takenFoot() const { return m_content->point ? m_size.y - legendAt(m_size).top() : 0; }
    // What is opaque looks the same on black and on white; a channel of the ground itself differs by 255.
    QImage renderTransparent() {
        m_scene.setBackground(Qt::black);
        const QImage black = m_window->render();
        m_scene.setBackground(Qt::white);
        const QImage white = m_window->render();
        QImage image(black.size(), QImage::Format_ARGB32_Premultiplied);
        for (int y = 0; y < image.height(); ++y) {
            const uchar *b = black.constScanLine(y), *w = white.constScanLine(y);
            auto* out = reinterpret_cast<QRgb*>(image.scanLine(y));
            for (int x = 0; x < image.width(); ++x, b += 3, w += 3) {
                const int through = std::clamp(w[1] - b[1], 0, 255), alpha = 255 - through;
                // On black, a colour stands as premultiplied already.
                out[x] =
                    qRgba(std::min<int>(b[0], alpha), std::min<int>(b[1], alpha), std::min<int>(b[2], alpha), alpha);
            }
        }
        return image;
    }
    QImage paint(const ViewFrame& view, const Drawing& drawing, bool withCube) {
        m_scene.setView(view, drawing, m_pixelRatio);
        QImage image = m_window->render();
        QPainter painter(&image);
        painter.scale(m_pixelRatio, m_pixelRatio);
        constexpr double kMargin = 12, kCube = 72;
        const QRectF cube(m_size.x - kMargin - kCube, m_size.y - kMargin - kCube, kCube, kCube);
        std::vector<QRectF> taken;
        if (m_content->point) taken.push_back(legendAt(m_size));
        if (withCube) taken.push_back(cube);
        paintOverlay(painter, drawing, view, placeLabels(drawing, view, taken));
        if (m_content->point) paintLegend(painter, legendAt(m_size), m_options);
        if (withCube) paintCube(painter, cube, view.camera);
        return image;
    }

    std::shared_ptr<HeadlessWindow> m_window;
    std::shared_ptr<const ViewContent> m_content;
    ViewOptions m_options;
    glm::dvec2 m_size;  // logical pixels
    double m_pixelRatio;
    WorldScene m_scene;
};

}  // namespace

struct FontSystem::Own {
    std::array<char, 11> name{"shadescope"};
    std::array<char, 10> option{"-platform"};
    std::array<char, 10> platform{"offscreen"};
    std::array<char*, 4> arguments{name.data(), option.data(), platform.data(), nullptr};
    int count = 3;
    QGuiApplication application{count, arguments.data()};
};
FontSystem::FontSystem() : m_own(QCoreApplication::instance() ? nullptr : std::make_unique<Own>()) {
    if (m_own) keepPointInNumbers();
}
FontSystem::~FontSystem() = default;
bool FontSystem::ready() const { return qobject_cast<QGuiApplication*>(QCoreApplication::instance()) != nullptr; }

std::string pngBytes(const QImage& image) {
    QByteArray png;
    QBuffer out(&png);
    return out.open(QIODevice::WriteOnly) && image.save(&out, "PNG") ? png.toStdString() : std::string();
}

pipeline::Result<QImage> renderView(const ViewContent& content, const ViewOptions& options, ViewPreset preset,
                                    glm::ivec2 size) {
    const auto window = HeadlessWindow::create(size);
    if (!window) return window.errors();
    return ViewRenderer(*window, std::make_shared<const ViewContent>(content), options, size, 1).render(preset);
}

pipeline::Result<QImage> renderView(const SpacePicture& picture, const ShotProgress& progress) {
    const ViewShot& shot = picture.shot;
    std::unique_lock turn(vtkMutex());
    const auto window = HeadlessWindow::create(tileOf(shot));
    if (!window) return window.errors();
    ViewRenderer renderer(*window, picture.content, picture.options, shot.size, shot.pixelRatio);
    turn.unlock();
    QImage image = renderer.renderShot(picture.camera, shot, progress);
    turn.lock();
    if (image.isNull()) return pipeline::Error{{}, "the picture was given up", {}};
    return image;
}

pipeline::Result<QImage> renderBeside(const SpacePicture& picture, const ShotProgress& progress) {
    const auto render = [&, look = WindowLook()] {
        const WornLook worn(look);
        return renderView(picture, progress);
    };
    return std::async(std::launch::async, render).get();
}

std::vector<std::string> viewFiles() {
    std::vector<std::string> names;
    for (const NamedView& view : kViews) names.emplace_back(view.file);
    return names;
}

pipeline::Result<std::vector<std::filesystem::path>> writeViews(const pipeline::Frame& frame,
                                                                std::optional<glm::ivec2> pixel,
                                                                const std::filesystem::path& folder) {
    const FontSystem fonts;
    if (!fonts.ready()) return pipeline::Error{{}, "no font system for the letters of the views", {}};
    const std::lock_guard turn(vtkMutex());
    const auto window = HeadlessWindow::create(kSize);
    if (!window) return window.errors();
    const auto content = std::make_shared<const ViewContent>(contentOf(frame, pixel));
    ViewRenderer renderer(*window, content, {}, kSize, kPixelRatio);
    std::vector<std::filesystem::path> files;
    pipeline::Errors errors;
    const auto write = [&](const QImage& image, const char* name) {
        files.push_back(folder / name);
        if (!savePng(image, files.back()))
            errors.push_back({{files.back().string(), 0, 0}, "could not be written", {}});
        return errors.empty();
    };
    for (const NamedView& view : kViews)
        if (!write(renderer.render(view.preset), view.file)) return errors;
    if (const auto point = pointContent(*content); point && !write(renderer.renderPoint(point), "point.png"))
        return errors;
    return files;
}

}  // namespace app
