#pragma once
#include "app/drawing3d/drawing.h"
#include "app/vtk/world_layer.h"

namespace app {

// The solids of a Drawing in a WorldScene: marks and vectors with rims in the background's colour. A vector shines
// through what hides it.
class SolidLayers {
public:
    SolidLayers(vtkRenderer& world, vtkRenderer& over);

    void setColors(const ThemeColors& colors);
    void show(const Drawing& drawing, const ThemeColors& colors);

private:
    WorldLayer m_solids, m_vectors, m_halos, m_shine;
};

}  // namespace app
