#include "app/view3d/view_progress.h"

#include <QLabel>

#include "app/look/numbers.h"
#include "app/look/theme.h"
#include "app/look/working_bar.h"
#include "app/view3d/scene_view.h"
#include "app/vtk/vtk_widget.h"

namespace app {

ViewProgress::ViewProgress(SceneView& view, VtkWidget* vtk)
    : m_view(view), m_vtk(vtk), m_working(new WorkingBar(&view)), m_coarse(new QLabel(&view)) {
    m_coarse->setObjectName("coarse");
    m_coarse->setProperty("kind", "overlay");
    m_coarse->setAttribute(Qt::WA_TransparentForMouseEvents);
    m_coarse->hide();
    if (!vtk) return;
    connect(vtk, &VtkWidget::busyChanged, this, [this](bool busy) {
        m_rendering = busy;
        tell();
        emit renderingChanged(busy);
    });
}

void ViewProgress::cancel() { m_vtk ? m_vtk->cancel() : void(); }

void ViewProgress::resume() { m_vtk ? m_vtk->resume() : void(); }

void ViewProgress::setBuilding(bool building) {
    m_building = building;
    tell();
}

void ViewProgress::tell() {
    m_working->setWorking(m_rendering || m_building);
    // Without the first picture there would be nothing to see: nobody is asked to stop that one.
    emit workingChanged(m_building || (m_rendering && m_vtk->shown()));
}

void ViewProgress::setStopped(bool stopped) {
    m_stopped = stopped;
    m_working->setStopped(stopped);
    if (m_vtk) showDetail();
}

void ViewProgress::showDetail() {
    const bool isCoarse = m_vtk->isCoarse() && m_view.space().shown();
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
