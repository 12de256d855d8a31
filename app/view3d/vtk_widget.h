#pragma once
#include <QSurfaceFormat>
#include <QWidget>
#include <memory>

#include "app/view3d/drawing.h"
#include "app/view3d/view_content.h"
#include "app/view3d/view_options.h"

namespace app {

// What VTK's renderer needs.
QSurfaceFormat viewSurfaceFormat();
// Why this machine cannot show 3D views, in a sentence; empty where it can.
QString openGlProblem();

// A widget that shows what VTK renders, in an OpenGL context of its own beside the screen: a window with a
// QOpenGLWidget in it is put together by OpenGL as a whole, every time that a letter changes anywhere in it, which
// costs more than the view does where the processor is the OpenGL. It knows nothing of the mouse and the keys; VTK's
// own keys act on nothing, because there is no interactor.
class VtkWidget : public QWidget {
    Q_OBJECT
public:
    explicit VtkWidget(QWidget* parent = nullptr);
    ~VtkWidget() override;

    // What is shown from the next painting on.
    void setContent(std::shared_ptr<const ViewContent> content, std::vector<InkedLine> ground);
    void setOptions(const ViewOptions& options);
    void setColors(const ThemeColors& colors);
    // While views follow each other quickly on a machine too slow for it, edges are not smoothed;
    // they are again when the view rests.
    void setView(const ViewFrame& view, Drawing drawing);

signals:
    // OpenGL came up, but not in a version that VTK can use. Nothing will be drawn.
    void unusable();

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    bool open();    // false: no OpenGL that VTK can use
    void render();  // what has changed since the last time, into the picture
    struct Impl;    // keeps VTK out of this header
    std::unique_ptr<Impl> m_impl;
};

}  // namespace app
