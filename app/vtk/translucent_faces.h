#pragma once
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <vector>

#include "app/drawing3d/view_content.h"
#include "app/look/theme.h"
#include "app/vtk/vtk_data.h"

class vtkActor;
class vtkPolyDataMapper;
class vtkRenderer;

namespace app {

// The translucent faces of a mesh, blended over what is opaque.
class TranslucentFaces {
public:
    TranslucentFaces();
    ~TranslucentFaces();
    void addTo(vtkRenderer& renderer);  // after all that is opaque

    // mesh: null shows none. strength: as that of facesData.
    void set(const ViewMesh* mesh, Detail detail, double strength, const ThemeColors& colors);
    // The farthest along `forward` first, by the middles of the faces. Where faces cut through one another or overlap in a
    // cycle, no order is right.
    void look(Vec3d forward);

private:
    void sort();

    vtkSmartPointer<vtkPolyDataMapper> m_mapper;
    vtkSmartPointer<vtkActor> m_actor;
    vtkSmartPointer<vtkPolyData> m_data;  // three points a face, with RGBA
    std::vector<Vec3d> m_middles;         // a face each
    Vec3d m_forward{0, 1, 0};
};

}  // namespace app
