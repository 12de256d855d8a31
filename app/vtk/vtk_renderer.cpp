#include "app/vtk/vtk_renderer.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkSmartPointer.h>

#include <QElapsedTimer>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <algorithm>
#include <utility>

#include "app/vtk/egl_render_window.h"
#include "app/vtk/vtk_mutex.h"
#include "app/vtk/world_scene.h"

namespace app {

namespace {

constexpr int kSamples = 4;                // a pixel, where edges are smoothed
constexpr double kWholeMilliseconds = 40;  // that a moving view's picture may take with them and with all faces

}  // namespace

struct VtkRenderer::Impl {
    explicit Impl(QSurface& drawsOn) : surface(drawsOn) {}

    QSurface& surface;
    QOpenGLContext context;
    vtkSmartPointer<vtkGenericOpenGLRenderWindow> window;  // null where it does not work
    std::unique_ptr<WorldScene> scene;
    ViewSnapshot last;
    std::vector<quint32> pixels;   // as OpenGL gives them
    double wholeMilliseconds = 0;  // what the last whole picture took
    std::stop_token stop;          // of the picture that is rendered
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

VtkRenderer::VtkRenderer(QSurface& surface) : m_impl(std::make_unique<Impl>(surface)) {
    Impl& impl = *m_impl;
    impl.context.setFormat(viewSurfaceFormat());
    if (!impl.context.create() || impl.context.isOpenGLES() || impl.context.format().version() < qMakePair(3, 2) ||
        !impl.context.makeCurrent(&surface))
        return;
    const std::lock_guard turn(vtkMutex());
    // Under Wayland Qt makes its contexts by EGL.
    const bool isEgl = impl.context.nativeInterface<QNativeInterface::QEGLContext>() != nullptr;
    vtkSmartPointer<vtkGenericOpenGLRenderWindow> window;
    if (isEgl)
        window = vtkSmartPointer<EglRenderWindow>::New();
    else
        window = vtkSmartPointer<vtkGenericOpenGLRenderWindow>::New();
    auto makeCurrent = vtkSmartPointer<vtkCallbackCommand>::New();
    makeCurrent->SetClientData(&impl);
    makeCurrent->SetCallback([](vtkObject*, unsigned long, void* client, void*) {
        auto* self = static_cast<Impl*>(client);
        self->context.makeCurrent(&self->surface);
    });
    auto isCurrent = vtkSmartPointer<vtkCallbackCommand>::New();
    isCurrent->SetClientData(&impl);
    isCurrent->SetCallback([](vtkObject*, unsigned long, void* client, void* answer) {
        *static_cast<bool*>(answer) = QOpenGLContext::currentContext() == &static_cast<Impl*>(client)->context;
    });
    window->AddObserver(vtkCommand::WindowMakeCurrentEvent, makeCurrent);
    window->AddObserver(vtkCommand::WindowIsCurrentEvent, isCurrent);
    // VTK asks between what it draws, five times a second at most.
    auto checkAbort = vtkSmartPointer<vtkCallbackCommand>::New();
    checkAbort->SetClientData(&impl);
    checkAbort->SetCallback([](vtkObject*, unsigned long, void* client, void*) {
        auto* self = static_cast<Impl*>(client);
        if (self->stop.stop_requested()) self->window->SetAbortRender(1);
    });
    window->AddObserver(vtkCommand::AbortCheckEvent, checkAbort);
    window->SetMultiSamples(kSamples);
    window->SetForceMaximumHardwareLineWidth(1);
    window->SetReadyForRendering(true);
    window->SetOwnContext(0);
    window->OpenGLInitContext();
    window->SetFrameBlitModeToNoBlit();
    impl.window = window;
    impl.scene = std::make_unique<WorldScene>(*window);
}

VtkRenderer::~VtkRenderer() {
    Impl& impl = *m_impl;
    if (!impl.window) return;
    const std::lock_guard turn(vtkMutex());
    impl.context.makeCurrent(&impl.surface);
    impl.window->ReleaseGraphicsResources(impl.window);
    impl.scene.reset();
    impl.window = nullptr;
    impl.context.doneCurrent();
}

bool VtkRenderer::works() const { return m_impl->window != nullptr; }

void VtkRenderer::set(const ViewSnapshot& snapshot) {
    WorldScene& scene = *m_impl->scene;
    const ViewSnapshot& last = m_impl->last;
    const bool otherColors = snapshot.colors != last.colors, otherOptions = snapshot.options != last.options;
    if (otherColors) scene.setColors(*snapshot.colors);
    if (snapshot.content != last.content || snapshot.ground != last.ground)
        scene.setContent(snapshot.content, snapshot.ground ? *snapshot.ground : std::vector<InkedLine>());
    if (otherOptions) scene.setOptions(snapshot.options);
    if (otherColors || otherOptions || snapshot.drawing != last.drawing || snapshot.pixelRatio != last.pixelRatio)
        scene.setView(snapshot.view, *snapshot.drawing, snapshot.pixelRatio);
    m_impl->last = snapshot;
}

VtkRenderer::Result VtkRenderer::render(const ViewSnapshot& snapshot, const std::stop_token& stop) {
    Impl& impl = *m_impl;
    const std::lock_guard turn(vtkMutex());
    if (stop.stop_requested() || !impl.context.makeCurrent(&impl.surface)) return {};
    const bool isWhole = !snapshot.moves || impl.wholeMilliseconds < kWholeMilliseconds;
    const bool isCoarse = !isWhole && snapshot.content && snapshot.content->mesh->coarse;
    impl.scene->setCoarse(isCoarse);
    set(snapshot);
    if (stop.stop_requested()) return {};

    impl.stop = stop;
    const QSize size = snapshot.size;
    impl.window->SetMultiSamples(isWhole ? kSamples : 0);
    impl.window->SetSize(size.width(), size.height());
    QElapsedTimer timer;
    timer.start();
    impl.window->Render();
    if (stop.stop_requested()) return {};
    std::vector<quint32>& pixels = impl.pixels;
    pixels.resize(std::size_t(size.width()) * std::size_t(size.height()));
    QOpenGLExtraFunctions* gl = impl.context.extraFunctions();
    impl.window->GetDisplayFramebuffer()->Bind(GL_READ_FRAMEBUFFER);
    gl->glPixelStorei(GL_PACK_ALIGNMENT, 4);
    gl->glReadPixels(0, 0, size.width(), size.height(), GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, pixels.data());
    if (isWhole) impl.wholeMilliseconds = double(timer.nsecsElapsed()) * 1e-6;
    QImage image(size, QImage::Format_RGB32);
    image.setDevicePixelRatio(snapshot.pixelRatio);
    // OpenGL's first row is the lowest, and its alpha the coverage of smoothed edges.
    const auto row = std::size_t(size.width());
    for (int y = 0; y < size.height(); ++y)
        std::transform(pixels.begin() + std::ptrdiff_t(row) * (size.height() - 1 - y),
                       pixels.begin() + std::ptrdiff_t(row) * (size.height() - y),
                       reinterpret_cast<quint32*>(image.scanLine(y)),
                       [](quint32 pixel) { return pixel | 0xff000000u; });
    return {std::move(image), isWhole, isCoarse};
}

}  // namespace app
