#pragma once
#include <QObject>

class QLabel;

namespace app {

class SceneView;
class VtkWidget;
class WorkingBar;

// What a 3D view says about its picture while another one is on its way.
class ViewProgress : public QObject {
    Q_OBJECT
public:
    ViewProgress(SceneView& view, VtkWidget* vtk);  // null where there is no OpenGL

    void setBuilding(bool building);  // newer content is on its way
    void setStopped(bool stopped);    // it was, and has been given up
    void cancel();                    // what is being drawn
    void resume();                    // it is drawn after all
    void showDetail();                // what a view that moves leaves out of a large mesh

signals:
    void renderingChanged(bool renders);
    void workingChanged(bool working);  // a newer picture is on its way

private:
    void tell();

    SceneView& m_view;
    VtkWidget* m_vtk;
    WorkingBar* m_working;
    QLabel* m_coarse;
    bool m_rendering = false, m_building = false, m_stopped = false;
};

}  // namespace app
