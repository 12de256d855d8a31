#include "app/vtk/mesh_layers.h"

#include <vtkActor.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <utility>

#include "app/vtk/vtk_data.h"

namespace app {

namespace {

constexpr float kRestStrength = 0.55f;  // of the edges while a polygon is picked
constexpr double kEdgeWidth = 1.4;      // pixels of the design

}  // namespace

MeshLayers::MeshLayers(vtkRenderer& world)
    : m_faces(addLayer(world)), m_coarseFaces(addLayer(world)), m_edges(addLayer(world)) {
    pullLines(m_edges, 2);
    // Drawn after the faces, faded edges blend with them as they are; in VTK's pass for what is translucent they would
    // cost as much as all else.
    m_edges.actor->ForceOpaqueOn();
}

bool MeshLayers::setContent(std::shared_ptr<const ViewContent> content) {
    // A newly picked pixel comes with the mesh that is there: its polygons stay as they are.
    const bool sameMesh = m_content && content && content->mesh == m_content->mesh;
    const bool sameEdges = m_content && content && content->mesh->edges == m_content->mesh->edges &&
                           content->mesh->positions == m_content->mesh->positions;
    m_content = std::move(content);
    if (sameMesh) return false;
    if (!sameEdges) m_edges.mapper->SetInputData(edgesData(m_content ? *m_content->mesh : ViewMesh()));
    color();
    return true;
}

void MeshLayers::setFaces(FacesShown faces) {
    if (std::exchange(m_shown, faces) != faces) color();
}

void MeshLayers::setColors(const ThemeColors& colors) {
    m_colors = colors;
    color();
}

void MeshLayers::color() {
    m_isFullOld = m_isCoarseOld = true;
    makeFaces();
}

void MeshLayers::makeFaces() {
    if (!m_colors.view.isValid()) return;
    const bool isCoarse = showsCoarse(), isGlass = m_content && m_shown == FacesShown::Shaded;
    m_glass.set(isGlass ? m_content->mesh.get() : nullptr, isCoarse ? Detail::Coarse : Detail::Full,
                m_content ? m_content->faceStrength : 1, m_colors);
    m_faces.actor->SetVisibility(!isCoarse);
    m_coarseFaces.actor->SetVisibility(isCoarse);
    bool& isOld = isCoarse ? m_isCoarseOld : m_isFullOld;
    if (!isOld) return;
    isOld = false;
    (isCoarse ? m_coarseFaces : m_faces)
        .mapper->SetInputData(m_content ? facesData(*m_content->mesh, isCoarse ? Detail::Coarse : Detail::Full, m_shown,
                                                    m_content->faceStrength, m_colors)
                                        : vtkSmartPointer<vtkPolyData>::New());
}

void MeshLayers::setCoarse(bool coarse) {
    if (coarse == m_isCoarse) return;
    m_isCoarse = coarse;
    makeFaces();
    showEdges();
}

void MeshLayers::showPicked() {
    if (!m_colors.view.isValid()) return;
    const bool picked = m_content && !m_content->outlinedLoop().empty();
    setColor(*m_edges.actor, mixed(m_colors.text2, m_colors.view, picked ? kRestStrength : 1));
}

// Edges closer together than they are wide would cover the faces that they bound.
void MeshLayers::setView(const ViewFrame& view, double pixelRatio) {
    m_glass.look(view.camera.forward);
    setWidth(m_edges, kEdgeWidth * view.scale * pixelRatio);
    constexpr double kGone = 3, kFull = 14;  // mean length
    const double pixels = m_content ? m_content->mesh->meanEdge / view.unitsPerMarkPixel() : kFull;
    m_edgeStrength = std::clamp((pixels - kGone) / (kFull - kGone), 0.0, 1.0);
    m_edges.actor->GetProperty()->SetOpacity(m_edgeStrength);
    showEdges();
}

void MeshLayers::showEdges() { m_edges.actor->SetVisibility(m_edgeStrength > 0 && !showsCoarse()); }

}  // namespace app
