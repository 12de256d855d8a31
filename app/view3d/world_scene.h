#pragma once
#include <vtkSmartPointer.h>

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "app/view3d/drawing.h"
#include "app/view3d/view_content.h"
#include "app/view3d/view_options.h"

class vtkActor;
class vtkGlyph3DMapper;
class vtkOpenGLRenderWindow;
class vtkPolyData;
class vtkPolyDataMapper;
class vtkRenderer;
class vtkTexture;

namespace app {

// Draws a ViewContent and a Drawing into a render window: the only translation into VTK's terms.
class WorldScene {
public:
    // Adds its renderers to the window, which must outlive the scene.
    explicit WorldScene(vtkOpenGLRenderWindow& window);
    ~WorldScene();
    WorldScene(const WorldScene&) = delete;
    WorldScene& operator=(const WorldScene&) = delete;

    // The polygons, their edges and normals, the picked polygon's outline, the picture plane.
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
    struct Layer {
        vtkSmartPointer<vtkPolyDataMapper> mapper;
        vtkSmartPointer<vtkActor> actor;
    };
    struct Glyphs {
        vtkSmartPointer<vtkGlyph3DMapper> mapper;
        vtkSmartPointer<vtkActor> actor;
    };
    struct Plane {
        Layer layer;
        vtkSmartPointer<vtkTexture> texture;
    };
    Layer addLayer(vtkRenderer& renderer);
    Plane addPlane();
    Glyphs addGlyphs(vtkRenderer& renderer);
    void colorMesh();
    void makeFaces();
    bool hasCoarse() const { return m_content && m_content->mesh->coarse; }
    void colorLines();
    void placeFrusta();
    void placeCamera(const ViewFrame& view);
    void fadeEdges(const ViewFrame& view);
    void showEdges();
    void showPicture(const ViewFrame& view);
    void placeNormals(std::vector<NormalArrow> arrows, std::optional<Vec3d> except);
    void scaleNormals(const ViewFrame& view);

    vtkSmartPointer<vtkRenderer> m_world, m_over;
    Layer m_faces, m_coarseFaces, m_edges, m_ground, m_pickedOuter, m_pickedInner, m_lines, m_solids, m_vectors,
        m_halos, m_shine;
    Plane m_picture;
    std::vector<Plane> m_frusta;  // the shadow buffers; as many as were ever needed
    Glyphs m_normals, m_normalHalos;
    struct PlacedNormals {
        std::vector<NormalArrow> arrows;
        std::optional<Vec3d> except;
        vtkSmartPointer<vtkPolyData> data;
    } m_placedNormals;

    std::shared_ptr<const ViewContent> m_content;
    std::vector<InkedLine> m_groundLines, m_drawnLines;
    ViewOptions m_options;
    ThemeColors m_colors;
    QColor m_background;
    double m_pixelRatio = 1;
    double m_edgeStrength = 1;
    bool m_isCoarse = false;
    bool m_isFullOld = true, m_isCoarseOld = true, m_isPictureOld = true;  // they are made when they are shown
    double m_glyphLength = -1;                                             // of the normals' arrows
    double m_fovY = 30, m_halfHeight = 1;  // of the whole view: degrees; world units at the target
};

}  // namespace app
