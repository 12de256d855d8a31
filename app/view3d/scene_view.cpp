#include "app/view3d/scene_view.h"

#include <QLabel>
#include <QPainter>

#include "app/drawing3d/overlay.h"
#include "app/drawing3d/point_drawing.h"
#include "app/look/accessible.h"
#include "app/look/text.h"
#include "app/look/theme.h"
#include "app/view3d/space_picture.h"

namespace app {

// Letters and captions, over VTK's picture; the mouse goes through it.
class SceneView::Overlay : public QWidget {
public:
    explicit Overlay(SceneView* view) : QWidget(view), m_view(view) { setAttribute(Qt::WA_TransparentForMouseEvents); }

protected:
    void paintEvent(QPaintEvent*) override {
        const ShownSpace& space = m_view->space();
        if (!space.shown() || !m_view->m_problem.isEmpty()) return;
        QPainter painter(this);
        // Letters stand at what the picture shows, which may be a little late.
        if (const auto& picture = m_view->m_vtk->shown()) {
            const bool isInMotion = m_view->input().isHeld() || m_view->camera().isFlying();
            if (!isInMotion) m_labels.clear();
            m_labels = placeLabels(*picture->drawing, picture->view, takenPlaces(), m_labels);
            paintOverlay(painter, *picture->drawing, picture->view, m_labels);
        }
        m_view->handles().paint(painter);
        if (!m_view->m_probe || space.isPoint() || space.isMoving()) return;
        const SpaceMap& map = space.shown()->map;
        if (!map.keepsLengths() && depthOf(map.view, *m_view->m_probe) < map.view.near) return;
        paintProbe(painter, map.toSpace(*m_view->m_probe), m_view->viewFrame());
    }

private:
    // Where no word can be read.
    std::vector<QRectF> takenPlaces() const {
        std::vector<QRectF> places = m_view->corners().places();
        const std::vector<QRectF> handles = m_view->handles().places();
        places.insert(places.end(), handles.begin(), handles.end());
        return places;
    }

    SceneView* m_view;
    std::vector<PlacedLabel> m_labels;
};

SceneView::SceneView(QWidget* parent)
    : QWidget(parent),
      m_problem(openGlProblem()),
      m_space(std::make_unique<ShownSpace>(*this)),
      m_camera(std::make_unique<ViewCamera>(*this)),
      m_handles(std::make_unique<ViewHandles>(*this)),
      m_input(std::make_unique<ViewInput>(*this)) {
    setAccessibleRole(*this, QAccessible::Graphic);
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
            updateOverlay();
            m_progress->showDetail();
            emit drawn();
        });
    }
    // In this order they lie over each other.
    m_overlay = new Overlay(this);
    m_corners = std::make_unique<ViewCorners>(*this);
    m_progress = std::make_unique<ViewProgress>(*this, m_vtk);
    m_sentence = new QLabel(this);
    m_sentence->setAlignment(Qt::AlignCenter);
    m_sentence->setWordWrap(true);
    m_sentence->setAttribute(Qt::WA_TransparentForMouseEvents);
    connect(&Theme::current(), &Theme::changed, this, &SceneView::applyTheme);
    applyTheme();
}

SceneView::~SceneView() = default;

ViewFrame SceneView::viewFrame() const {
    return {m_camera->now(), {std::max(width(), 1), std::max(height(), 1)}, Theme::current().scale()};
}

// A camera that the user has not moved frames the picture as it does the view.
pipeline::Result<SpacePicture> SceneView::picture(QSize size, bool transparent) const {
    const auto& shown = m_space->shown();
    if (!shown) return pipeline::Error{{}, "the 3D view has nothing to show", {}};
    const ViewShot shot = shotOf({size.width(), size.height()}, m_space->isPoint(), m_space->isWorld(), transparent);
    const glm::dvec2 logical = glm::dvec2(shot.size) / shot.pixelRatio;
    const OrbitCamera& now = m_camera->now();
    const OrbitCamera camera =
        m_camera->isTouched() ? now : firstCamera(*shown, m_options, m_space->isPoint(), logical, now.orthographic);
    return SpacePicture{shown, m_options, camera, shot};
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
    updateOverlay();
}

void SceneView::setOptions(const ViewOptions& options) {
    if (options == m_options) return;
    m_options = options;
    if (m_vtk) m_vtk->setOptions(options);
    if (m_space->isPoint()) m_camera->frameIfUntouched();  // a construction may reach out of the hemisphere
    refresh();
}

void SceneView::changeOptions(const ViewOptions& options) {
    setOptions(options);
    emit optionsChanged();
}

void SceneView::render(std::shared_ptr<const ViewContent> content, const std::vector<InkedLine>& ground) {
    if (m_vtk) m_vtk->setContent(std::move(content), ground);
}

void SceneView::updateOverlay() { m_overlay->update(); }

void SceneView::updateWithPicture() {
    if (!m_vtk || m_vtk->isNewest()) updateOverlay();
}

void SceneView::refresh() {
    const auto& shown = m_space->shown();
    const bool works = m_problem.isEmpty() && shown != nullptr;
    ViewOptions options = m_options;
    if (!m_pointedAt.empty()) {
        if (!options.vectors) options.shown.fill(false);
        options.vectors = true;
        for (const VectorCode code : m_pointedAt) options.shown[static_cast<std::size_t>(code)] = true;
    }
    if (!works || m_space->isMoving())
        m_drawing = {};
    else
        m_drawing = (m_space->isPoint() ? drawPoint : drawWorld)(*shown, options, viewFrame());
    dimAllBut(m_pointedAt, m_drawing);
    if (m_vtk) m_vtk->setView(viewFrame(), m_drawing);
    m_sentence->setText(sentence());
    m_sentence->setVisible(!works);
    m_corners->show(works);
    updateWithPicture();
}

QString SceneView::sentence() const {
    if (!m_problem.isEmpty()) return m_problem;
    if (!m_space->content()) return m_emptyText;
    if (m_space->isPoint()) return tr("Click a pixel of an object to see the vectors at its point.");
    return tr("Light %1 has no shadow buffer in this frame, so it looks from nowhere.").arg(m_space->id().light);
}

void SceneView::applyTheme() {
    const ThemeColors& colors = Theme::current().colors();
    QPalette palette;
    palette.setColor(QPalette::Window, colors.view);
    setPalette(palette);
    if (m_vtk) m_vtk->setColors(colors);
    m_sentence->setFont(Theme::current().text(13));
    place();
    m_camera->frameIfUntouched();  // the legend takes another part of the view
    refresh();
}

void SceneView::place() {
    const int margin = Theme::current().px(8);
    if (m_vtk) m_vtk->setGeometry(rect());
    m_overlay->setGeometry(rect());
    m_sentence->setGeometry(rect().adjusted(margin, margin, -margin, -margin));
    m_corners->place();
}

void SceneView::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    place();
    m_camera->frameIfUntouched();
    refresh();
}

}  // namespace app
