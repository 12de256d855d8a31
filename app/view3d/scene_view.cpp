#include "app/view3d/scene_view.h"

#include <QPainter>
#include <QStyle>
#include <utility>

#include "app/core/large_frame.h"
#include "app/core/numbers.h"
#include "app/core/spoken.h"
#include "app/core/text.h"
#include "app/core/theme.h"
#include "app/view3d/overlay.h"
#include "app/view3d/point_drawing.h"
#include "app/view3d/view_corner.h"

namespace app {

namespace {

constexpr int kFlightMilliseconds = 250, kZoomOutMilliseconds = 1200, kMoveMilliseconds = 400;

// A desktop that asks for less motion gives its style no time for it.
bool wantsMotion(const QWidget& widget) {
    return widget.style()->styleHint(QStyle::SH_Widget_Animation_Duration, nullptr, &widget) > 0;
}

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
        // Letters stand at what the picture shows, which may be a little late.
        if (const auto& picture = m_view->m_vtk->shown()) {
            if (!m_view->isInMotion()) m_labels.clear();
            m_labels = placeLabels(*picture->drawing, picture->view, m_view->takenPlaces(), m_labels);
            paintOverlay(painter, *picture->drawing, picture->view, m_labels);
        }
        m_view->paintHandles(painter);
        if (!m_view->m_probe || m_view->isPoint() || m_view->isMoving()) return;
        const SpaceMap& map = m_view->shown()->map;
        if (!map.keepsLengths() && depthOf(map.view, *m_view->m_probe) < map.view.near) return;
        paintProbe(painter, map.toSpace(*m_view->m_probe), m_view->viewFrame());
    }

private:
    SceneView* m_view;
    std::vector<PlacedLabel> m_labels;
};

