#include "app/view3d/vtk_widget.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkSmartPointer.h>

#include <QElapsedTimer>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <QPainter>
#include <QTimer>
#include <algorithm>
#include <cmath>

#include "app/view3d/vtk_turn.h"
#include "app/view3d/world_scene.h"

namespace app {

namespace {

constexpr int kSamples = 4;                 // a pixel, where edges are smoothed
constexpr double kSmoothMilliseconds = 40;  // that a moving view's frame may take with them
constexpr int kRestMilliseconds = 180;      // without a new view: it rests

}  // namespace

struct VtkWidget::Impl {
    QOffscreenSurface surface;
    std::unique_ptr<QOpenGLContext> context;
    vtkSmartPointer<vtkGenericOpenGLRenderWindow> window;
    std::unique_ptr<WorldScene> scene;
    bool failed = false;

    std::shared_ptr<const ViewContent> content;
    std::vector<InkedLine> ground;
    ViewOptions options;
    ThemeColors colors;
    ViewFrame view;
    Drawing drawing;
    std::vector<quint32> pixels;    // as OpenGL gives them
    QImage picture;                 // as it was rendered last
    QTimer rest;                    // runs while the view moves
    double smoothMilliseconds = 0;  // what the last smoothed frame took
    bool isSmooth = false;          // the picture is
    bool contentChanged = true, optionsChanged = true, colorsChanged = true, viewChanged = true;
    bool changed() const { return contentChanged || optionsChanged || colorsChanged || viewChanged; }
    bool wantsSmooth() const { return !rest.isActive() || smoothMilliseconds < kSmoothMilliseconds; }
};

QSurfaceFormat viewSurfaceFormat() {
    QSurfaceFormat format;
    format.setRenderableType(QSurfaceFormat::OpenGL);
    format.setVersion(3, 2);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    format.setStencilBufferSize(8);
    format.setAlphaBufferSize(0);
    // VTK smooths in its own framebuffer.
    format.setSamples(0);
    return format;
}

QString openGlProblem() {
    const QString problem = QStringLiteral("This machine gives no OpenGL 3.2. Buffers still work.");
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

VtkWidget::VtkWidget(QWidget* parent) : QWidget(parent), m_impl(std::make_unique<Impl>()) {
    setAttribute(Qt::WA_OpaquePaintEvent);
    m_impl->rest.setSingleShot(true);
    m_impl->rest.setInterval(kRestMilliseconds);
    connect(&m_impl->rest, &QTimer::timeout, this, [this] {
        if (!m_impl->isSmooth) update();
    });
}

VtkWidget::~VtkWidget() {
    Impl& impl = *m_impl;
    if (!impl.window) return;
    const std::lock_guard turn(vtkTurn());
    impl.context->makeCurrent(&impl.surface);
    impl.window->ReleaseGraphicsResources(impl.window);
    impl.scene.reset();
    impl.window = nullptr;
    impl.context->doneCurrent();
}

bool VtkWidget::open() {
    Impl& impl = *m_impl;
    if (impl.window || impl.failed) return !impl.failed;
    impl.context = std::make_unique<QOpenGLContext>();
    impl.context->setFormat(viewSurfaceFormat());
    const bool created = impl.context->create();
    impl.surface.setFormat(impl.context->format());
    impl.surface.create();
    if (!created || impl.context->isOpenGLES() || impl.context->format().version() < qMakePair(3, 2) ||
        !impl.context->makeCurrent(&impl.surface)) {
        impl.failed = true;
        emit unusable();
        return false;
    }
    auto window = vtkSmartPointer<vtkGenericOpenGLRenderWindow>::New();
    auto makeCurrent = vtkSmartPointer<vtkCallbackCommand>::New();
    makeCurrent->SetClientData(&impl);
    makeCurrent->SetCallback([](vtkObject*, unsigned long, void* client, void*) {
        auto* self = static_cast<Impl*>(client);
        self->context->makeCurrent(&self->surface);
    });
    auto isCurrent = vtkSmartPointer<vtkCallbackCommand>::New();
    isCurrent->SetClientData(&impl);
    isCurrent->SetCallback([](vtkObject*, unsigned long, void* client, void* answer) {
        *static_cast<bool*>(answer) = QOpenGLContext::currentContext() == static_cast<Impl*>(client)->context.get();
    });
    window->AddObserver(vtkCommand::WindowMakeCurrentEvent, makeCurrent);
    window->AddObserver(vtkCommand::WindowIsCurrentEvent, isCurrent);
    window->SetMultiSamples(kSamples);
    window->SetForceMaximumHardwareLineWidth(1);
    window->SetReadyForRendering(true);
    window->SetOwnContext(0);
    window->OpenGLInitContext();
    window->SetFrameBlitModeToNoBlit();
    impl.window = window;
    impl.scene = std::make_unique<WorldScene>(*window);
    return true;
}

void VtkWidget::render() {
    Impl& impl = *m_impl;
    const double ratio = devicePixelRatioF();
    const QSize size(int(std::lround(width() * ratio)), int(std::lround(height() * ratio)));
    if (!impl.changed() && impl.picture.size() == size && (impl.isSmooth || !impl.wantsSmooth())) return;
    const std::lock_guard turn(vtkTurn());
    if (size.isEmpty() || !open() || !impl.context->makeCurrent(&impl.surface)) return;
    if (std::exchange(impl.colorsChanged, false)) impl.scene->setColors(impl.colors);
    if (std::exchange(impl.contentChanged, false)) impl.scene->setContent(impl.content, impl.ground);
    if (std::exchange(impl.optionsChanged, false)) impl.scene->setOptions(impl.options);
    if (std::exchange(impl.viewChanged, false)) impl.scene->setView(impl.view, impl.drawing, ratio);

    impl.isSmooth = impl.wantsSmooth();
    impl.window->SetMultiSamples(impl.isSmooth ? kSamples : 0);
    impl.window->SetSize(size.width(), size.height());
    QElapsedTimer timer;
    timer.start();
    impl.window->Render();
    std::vector<quint32>& pixels = impl.pixels;
    pixels.resize(std::size_t(size.width()) * std::size_t(size.height()));
    QOpenGLExtraFunctions* gl = impl.context->extraFunctions();
    impl.window->GetDisplayFramebuffer()->Bind(GL_READ_FRAMEBUFFER);
    gl->glPixelStorei(GL_PACK_ALIGNMENT, 4);
    gl->glReadPixels(0, 0, size.width(), size.height(), GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, pixels.data());
    if (impl.isSmooth) impl.smoothMilliseconds = double(timer.nsecsElapsed()) * 1e-6;
    if (impl.picture.size() != size) impl.picture = QImage(size, QImage::Format_RGB32);
    impl.picture.setDevicePixelRatio(ratio);
    // OpenGL's first row is the lowest, and its alpha the coverage of smoothed edges.
    const auto row = std::size_t(size.width());
    for (int y = 0; y < size.height(); ++y)
        std::transform(pixels.begin() + std::ptrdiff_t(row) * (size.height() - 1 - y),
                       pixels.begin() + std::ptrdiff_t(row) * (size.height() - y),
                       reinterpret_cast<quint32*>(impl.picture.scanLine(y)),
                       [](quint32 pixel) { return pixel | 0xff000000u; });
}

void VtkWidget::paintEvent(QPaintEvent*) {
    render();
    QPainter painter(this);
    if (m_impl->picture.isNull())
        painter.fillRect(rect(), m_impl->colors.view);
    else
        painter.drawImage(0, 0, m_impl->picture);
}

void VtkWidget::setContent(std::shared_ptr<const ViewContent> content, std::vector<InkedLine> ground) {
    m_impl->content = std::move(content);
    m_impl->ground = std::move(ground);
    m_impl->contentChanged = true;
    update();
}

void VtkWidget::setOptions(const ViewOptions& options) {
    m_impl->options = options;
    m_impl->optionsChanged = m_impl->viewChanged = true;
    update();
}

void VtkWidget::setColors(const ThemeColors& colors) {
    m_impl->colors = colors;
    m_impl->colorsChanged = m_impl->viewChanged = true;
    update();
}

void VtkWidget::setView(const ViewFrame& view, Drawing drawing) {
    m_impl->view = view;
    m_impl->drawing = std::move(drawing);
    m_impl->viewChanged = true;
    m_impl->rest.start();
    update();
}

}  // namespace app
