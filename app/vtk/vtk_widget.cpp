#include "app/vtk/vtk_widget.h"

#include <QOpenGLContext>
#include <QPainter>
#include <cmath>
#include <future>
#include <utility>

namespace app {

namespace {

constexpr int kRestMilliseconds = 180;  // without a new view: it rests

}  // namespace

QString noOpenGl() { return VtkWidget::tr("This machine gives no OpenGL 3.2. Buffers still work."); }

QString openGlProblem() {
    const QString problem = noOpenGl();
    QOpenGLContext context;
    context.setFormat(viewSurfaceFormat());
    if (!context.create() || context.isOpenGLES() || context.format().version() < qMakePair(3, 2)) return problem;
    QOffscreenSurface surface;
    surface.setFormat(context.format());
    surface.create();
    if (!surface.isValid() || !context.makeCurrent(&surface)) return problem;
    context.doneCurrent();
    return {};
}

VtkWidget::VtkWidget(QWidget* parent) : QWidget(parent), m_renderer(std::make_shared<std::unique_ptr<VtkRenderer>>()) {
    setAttribute(Qt::WA_OpaquePaintEvent);
    m_surface.setFormat(viewSurfaceFormat());
    m_next.drawing = std::make_shared<const Drawing>();
    m_next.colors = std::make_shared<const ThemeColors>(Theme::current().colors());
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRestMilliseconds);
    connect(&m_job, &BackgroundJob::busyChanged, this, &VtkWidget::busyChanged);
    connect(&m_rest, &QTimer::timeout, this, [this] {
        if (!m_isWhole && !m_job.busy()) soon();
    });
}

VtkWidget::~VtkWidget() {
    m_job.disconnect(this);  // who would be told is half gone
    std::promise<void> gone;
    m_job.ask(
        [renderer = m_renderer, &gone](const BackgroundJob::Control&) {
            renderer->reset();
            gone.set_value();
            return true;
        },
        [](bool) {});
    gone.get_future().wait();
}

void VtkWidget::soon() {
    if (m_pending || m_fails) return;
    m_pending = true;
    QMetaObject::invokeMethod(this, &VtkWidget::render, Qt::QueuedConnection);
}

void VtkWidget::cancel() {
    m_rest.stop();
    m_job.forget();
}

void VtkWidget::render() {
    m_pending = false;
    const double ratio = devicePixelRatioF();
    m_next.size = QSize(int(std::lround(width() * ratio)), int(std::lround(height() * ratio)));
    m_next.pixelRatio = ratio;
    m_next.moves = m_rest.isActive();
    if (!isVisible() || m_next.size.isEmpty()) return;
    if (!m_surface.isValid()) m_surface.create();
    struct Rendered {
        bool works = false;
        VtkRenderer::Result result;
    };
    const auto snapshot = std::make_shared<const ViewSnapshot>(m_next);
    m_job.ask(
        [renderer = m_renderer, surface = &m_surface, snapshot](const BackgroundJob::Control& control) {
            if (!*renderer) *renderer = std::make_unique<VtkRenderer>(*surface);
            Rendered rendered;
            rendered.works = (*renderer)->works();
            if (rendered.works) rendered.result = (*renderer)->render(*snapshot, control.stop);
            return rendered;
        },
        [this, snapshot](const Rendered& rendered) {
            // Told once: whoever hears of it sets another view, which would only fail again.
            if (!rendered.works && !std::exchange(m_fails, true)) emit unusable();
            if (rendered.result.image.isNull()) return;
            m_picture = rendered.result.image;
            m_isWhole = rendered.result.isWhole;
            m_isCoarse = rendered.result.isCoarse;
            m_shown = snapshot;
            if (!m_isWhole && !m_rest.isActive()) soon();
            update();
            emit drawn();
        },
        std::exchange(m_rests, !snapshot->moves) && snapshot->moves ? BackgroundJob::Running::Stop
                                                                    : BackgroundJob::Running::Finish);
}

void VtkWidget::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    if (m_picture.isNull())
        painter.fillRect(rect(), m_next.colors->view);
    else  // in the size of the view before, until the next one is there
        painter.drawImage(rect(), m_picture);
}

void VtkWidget::resizeEvent(QResizeEvent*) { soon(); }

void VtkWidget::showEvent(QShowEvent*) { soon(); }

void VtkWidget::setContent(std::shared_ptr<const ViewContent> content, std::vector<InkedLine> ground) {
    m_next.content = std::move(content);
    m_next.ground = std::make_shared<const std::vector<InkedLine>>(std::move(ground));
    soon();
}

void VtkWidget::setOptions(const ViewOptions& options) {
    m_next.options = options;
    soon();
}

void VtkWidget::setColors(const ThemeColors& colors) {
    m_next.colors = std::make_shared<const ThemeColors>(colors);
    soon();
}

void VtkWidget::setView(const ViewFrame& view, Drawing drawing) {
    m_next.view = view;
    m_next.drawing = std::make_shared<const Drawing>(std::move(drawing));
    m_rest.start();
    soon();
}

}  // namespace app
