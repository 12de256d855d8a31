#include "app/view3d/scene_view.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <cmath>

#include "app/core/theme.h"
#include "app/view3d/overlay.h"
#include "app/view3d/point_drawing.h"
#include "app/view3d/view_corner.h"

namespace app {

namespace {

constexpr double kDegreesPerPixel = 0.4, kKeyStep = 5, kWheelStep = 1.15, kClickSlop = 4;
constexpr int kFlightMilliseconds = 250, kZoomOutMilliseconds = 1200;

Vec3d directionOf(CubeFace face) {
    switch (face) {
        case CubeFace::X: return {-1, 0, 0};
        case CubeFace::Y: return {0, -1, 0};
        case CubeFace::Z: return {0, 0, -1};
        case CubeFace::MinusX: return {1, 0, 0};
        case CubeFace::MinusY: return {0, 1, 0};
        default: return {0, 0, 1};
    }
}

}  // namespace

// Letters and captions, over VTK's picture; the mouse goes through it.
class SceneView::Overlay : public QWidget {
public:
    explicit Overlay(SceneView* view) : QWidget(view), m_view(view) { setAttribute(Qt::WA_TransparentForMouseEvents); }

protected:
    void paintEvent(QPaintEvent*) override {
        if (!m_view->shown() || !m_view->m_problem.isEmpty()) return;
        QPainter painter(this);
        paintOverlay(painter, m_view->m_drawing, m_view->viewFrame());
        if (m_view->m_probe && m_view->m_space == ViewSpace::World)
            paintProbe(painter, *m_view->m_probe, m_view->viewFrame());
    }

private:
    SceneView* m_view;
};

SceneView::SceneView(QWidget* parent) : QWidget(parent), m_problem(openGlProblem()) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAutoFillBackground(true);
    setAccessibleName(tr("3D view"));
    setMinimumSize(200, 150);
    if (m_problem.isEmpty()) {
        m_vtk = new VtkWidget(this);
        m_vtk->setMouseTracking(true);
        connect(
            m_vtk, &VtkWidget::unusable, this,
            [this] {
                m_problem = tr("This machine gives no OpenGL 3.2. Buffers still work.");
                refresh();
            },
            Qt::QueuedConnection);
    }
    m_overlay = new Overlay(this);
    m_legend = new ViewCorner(ViewCorner::Kind::Legend, this);
    m_cube = new ViewCorner(ViewCorner::Kind::Cube, this);
    m_legend->setObjectName("legend");
    m_cube->setObjectName("cube");
    m_sentence = new QLabel(this);
    m_sentence->setAlignment(Qt::AlignCenter);
    m_sentence->setWordWrap(true);
    m_sentence->setAttribute(Qt::WA_TransparentForMouseEvents);

    connect(m_legend, &ViewCorner::vectorClicked, this, [this](VectorCode code) {
        ViewOptions options = m_options;
        bool& shown = options.shown[static_cast<std::size_t>(code)];
        shown = !(shown && options.vectors);
        options.vectors = true;
        setOptions(options);
        emit optionsChanged();
    });
    connect(m_legend, &ViewCorner::vectorHovered, this, [this](VectorCode code) {
        m_alone = code;
        refresh();
    });
    connect(m_cube, &ViewCorner::faceClicked, this, [this](CubeFace face) {
        if (!m_content) return;
        if (face == CubeFace::Middle) return go(ViewPreset::Iso);
        OrbitCamera camera = cameraOf(ViewPreset::Front);
        lookAlong(camera, directionOf(face));
        frame(camera, sceneExtent(*m_content, m_options), viewFrame().size);
        m_touched = true;
        flyTo(camera, kFlightMilliseconds);
    });
    m_flight.setStartValue(0.0);
    m_flight.setEndValue(1.0);
    m_flight.setEasingCurve(QEasingCurve::OutCubic);
    connect(&m_flight, &QVariantAnimation::valueChanged, this, [this](const QVariant& t) {
        m_camera = between(m_from, m_to, t.toDouble());
        refresh();
    });
    connect(&Theme::current(), &Theme::changed, this, &SceneView::applyTheme);
    applyTheme();
}

SceneView::~SceneView() { m_flight.disconnect(this); }

ViewFrame SceneView::viewFrame() const { return {m_camera, {std::max(width(), 1), std::max(height(), 1)}}; }

void SceneView::setContent(std::shared_ptr<const ViewContent> content, bool newScene) {
    m_content = std::move(content);
    m_point = m_content ? pointContent(*m_content) : nullptr;
    if (newScene) m_touched = m_otherTouched = false;
    showContent();
}

void SceneView::setEmptyText(const QString& sentence) {
    m_emptyText = sentence;
    refresh();
}

