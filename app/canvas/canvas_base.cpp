#include "app/canvas/canvas_base.h"

#include "app/canvas/canvas_flip.h"
#include "app/look/theme.h"

namespace app {

namespace {

bool hasManyPolygons(const CanvasContent& content, const CanvasBase::Look& look) {
    const bool hasPolygons = content.shapes || content.verdicts || look.showsEdges || look.placement.zoom >= kEdgeZoom;
    return content.isOfManyPolygons && hasPolygons;
}

QImage paint(const CanvasContent& content, const CanvasBase::Look& look, const std::stop_token& stop = {}) {
    QImage image(look.size * look.ratio, QImage::Format_RGB32);
    image.setDevicePixelRatio(look.ratio);
    QPainter painter(&image);
    paintCanvas(painter, look.isFlipped ? upsideDown(content) : content, look.placement, QRect({}, look.size),
                look.showsEdges, stop);
    return image;
}

// Only moved, as a hand does that drags the picture.
bool isMoved(const CanvasBase::Look& a, CanvasBase::Look b) {
    if (a.placement.zoom != b.placement.zoom) return false;
    b.placement = a.placement;
    return a == b;
}

}  // namespace

CanvasBase::CanvasBase(QObject* parent) : QObject(parent) {
    connect(&m_job, &BackgroundJob::busyChanged, this, &CanvasBase::busyChanged);
}

void CanvasBase::draw(QPainter& painter, const CanvasContent& content, const Look& look) {
    const bool isNewest = m_painted && m_painted->version == m_version && m_painted->look == look;
    if (!isNewest && hasManyPolygons(content, look)) {
        ask(content, look);
        return drawMoved(painter, content, look);
    }
    m_job.forget();
    m_asked.reset();
    if (!isNewest) m_painted = Painted{m_version, look, content.size, QPixmap::fromImage(paint(content, look))};
    painter.drawPixmap(0, 0, m_painted->pixmap);
}

void CanvasBase::ask(const CanvasContent& content, const Look& look) {
    if (m_asked == look && m_askedVersion == m_version) return;
    // While a hand drags it, what is under way may finish: it is better than none until the hand rests.
    const bool goesOn = m_asked && m_askedVersion == m_version && isMoved(*m_asked, look);
    m_asked = look;
    m_askedVersion = m_version;
    m_job.ask([content, look](const BackgroundJob::Control& control) { return paint(content, look, control.stop); },
              [this, look, version = m_version, picture = content.size](const QImage& image) {
                  m_painted = Painted{version, look, picture, QPixmap::fromImage(image)};
                  emit painted();
              },
              goesOn ? BackgroundJob::Running::Finish : BackgroundJob::Running::Stop);
}

void CanvasBase::drawMoved(QPainter& painter, const CanvasContent& content, const Look& look) const {
    painter.fillRect(QRect({}, look.size), content.ground.isValid() ? content.ground : Theme::current().colors().bg);
    if (!m_painted || m_painted->picture != content.size || m_painted->look.isFlipped != look.isFlipped) return;
    const Placement &from = m_painted->look.placement, &to = look.placement;
    const double larger = to.zoom / from.zoom;
    painter.save();
    painter.translate(to.origin - from.origin * larger);
    painter.scale(larger, larger);
    painter.drawPixmap(0, 0, m_painted->pixmap);
    painter.restore();
}

}  // namespace app
