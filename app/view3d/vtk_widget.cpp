#include "app/view3d/vtk_widget.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkSmartPointer.h>

#include <QElapsedTimer>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <QTimer>
#include <cmath>

#include "app/view3d/world_scene.h"

namespace app {

namespace {

constexpr int kSamples = 4;                 // a pixel, where edges are smoothed
constexpr double kSmoothMilliseconds = 40;  // that a moving view's frame may take with them
constexpr int kRestMilliseconds = 180;      // without a new view: it rests

}  // namespace

struct VtkWidget::Impl {
    vtkSmartPointer<vtkGenericOpenGLRenderWindow> window;
    std::unique_ptr<WorldScene> scene;

    // Kept, because the widget's context may be made anew (a docked view that is torn off).
    std::shared_ptr<const ViewContent> content;
    std::vector<InkedLine> ground;
    ViewOptions options;
    ThemeColors colors;
    ViewFrame view;
    Drawing drawing;
    QTimer rest;                    // runs while the view moves
    double smoothMilliseconds = 0;  // what the last smoothed frame took
    bool contentChanged = true, optionsChanged = true, colorsChanged = true, viewChanged = true;
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

VtkWidget::VtkWidget(QWidget* parent) : QOpenGLWidget(parent), m_impl(std::make_unique<Impl>()) {
    setFormat(viewSurfaceFormat());
    m_impl->rest.setSingleShot(true);
    m_impl->rest.setInterval(kRestMilliseconds);
    connect(&m_impl->rest, &QTimer::timeout, this, [this] { update(); });
}

VtkWidget::~VtkWidget() {
    // The base class destroys the context when the rest of this object is gone.
    if (context()) disconnect(context(), nullptr, this, nullptr);
    makeCurrent();
    release();
    doneCurrent();
}

void VtkWidget::initializeGL() {
    if (context()->isOpenGLES() || context()->format().version() < qMakePair(3, 2)) {
        emit unusable();
        return;
    }
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] {
        makeCurrent();
        release();
        doneCurrent();
    });
    auto window = vtkSmartPointer<vtkGenericOpenGLRenderWindow>::New();
    // Not QOpenGLWidget::makeCurrent(): that one binds Qt's framebuffer in the middle of VTK's frame.
    auto makeCurrent = vtkSmartPointer<vtkCallbackCommand>::New();
    makeCurrent->SetClientData(this);
    makeCurrent->SetCallback([](vtkObject*, unsigned long, void* self, void*) {
        QOpenGLContext* context = static_cast<VtkWidget*>(self)->context();
        if (context) context->makeCurrent(context->surface());
    });
    auto isCurrent = vtkSmartPointer<vtkCallbackCommand>::New();
    isCurrent->SetClientData(this);
    isCurrent->SetCallback([](vtkObject*, unsigned long, void* self, void* answer) {
        *static_cast<bool*>(answer) = QOpenGLContext::currentContext() == static_cast<VtkWidget*>(self)->context();
    });
    window->AddObserver(vtkCommand::WindowMakeCurrentEvent, makeCurrent);
    window->AddObserver(vtkCommand::WindowIsCurrentEvent, isCurrent);
    window->SetMultiSamples(kSamples);
    window->SetForceMaximumHardwareLineWidth(1);
    window->SetReadyForRendering(true);
    window->SetOwnContext(0);
    window->OpenGLInitContext();
    window->SetFrameBlitModeToNoBlit();
    m_impl->window = window;
    m_impl->scene = std::make_unique<WorldScene>(*window);
    m_impl->contentChanged = m_impl->optionsChanged = m_impl->colorsChanged = m_impl->viewChanged = true;
}

void VtkWidget::release() {
    if (!m_impl->window) return;
    m_impl->window->ReleaseGraphicsResources(m_impl->window);
    m_impl->scene.reset();
    m_impl->window = nullptr;
}

void VtkWidget::paintGL() {
    Impl& impl = *m_impl;
    if (!impl.window) return;
    if (std::exchange(impl.colorsChanged, false)) impl.scene->setColors(impl.colors);
    if (std::exchange(impl.contentChanged, false)) impl.scene->setContent(impl.content, impl.ground);
    if (std::exchange(impl.optionsChanged, false)) impl.scene->setOptions(impl.options);
    const double ratio = devicePixelRatioF();
    const int width = int(std::lround(this->width() * ratio)), height = int(std::lround(this->height() * ratio));
    if (std::exchange(impl.viewChanged, false)) impl.scene->setView(impl.view, impl.drawing, ratio);

    // Qt has used the context since the last frame; VTK believes only what it reads anew.
    impl.window->GetState()->Reset();
    const bool smooth = !impl.rest.isActive() || impl.smoothMilliseconds < kSmoothMilliseconds;
    impl.window->SetMultiSamples(smooth ? kSamples : 0);
    impl.window->SetSize(width, height);
    QElapsedTimer timer;
    timer.start();
    impl.window->Render();
    QOpenGLExtraFunctions* gl = context()->extraFunctions();
    gl->glFinish();
    if (smooth) impl.smoothMilliseconds = double(timer.nsecsElapsed()) * 1e-6;
    gl->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, defaultFramebufferObject());
    gl->glDisable(GL_SCISSOR_TEST);
    impl.window->BlitDisplayFramebuffer(0, 0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    // VTK leaves coverage in the alpha of smoothed edges, which Qt would take for transparency.
    gl->glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
    gl->glClearColor(0, 0, 0, 1);
    gl->glClear(GL_COLOR_BUFFER_BIT);
    gl->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
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
