// What a SceneView says about its picture while another one is on its way.
#include "app/core/numbers.h"
#include "app/core/theme.h"
#include "app/view3d/scene_view.h"

namespace app {

void SceneView::setBuilding(bool building) {
    m_building = building;
    tellWorking();
}

void SceneView::tellWorking() {
    m_working->setWorking(m_rendering || m_building);
    // Without the first picture there would be nothing to see: nobody is asked to stop that one.
    emit workingChanged(m_building || (m_rendering && m_vtk->shown()));
}

void SceneView::setStopped(bool stopped) {
    m_stopped = stopped;
    m_working->setStopped(stopped);
    if (m_vtk) showDetail();
}

// What a view that moves leaves out of a large mesh.
void SceneView::showDetail() {
    const bool isCoarse = m_vtk->isCoarse() && shown();
    m_coarse->setVisible(isCoarse);
    if (!isCoarse) return;
    const ViewMesh& mesh = *m_vtk->shown()->content->mesh;
    m_coarse->setFont(Theme::current().text(12));
    const QString shows =
        tr("%1 of %2 triangles").arg(count(qint64(mesh.coarse->size())), count(qint64(mesh.faces.size())));
    m_coarse->setText(m_stopped ? tr("%1: the rest was stopped").arg(shows) : tr("%1 until it rests").arg(shows));
    m_coarse->adjustSize();
    const int margin = Theme::current().px(8);
    m_coarse->move(margin, margin);
}

}  // namespace app
