#include "app/vtk/egl_render_window.h"

#include <vtkObjectFactory.h>

namespace app {

vtkStandardNewMacro(EglRenderWindow);

void EglRenderWindow::OpenGLInitContext() {
    const int warnings = vtkObject::GetGlobalWarningDisplay();
    vtkObject::SetGlobalWarningDisplay(0);
    Superclass::OpenGLInitContext();
    vtkObject::SetGlobalWarningDisplay(warnings);
    GlewInitValid = true;
    Initialized = true;
}

}  // namespace app
