#pragma once
#include <QOpenGLWidget>
#include <QSurfaceFormat>
#include <memory>

#include "app/view3d/drawing.h"
#include "app/view3d/view_content.h"
#include "app/view3d/view_options.h"

namespace app {

// What VTK's renderer needs. A program sets it as the default format before its QApplication.
QSurfaceFormat viewSurfaceFormat();
// Why this machine cannot show 3D views, in a sentence; empty where it can.
QString openGlProblem();

// A widget that VTK renders into: VTK's render window in Qt's OpenGL context. It knows nothing of
// the mouse and the keys; VTK's own keys act on nothing, because there is no interactor.
class VtkWidget : public QOpenGLWidget {
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
    void initializeGL() override;
    void paintGL() override;

private:
    void release();
    struct Impl;  // keeps VTK out of this header
    std::unique_ptr<Impl> m_impl;
};

}  // namespace app
