#include "app/vtk/headless_window.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>

#include "app/vtk/egl_render_window.h"

namespace app {

static pipeline::Error noContext(const char* found) {
    return {{}, found, "an EGL that gives OpenGL 3.2 without a display"};
}

struct HeadlessWindow::Context {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;

    Context() = default;
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
    ~Context() {
        if (display == EGL_NO_DISPLAY) return;
        if (context != EGL_NO_CONTEXT) {
            eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
            eglDestroyContext(display, context);
        }
        eglTerminate(display);
    }

    bool makeCurrent() const { return eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_TRUE; }

    pipeline::Result<bool> open() {
        const auto getDisplay =
            reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
        if (!getDisplay) return noContext("this EGL has no platform displays");
        display = getDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
        if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) {
            display = EGL_NO_DISPLAY;
            return noContext("no surfaceless EGL display");
        }
        if (!eglBindAPI(EGL_OPENGL_API)) return noContext("this EGL gives no desktop OpenGL");
        constexpr std::array<EGLint, 3> kConfig{EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
        constexpr std::array<EGLint, 7> kVersion{
            EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 2, EGL_CONTEXT_OPENGL_PROFILE_MASK,
            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        if (!eglChooseConfig(display, kConfig.data(), &config, 1, &count) || count == 0) config = EGL_NO_CONFIG_KHR;
        context = eglCreateContext(display, config, EGL_NO_CONTEXT, kVersion.data());
        if (context == EGL_NO_CONTEXT || !makeCurrent()) return noContext("no OpenGL 3.2 context");
        return true;
    }
};

struct HeadlessWindow::Window {
    vtkSmartPointer<EglRenderWindow> vtk;
};

pipeline::Result<std::shared_ptr<HeadlessWindow>> HeadlessWindow::create(glm::ivec2 size) {
    auto context = std::make_unique<Context>();
    if (const auto opened = context->open(); !opened) return opened.errors();
    return std::shared_ptr<HeadlessWindow>(new HeadlessWindow(std::move(context), size));
}

HeadlessWindow::HeadlessWindow(std::unique_ptr<Context> context, glm::ivec2 size)
    : m_context(std::move(context)), m_window(std::make_unique<Window>()), m_size(size) {
    auto window = vtkSmartPointer<EglRenderWindow>::New();
    m_window->vtk = window;
    // VTK asks before each use; both answers are about the one context there is.
    auto makeCurrent = vtkSmartPointer<vtkCallbackCommand>::New();
    makeCurrent->SetClientData(m_context.get());
    makeCurrent->SetCallback(
        [](vtkObject*, unsigned long, void* data, void*) { static_cast<Context*>(data)->makeCurrent(); });
    auto isCurrent = vtkSmartPointer<vtkCallbackCommand>::New();
    isCurrent->SetClientData(m_context.get());
    isCurrent->SetCallback([](vtkObject*, unsigned long, void* data, void* answer) {
        *static_cast<bool*>(answer) = eglGetCurrentContext() == static_cast<Context*>(data)->context;
    });
    window->AddObserver(vtkCommand::WindowMakeCurrentEvent, makeCurrent);
    window->AddObserver(vtkCommand::WindowIsCurrentEvent, isCurrent);
    window->SetMultiSamples(4);
    window->SetForceMaximumHardwareLineWidth(1);
    window->SetReadyForRendering(true);
    window->SetOwnContext(0);
    window->OpenGLInitContext();
    window->SetFrameBlitModeToNoBlit();
    window->SetSize(size.x, size.y);
}

HeadlessWindow::~HeadlessWindow() {
    if (m_context->makeCurrent()) m_window->vtk->Finalize();
    m_window.reset();
}

vtkOpenGLRenderWindow& HeadlessWindow::window() { return *m_window->vtk; }

QImage HeadlessWindow::render() {
    m_context->makeCurrent();
    m_window->vtk->Render();
    auto pixels = vtkSmartPointer<vtkUnsignedCharArray>::New();
    m_window->vtk->GetPixelData(0, 0, m_size.x - 1, m_size.y - 1, 0, pixels, 0);
    QImage image(m_size.x, m_size.y, QImage::Format_RGB888);
    const auto row = static_cast<std::size_t>(m_size.x) * 3;
    for (int y = 0; y < m_size.y; ++y)  // OpenGL's first row is the lowest
        std::copy_n(pixels->GetPointer(vtkIdType(row) * (m_size.y - 1 - y)), row, image.scanLine(y));
    return image;
}

}  // namespace app
