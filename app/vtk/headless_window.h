#pragma once
#include <QImage>
#include <memory>

#include <glm/glm.hpp>

#include "pipeline/core/result.h"

class vtkOpenGLRenderWindow;

namespace app {

// A render window of VTK in an OpenGL context without a display (EGL, surfaceless). The context
// is current from create() until the window is destroyed, on the thread that made it.
class HeadlessWindow {
public:
    // Errors: the machine has no EGL, or none that gives OpenGL 3.2.
    static pipeline::Result<std::shared_ptr<HeadlessWindow>> create(glm::ivec2 size);
    ~HeadlessWindow();
    HeadlessWindow(const HeadlessWindow&) = delete;
    HeadlessWindow& operator=(const HeadlessWindow&) = delete;

    vtkOpenGLRenderWindow& window();
    QImage render();  // what the window's renderers show, row 0 on top

private:
    struct Context;
    HeadlessWindow(std::unique_ptr<Context> context, glm::ivec2 size);
    std::unique_ptr<Context> m_context;
    struct Window;
    std::unique_ptr<Window> m_window;
    glm::ivec2 m_size;
};

}  // namespace app
