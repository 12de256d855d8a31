#pragma once
#include <vtkSmartPointer.h>

#include <memory>
#include <vector>

#include "app/vtk/mark_layers.h"
#include "app/vtk/mesh_layers.h"
#include "app/vtk/normal_glyphs.h"
#include "app/vtk/picture_planes.h"
#include "app/vtk/solid_layers.h"

class vtkOpenGLRenderWindow;

namespace app {

// Draws a ViewContent and a Drawing into a render window: the only translation into VTK's terms.
class WorldScene {
public:
    // Adds its renderers to the window, which must outlive the scene.
    explicit WorldScene(vtkOpenGLRenderWindow& window);
    ~WorldScene();
    WorldScene(const WorldScene&) = delete;
    WorldScene& operator=(const WorldScene&) = delete;

    // The polygons, their edges and normals, outlines of what is picked or selected, the picture plane.
    // `ground` lies under them. Null content shows the background alone.
    void setContent(std::shared_ptr<const ViewContent> content, const std::vector<InkedLine>& ground);
    void setOptions(const ViewOptions& options);
    void setColors(const ThemeColors& colors);
    void setBackground(const QColor& color);  // until the next setColors; lines fade into it
    // While views follow each other: few of many faces, and none of their edges.
    void setCoarse(bool coarse);
    // What changes with the camera. pixelRatio: device pixels per logical pixel of view.size.
    void setView(const ViewFrame& view, const Drawing& drawing, double pixelRatio);
    // The render window shows a part of the view alone: `middle` of the part, from the view's, and half of its size, in
    // halves of the view's height; y up. Until the next setView.
    struct Part {
        glm::dvec2 middle, half;
    };
    void setPart(const Part& part);

private:
    struct Lines {
        WorldLayer layer;
        std::vector<InkedLine> lines;
    };
    void showLines(Lines& lines);
    void colorLines();
    void placeCamera(const ViewFrame& view);

    // In the order in which they are drawn.
    vtkSmartPointer<vtkRenderer> m_world, m_over;
    Lines m_ground;
    MeshLayers m_mesh;
    MarkLayers m_marks;
    PicturePlanes m_planes;
    Lines m_lines;
    SolidLayers m_solids;
    NormalGlyphs m_normals;

    std::shared_ptr<const ViewContent> m_content;
    ViewOptions m_options;
    ThemeColors m_colors;
    QColor m_background;
    struct WholeView {
        double fovY = 30, halfHeight = 1;  // degrees; world units at the target
    };
    WholeView m_whole;
};

}  // namespace app
