#pragma once
#include <memory>

#include "app/drawing3d/drawing.h"
#include "app/drawing3d/view_content.h"
#include "app/drawing3d/view_options.h"
#include "app/vtk/translucent_faces.h"
#include "app/vtk/world_layer.h"

namespace app {

// The polygons of a WorldScene and their edges. Faces are made when they are shown, in full or coarse.
class MeshLayers {
public:
    explicit MeshLayers(vtkRenderer& world);
    void addGlass(vtkRenderer& world) { m_glass.addTo(world); }  // after all that is opaque

    bool setContent(std::shared_ptr<const ViewContent> content);  // whether its mesh is another one
    void setFaces(FacesShown faces);
    void setColors(const ThemeColors& colors);
    void setCoarse(bool coarse);
    void showPicked();                                       // edges are fainter while a polygon is picked
    void setView(const ViewFrame& view, double pixelRatio);  // device pixels per logical pixel of view.size

private:
    void color();
    void makeFaces();
    void showEdges();
    bool showsCoarse() const { return m_isCoarse && m_content && m_content->mesh->coarse; }

    WorldLayer m_faces, m_coarseFaces, m_edges;
    TranslucentFaces m_glass;  // the translucent faces
    std::shared_ptr<const ViewContent> m_content;
    FacesShown m_shown = ViewOptions().faces;
    ThemeColors m_colors;
    bool m_isCoarse = false, m_isFullOld = true, m_isCoarseOld = true;
    double m_edgeStrength = 1;
};

}  // namespace app
