#include "app/view3d/view_corner.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QToolTip>
#include <algorithm>
#include <array>

namespace app {

namespace {

constexpr double kCubeSide = 56;

constexpr std::array<VectorCode, 5> kCodes{VectorCode::N, VectorCode::L, VectorCode::V, VectorCode::R, VectorCode::H};

QString meaning(VectorCode code) {
    switch (code) {
        case VectorCode::N: return ViewCorner::tr("N, the normal");
        case VectorCode::L: return ViewCorner::tr("L, to the light");
        case VectorCode::V: return ViewCorner::tr("V, to the eye");
        case VectorCode::R: return ViewCorner::tr("R, L mirrored in N");
        case VectorCode::H: return ViewCorner::tr("H, half way between L and V");
        case VectorCode::None: break;
    }
    return {};
}

QString name(CubeFace face, ViewSpace space) {
    const auto along = [space](CubeFace away, const char* key) {
        return ViewCorner::tr("Look along %1%2").arg(letterOf(away, space), QString::fromUtf8(key));
    };
    switch (face) {
        case CubeFace::X: return along(CubeFace::MinusX, " (3)");
        case CubeFace::Y: return along(CubeFace::MinusY, "");
        case CubeFace::Z: return ViewCorner::tr("Look down from the top (7)");
        case CubeFace::MinusX: return along(CubeFace::X, "");
        case CubeFace::MinusY: return along(CubeFace::Y, " (1)");
        case CubeFace::MinusZ: return ViewCorner::tr("Look up from below");
        case CubeFace::Middle: return ViewCorner::tr("Iso view (9)");
        case CubeFace::None: break;
    }
    return {};
}

}  // namespace

ViewCorner::ViewCorner(Kind kind, QWidget* parent) : QWidget(parent), m_kind(kind) {
    setCursor(Qt::PointingHandCursor);
    setFocusPolicy(Qt::NoFocus);
    setMouseTracking(true);
    setAccessibleName(kind == Kind::Legend ? tr("Legend of the vectors") : tr("Directions"));
    if (kind == Kind::Legend)
        setAccessibleDescription(
            tr("N normal, L to the light, V to the eye, R mirrored L, H half way. A click hides one."));
}

QSize ViewCorner::sizeHint() const {
    const int side = Theme::current().px(kCubeSide);
    if (m_kind == Kind::Cube) return {side, side};
    return (m_only ? legendSize(m_room, std::max(1, int(m_only->size()))) : legendSize(m_room)).toSize();
}

void ViewCorner::setOptions(const ViewOptions& options) {
    if (options == m_options) return;
    m_options = options;
    update();
}

void ViewCorner::setOnly(std::optional<std::vector<VectorCode>> codes) {
    if (codes == m_only) return;
    m_only = std::move(codes);
    setAttribute(Qt::WA_TransparentForMouseEvents, m_only.has_value());
    update();
}

void ViewCorner::setCamera(const OrbitCamera& camera, ViewSpace space) {
    if (camera == m_camera && space == m_space) return;
    m_camera = camera;
    m_space = space;
    update();
}

void ViewCorner::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    if (m_kind == Kind::Legend)
        paintLegend(painter, rect(), m_options, m_only);
    else
        paintCube(painter, rect(), m_camera, m_space);
}

VectorCode ViewCorner::vectorAt(QPointF position) const {
    if (m_kind == Kind::Legend)
        for (const VectorCode code : kCodes)
            if (legendEntry(code, rect()).contains(position)) return code;
    return VectorCode::None;
}

void ViewCorner::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    if (const VectorCode code = vectorAt(event->position()); code != VectorCode::None) emit vectorClicked(code);
    if (m_kind != Kind::Cube) return;
    if (const CubeFace face = cubeFaceAt(rect(), m_camera, event->position()); face != CubeFace::None)
        emit faceClicked(face);
}

void ViewCorner::setHovered(VectorCode code) {
    if (code == m_hovered) return;
    m_hovered = code;
    emit vectorHovered(code);
}

void ViewCorner::mouseMoveEvent(QMouseEvent* event) { setHovered(vectorAt(event->position())); }

void ViewCorner::leaveEvent(QEvent* event) {
    QWidget::leaveEvent(event);
    setHovered(VectorCode::None);
}

bool ViewCorner::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    QString text;
    if (m_kind == Kind::Cube) {
        text = name(cubeFaceAt(rect(), m_camera, help->pos()), m_space);
    } else if (const VectorCode code = vectorAt(help->pos()); code != VectorCode::None) {
        text = meaning(code) + (m_options.shows(code) ? tr(". A click hides it.") : tr(". A click shows it."));
    }
    QToolTip::showText(help->globalPos(), text, this);
    return true;
}

}  // namespace app
