#pragma once
#include <vtkSmartPointer.h>

#include <optional>
#include <vector>

#include "app/drawing3d/drawing.h"
#include "app/drawing3d/view_content.h"
#include "app/drawing3d/view_options.h"

class vtkActor;
class vtkGlyph3DMapper;
class vtkPolyData;
class vtkRenderer;

namespace app {

// The normals of a WorldScene, as arrows of one length on the screen, and their rims.
class NormalGlyphs {
public:
    explicit NormalGlyphs(vtkRenderer& world);

    void set(const ViewContent* content, const ViewOptions& options);  // null: none
    void setColors(const ThemeColors& colors);
    void setView(const ViewFrame& view);

private:
    struct Glyphs {
        vtkSmartPointer<vtkGlyph3DMapper> mapper;
        vtkSmartPointer<vtkActor> actor;
    };
    static Glyphs addGlyphs(vtkRenderer& world);
    void place(std::vector<NormalArrow> arrows, std::optional<Vec3d> except);

    Glyphs m_arrows, m_rims;
    struct Placed {
        std::vector<NormalArrow> arrows;
        std::optional<Vec3d> except;
        vtkSmartPointer<vtkPolyData> data;
    } m_placed;
    double m_length = 0, m_glyphLength = -1;  // wanted, and of the glyphs; pixels of the design
};

}  // namespace app