SceneView::SceneView(QWidget* parent) : QWidget(parent), m_problem(openGlProblem()) {
    speakAs(*this, QAccessible::Graphic);
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
                m_problem = noOpenGl();
                refresh();
            },
            Qt::QueuedConnection);
        connect(m_vtk, &VtkWidget::drawn, this, [this] {
            m_overlay->update();
            showDetail();
            emit drawn();
        });
        connect(m_vtk, &VtkWidget::busyChanged, this, [this](bool busy) {
            m_rendering = busy;
            tellWorking();
            emit renderingChanged(busy);
        });
    }
    m_overlay = new Overlay(this);
    m_legend = new ViewCorner(ViewCorner::Kind::Legend, this);
    m_cube = new ViewCorner(ViewCorner::Kind::Cube, this);
    m_legend->setObjectName("legend");
    m_cube->setObjectName("cube");
    m_working = new WorkingBar(this);
    m_coarse = new QLabel(this);
    m_coarse->setObjectName("coarse");
    m_coarse->setProperty("kind", "overlay");
    m_coarse->setAttribute(Qt::WA_TransparentForMouseEvents);
    m_coarse->hide();
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
        pointAt(code == VectorCode::None ? std::vector<VectorCode>{} : std::vector{code});
    });
    connect(m_cube, &ViewCorner::faceClicked, this, [this](CubeFace face) {
        if (!shown() || isPoint()) return;
        endMove();
        if (face == CubeFace::Middle) return go(ViewPreset::Iso);
        OrbitCamera camera = cameraOf(ViewPreset::Front);
        lookAlong(camera, directionOf(face));
        frame(camera, sceneExtent(*shown(), m_options), viewFrame().size, 0.11, takenFoot());
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
    m_move.setStartValue(0.0);
    m_move.setEndValue(1.0);
    m_move.setDuration(kMoveMilliseconds);
    m_move.setEasingCurve(QEasingCurve::OutCubic);
    connect(&m_move, &QVariantAnimation::valueChanged, this, [this](const QVariant& t) {
        if (!m_morph) return;
        m_camera.fovY = m_morph->camera(t.toDouble()).fovY;
        if (m_vtk) m_vtk->setContent(std::make_shared<const ViewContent>(m_morph->content(t.toDouble())), {});
        refresh();
    });
    connect(&m_move, &QVariantAnimation::finished, this, &SceneView::endMove);
    connect(&Theme::current(), &Theme::changed, this, &SceneView::applyTheme);
    applyTheme();
}

SceneView::~SceneView() {
    m_flight.disconnect(this);
    m_move.disconnect(this);
}

const std::shared_ptr<const ViewContent>& SceneView::shown() const { return isWorld() ? m_content : m_moved; }

ViewFrame SceneView::viewFrame() const {
    return {m_camera, {std::max(width(), 1), std::max(height(), 1)}, Theme::current().scale()};
}

void SceneView::setContent(std::shared_ptr<const ViewContent> content, bool newScene,
                           std::shared_ptr<const ViewContent> moved) {
    m_content = std::move(content);
    if (moved) m_moved = std::move(moved);
    if (newScene) {
        m_touched = false;
        m_cameras.clear();
    }
    endMove();
    showContent();
}

void SceneView::setEmptyText(const QString& sentence) {
    m_emptyText = sentence;
    refresh();
}

void SceneView::pointAt(const std::vector<VectorCode>& codes) {
    if (codes == m_pointedAt) return;
    m_pointedAt = codes;
    refresh();
}

void SceneView::setProbe(std::optional<Vec3d> point) {
    m_probe = point;
    m_overlay->update();
}

void SceneView::setSpace(SpaceId space, std::shared_ptr<const ViewContent> moved) {
    if (space == m_space) return;
    m_flight.stop();
    endMove();
    const OrbitCamera before = m_camera;
    const auto from = m_content ? mapOf(*m_content, m_space) : std::nullopt;
    if (m_touched) m_cameras[m_space] = m_camera;
    m_space = space;
    const auto kept = m_cameras.find(space);
    m_touched = kept != m_cameras.end();
    m_camera = m_touched ? kept->second : OrbitCamera();
    m_camera.orthographic = before.orthographic;
    if (moved) m_moved = std::move(moved);
    showContent();
    const bool isLarge = m_content && m_content->mesh->faces.size() > kManyTriangles;  // too many to move in time
    if (from && shown() && !isPoint() && !isLarge && wantsMotion(*this)) moveTo(*from, before);
}

void SceneView::moveTo(const SpaceMap& from, const OrbitCamera& camera) {
    m_morph.emplace(*m_content, from, camera, shown()->map, m_camera);
    m_move.start();
}

void SceneView::endMove() {
    if (!m_morph) return;
    m_camera = m_morph->camera(1);
    m_morph.reset();
    m_move.stop();
    showContent();
}

void SceneView::showContent() {
    const auto before = std::exchange(m_moved, nullptr);
    if (m_content && isPoint()) m_moved = pointContent(*m_content);
    if (m_content && !isWorld() && !isPoint())
        if (const auto map = mapOf(*m_content, m_space))
            m_moved = std::make_shared<const ViewContent>(inSpace(*m_content, *map, before.get()));
    std::vector<InkedLine> ground;
    if (shown() && !isPoint() && shown()->map.keepsLengths()) ground = groundLines(*m_content);
    if (shown())
        for (InkedLine& line : ground) line.a = shown()->map.toSpace(line.a), line.b = shown()->map.toSpace(line.b);
    if (m_vtk) m_vtk->setContent(shown(), ground);
    frameIfUntouched();
    refresh();
}

void SceneView::frameAnew() {
    m_flight.stop();
    endMove();
    m_touched = false;
    frameIfUntouched();
    refresh();
}

void SceneView::setOptions(const ViewOptions& options) {
    if (options == m_options) return;
    m_options = options;
    if (m_vtk) m_vtk->setOptions(options);
    if (isPoint()) frameIfUntouched();  // a construction may reach out of the hemisphere
    refresh();
}

void SceneView::setCamera(const OrbitCamera& camera) {
    m_flight.stop();
    endMove();
    const bool turned = camera.orthographic != m_camera.orthographic;
    m_camera = camera;
    m_touched = true;
    refresh();
    if (turned) emit orthographicChanged(camera.orthographic);
}

// A low view has its room for the scene; the letters stand at their vectors.
bool SceneView::showsLegend() const {
    return m_problem.isEmpty() && shown() && shown()->map.keepsLengths() && 5 * m_legend->height() <= height();
}

double SceneView::takenFoot() const { return showsLegend() ? height() - m_legend->y() : 0; }

OrbitCamera SceneView::cameraOf(ViewPreset preset) const {
    const auto camera = isPoint() ? pointCamera : presetCamera;
    return camera(preset, *shown(), m_options, viewFrame().size, m_camera.orthographic, takenFoot());
}

void SceneView::go(ViewPreset preset) {
    if (!shown()) return;
    m_touched = preset != ViewPreset::Iso;
    flyTo(cameraOf(preset), kFlightMilliseconds);
}

void SceneView::zoomOut() {
    if (!isWorld() || !m_content) return;
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
    m_flight.setDuration(wantsMotion(*this) ? milliseconds : 0);
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
    if (!m_pointedAt.empty()) {
        if (!options.vectors) options.shown.fill(false);
        options.vectors = true;
        for (const VectorCode code : m_pointedAt) options.shown[static_cast<std::size_t>(code)] = true;
    }
    if (!works || isMoving())
        m_drawing = {};
    else
        m_drawing = (isPoint() ? drawPoint : drawWorld)(*shown(), options, viewFrame());
    dimAllBut(m_pointedAt, m_drawing);
    if (m_vtk) m_vtk->setView(viewFrame(), m_drawing);
    m_sentence->setText(sentence());
    m_sentence->setVisible(!works);
    m_legend->setVisible(showsLegend());
    m_cube->setVisible(works && !isPoint());
    m_legend->setOptions(m_options);
    m_cube->setCamera(m_camera, m_space.space);
    updateWithPicture();
}

QString SceneView::sentence() const {
    if (!m_problem.isEmpty()) return m_problem;
    if (!m_content) return m_emptyText;
    if (isPoint()) return tr("Click a pixel of an object to see the vectors at its point.");
    return tr("Light %1 has no shadow buffer in this frame, so it looks from nowhere.").arg(m_space.light);
}

void SceneView::applyTheme() {
    const ThemeColors& colors = Theme::current().colors();
    QPalette palette;
    palette.setColor(QPalette::Window, colors.view);
    setPalette(palette);
    if (m_vtk) m_vtk->setColors(colors);
    m_sentence->setFont(Theme::current().text(13));
    placeCorners();
    frameIfUntouched();  // the legend takes another part of the view
    refresh();
}

void SceneView::placeCorners() {
    const int margin = Theme::current().px(8);
    if (m_vtk) m_vtk->setGeometry(rect());
    m_overlay->setGeometry(rect());
    m_sentence->setGeometry(rect().adjusted(margin, margin, -margin, -margin));
    m_legend->setRoom(width() - 2 * margin);
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

}  // namespace app