void SceneView::setProbe(std::optional<Vec3d> point) {
    m_probe = point;
    m_overlay->update();
}

void SceneView::setSpace(ViewSpace space) {
    if (space == m_space) return;
    m_flight.stop();
    m_space = space;
    std::swap(m_camera, m_otherCamera);
    std::swap(m_touched, m_otherTouched);
    m_camera.orthographic = m_otherCamera.orthographic;
    showContent();
}

void SceneView::showContent() {
    const bool ground = m_space == ViewSpace::World && m_content;
    if (m_vtk) m_vtk->setContent(shown(), ground ? groundLines(*m_content) : std::vector<InkedLine>{});
    frameIfUntouched();
    refresh();
}

void SceneView::setOptions(const ViewOptions& options) {
    if (options == m_options) return;
    m_options = options;
    if (m_vtk) m_vtk->setOptions(options);
    if (m_space == ViewSpace::Point) frameIfUntouched();  // a construction may reach out of the hemisphere
    refresh();
}

void SceneView::setCamera(const OrbitCamera& camera) {
    m_flight.stop();
    const bool turned = camera.orthographic != m_camera.orthographic;
    m_camera = camera;
    m_touched = true;
    refresh();
    if (turned) emit orthographicChanged(camera.orthographic);
}

OrbitCamera SceneView::cameraOf(ViewPreset preset) const {
    return m_space == ViewSpace::World
               ? presetCamera(preset, *m_content, m_options, viewFrame().size, m_camera.orthographic)
               : pointCamera(preset, *m_point, m_options, viewFrame().size, m_camera.orthographic);
}

void SceneView::go(ViewPreset preset) {
    if (!shown()) return;
    m_touched = preset != ViewPreset::Iso;
    flyTo(cameraOf(preset), kFlightMilliseconds);
}

void SceneView::zoomOut() {
    if (m_space != ViewSpace::World || !m_content) return;
    ViewOptions options = m_options;
    options.eye = options.frustum = true;
    setOptions(options);
    emit optionsChanged();
    m_touched = true;
    OrbitCamera outside = cameraOf(ViewPreset::Outside);
    m_camera = cameraOf(ViewPreset::Eye);
    flyTo(outside, kZoomOutMilliseconds);
}

void SceneView::flyTo(const OrbitCamera& camera, int milliseconds) {
    m_flight.stop();
    m_flight.setDuration(milliseconds);
    m_from = m_camera;
    m_to = camera;
    m_flight.start();
}

void SceneView::setOrthographic(bool orthographic) {
    if (orthographic == m_camera.orthographic) return;
    m_camera.orthographic = m_to.orthographic = orthographic;
    frameIfUntouched();
    refresh();
    emit orthographicChanged(orthographic);
}

void SceneView::frameIfUntouched() {
    if (m_touched || !shown()) return;
    m_flight.stop();
    m_camera = cameraOf(ViewPreset::Iso);
}

void SceneView::refresh() {
    const bool works = m_problem.isEmpty() && shown() != nullptr;
    ViewOptions options = m_options;
    if (m_alone != VectorCode::None) {
        options.vectors = true;
        options.shown.fill(false);
        options.shown[static_cast<std::size_t>(m_alone)] = true;
    }
    if (!works)
        m_drawing = {};
    else if (m_space == ViewSpace::World)
        m_drawing = drawWorld(*m_content, options, viewFrame());
    else
        m_drawing = drawPoint(*m_point, options, viewFrame());
    if (m_vtk) m_vtk->setView(viewFrame(), m_drawing);
    m_sentence->setText(!m_problem.isEmpty() ? m_problem
                        : !m_content         ? m_emptyText
                                             : tr("Click a pixel of an object to see the vectors at its point."));
    m_sentence->setVisible(!works);
    m_legend->setVisible(works);
    m_cube->setVisible(works && m_space == ViewSpace::World);
    m_legend->setOptions(m_options);
    m_cube->setCamera(m_camera);
    m_overlay->update();
}

void SceneView::applyTheme() {
    const ThemeColors& colors = Theme::current().colors();
    QPalette palette;
    palette.setColor(QPalette::Window, colors.view);
    setPalette(palette);
    if (m_vtk) m_vtk->setColors(colors);
    m_sentence->setFont(Theme::current().text(13));
    placeCorners();
    refresh();
}

void SceneView::placeCorners() {
    const int margin = Theme::current().px(8);
    if (m_vtk) m_vtk->setGeometry(rect());
    m_overlay->setGeometry(rect());
    m_sentence->setGeometry(rect().adjusted(margin, margin, -margin, -margin));
    m_legend->resize(m_legend->sizeHint());
    m_legend->move(margin, height() - margin - m_legend->height());
    m_cube->resize(m_cube->sizeHint());
    // Where the two would meet, the cube stands above.
    const bool narrow = width() < m_legend->width() + m_cube->width() + 3 * margin;
    m_cube->move(width() - margin - m_cube->width(),
                 height() - margin - m_cube->height() - (narrow ? m_legend->height() + margin : 0));
    m_legend->update();
    m_cube->update();
}

