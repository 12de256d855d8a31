#pragma once
#include <QOffscreenSurface>
#include <QTimer>
#include <QWidget>
#include <memory>

#include "app/jobs/background_job.h"
#include "app/vtk/vtk_renderer.h"

namespace app {

// Why this machine cannot show 3D views, in a sentence; empty where it can.
QString openGlProblem();
QString noOpenGl();  // that sentence

// A widget that shows what VTK renders off screen on a thread of its own, so that the window does not wait for a large
// mesh or for OpenGL in software. The previous picture stays until the next one is ready. It handles neither mouse nor
// keys, and has no interactor, so that VTK's own keys do nothing.
class VtkWidget : public QWidget {
    Q_OBJECT
public:
    explicit VtkWidget(QWidget* parent = nullptr);
    ~VtkWidget() override;  // waits for the picture that is being rendered

    // What the next picture shows.
    void setContent(std::shared_ptr<const ViewContent> content, std::vector<InkedLine> ground);
    void setOptions(const ViewOptions& options);
    void setColors(const ThemeColors& colors);
    // While the view moves on a machine too slow for it, edges are not smoothed, and few of many faces are drawn. At
    // rest the whole picture is rendered; if the view moves again before it is ready, it is stopped.
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
