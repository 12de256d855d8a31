#pragma once
#include <QOffscreenSurface>
#include <QTimer>
#include <QWidget>
#include <memory>

#include "app/core/background_job.h"
#include "app/view3d/vtk_renderer.h"

namespace app {

// Why this machine cannot show 3D views, in a sentence; empty where it can.
QString openGlProblem();
QString noOpenGl();  // that sentence

// A widget that shows what VTK renders, beside the screen and on a thread of its own: where the processor is the
// OpenGL, or a mesh is large, the window neither waits for it nor is put together by it. The newest picture stays until
// the next one is there. It knows nothing of the mouse and the keys; VTK's own keys act on nothing, because there is no
// interactor.
class VtkWidget : public QWidget {
    Q_OBJECT
public:
    explicit VtkWidget(QWidget* parent = nullptr);
    ~VtkWidget() override;  // waits for the picture that is being rendered

    // What the next picture shows.
    void setContent(std::shared_ptr<const ViewContent> content, std::vector<InkedLine> ground);
    void setOptions(const ViewOptions& options);
    void setColors(const ThemeColors& colors);
    // While views follow each other quickly on a machine too slow for it, edges are not smoothed, and of many faces few
    // are drawn; all is again when the view rests. A whole picture that is not there when it moves again is given up.
    void setView(const ViewFrame& view, Drawing drawing);

    void cancel();  // what is being rendered; the picture before stays
    void resume() { soon(); }

    // What the picture on show was made of; null before the first.
    const std::shared_ptr<const ViewSnapshot>& shown() const { return m_shown; }
    bool isNewest() const { return !m_pending && !m_job.busy(); }                     // it shows all that was set
    bool isDrawn() const { return isNewest() && (m_isWhole || !m_rest.isActive()); }  // and so it stays
    bool isCoarse() const { return m_isCoarse; }  // the picture on show has few of its many faces

signals:
    // OpenGL came up, but not in a version that VTK can use, or not beside the window. Nothing will be drawn.
    void unusable();
    void drawn();                 // another picture is on show
    void busyChanged(bool busy);  // it is being rendered

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void soon();
    void render();

    ViewSnapshot m_next;
    std::shared_ptr<const ViewSnapshot> m_shown;
    QImage m_picture;
    bool m_isWhole = false, m_isCoarse = false;  // the picture is
    bool m_rests = false;                        // what was asked for last is of a view at rest
    bool m_fails = false;                        // for good: nothing is tried again
    bool m_pending = false;                      // render() runs when control returns to the event loop
    QTimer m_rest;                               // runs while the view moves
    QOffscreenSurface m_surface;
    std::shared_ptr<std::unique_ptr<VtkRenderer>> m_renderer;  // only the thread of the job looks into it
    BackgroundJob m_job;                                       // last: its thread uses the others
};

}  // namespace app