void SceneView::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    placeCorners();
    frameIfUntouched();
    refresh();
}

Ray SceneView::rayAt(QPointF position) const {
    return rayThrough(m_camera, viewFrame().size, {position.x(), position.y()});
}

void SceneView::mousePressEvent(QMouseEvent* event) {
    m_pressedAt = m_last = event->position();
    const bool shift = event->modifiers() & Qt::ShiftModifier, control = event->modifiers() & Qt::ControlModifier;
    if (event->button() == Qt::MiddleButton || (event->button() == Qt::LeftButton && shift)) {
        m_drag = Drag::Pan;
    } else if (event->button() == Qt::LeftButton) {
        m_drag = control && m_space == ViewSpace::World ? Drag::Pick : Drag::Click;
        if (m_drag == Drag::Pick) emit clicked(rayAt(event->position()));
    }
}

void SceneView::mouseMoveEvent(QMouseEvent* event) {
    const QPointF position = event->position(), d = position - m_last;
    if (m_drag == Drag::None) {
        if (m_content && m_space == ViewSpace::World) emit hovered(rayAt(position));
        return;
    }
    if (m_drag == Drag::Pick) {
        emit clicked(rayAt(position));
        return;
    }
    // A click may tremble by a few pixels before it is a drag.
    if (m_drag == Drag::Click && (position - m_pressedAt).manhattanLength() < kClickSlop) return;
    if (m_drag == Drag::Click) m_drag = Drag::Orbit;
    m_last = position;
    m_flight.stop();
    m_touched = true;
    if (m_drag == Drag::Orbit)
        orbit(m_camera, -d.x() * kDegreesPerPixel, d.y() * kDegreesPerPixel);
    else
        pan(m_camera, {d.x(), d.y()}, viewFrame().size);
    refresh();
}

void SceneView::mouseReleaseEvent(QMouseEvent* event) {
    if (m_drag == Drag::Click && m_content && m_space == ViewSpace::World) emit clicked(rayAt(event->position()));
    m_drag = Drag::None;
}

void SceneView::leaveEvent(QEvent* event) {
    QWidget::leaveEvent(event);
    emit left();
}

void SceneView::wheelEvent(QWheelEvent* event) {
    const double notches = event->angleDelta().y() / 120.0;
    if (!shown() || notches == 0) return;
    m_flight.stop();
    m_touched = true;
    zoomAt(m_camera, std::pow(kWheelStep, -notches), {event->position().x(), event->position().y()}, viewFrame().size);
    refresh();
    event->accept();
}

void SceneView::keyPressEvent(QKeyEvent* event) {
    const bool plain = !(event->modifiers() & ~(Qt::KeypadModifier | Qt::ShiftModifier));
    if (!plain || !shown() || !keyAction(event->key())) QWidget::keyPressEvent(event);
}

bool SceneView::keyAction(int key) {
    const auto turn = [this](double aroundZ, double overTop) {
        OrbitCamera camera = m_camera;
        orbit(camera, aroundZ, overTop);
        setCamera(camera);
    };
    const auto zoom = [this](double factor) {
        OrbitCamera camera = m_camera;
        zoomAt(camera, factor, viewFrame().size / 2.0, viewFrame().size);
        setCamera(camera);
    };
    switch (key) {
        case Qt::Key_1: go(ViewPreset::Front); return true;
        case Qt::Key_3: go(ViewPreset::Side); return true;
        case Qt::Key_7: go(ViewPreset::Top); return true;
        case Qt::Key_9:
        case Qt::Key_R: go(ViewPreset::Iso); return true;
        case Qt::Key_0: go(ViewPreset::Eye); return true;
        case Qt::Key_A: go(ViewPreset::Everything); return true;
        case Qt::Key_Z: zoomOut(); return true;
        case Qt::Key_5: setOrthographic(!m_camera.orthographic); return true;
        case Qt::Key_Left: turn(-kKeyStep, 0); return true;
        case Qt::Key_Right: turn(kKeyStep, 0); return true;
        case Qt::Key_Up: turn(0, kKeyStep); return true;
        case Qt::Key_Down: turn(0, -kKeyStep); return true;
        case Qt::Key_Plus:
        case Qt::Key_Equal: zoom(1 / kWheelStep); return true;
        case Qt::Key_Minus: zoom(kWheelStep); return true;
        default: return false;
    }
}

}  // namespace app
