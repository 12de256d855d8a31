#pragma once
#include <vtkGenericOpenGLRenderWindow.h>

namespace app {

// A window of VTK whose OpenGL context was made by EGL: without a display, or under Wayland. Debian's GLEW is built for
// GLX: in an EGL context glewInit loads every function and then reports that there is no GLX display, which VTK 9.1 takes
// for a failure.
class EglRenderWindow : public vtkGenericOpenGLRenderWindow {
public:
    static EglRenderWindow* New();
    void OpenGLInitContext() override;
    vtkTypeMacro(EglRenderWindow, vtkGenericOpenGLRenderWindow)
};

}  // namespace app
