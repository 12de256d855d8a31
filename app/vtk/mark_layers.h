#pragma once
#include "app/drawing3d/view_content.h"
#include "app/vtk/world_layer.h"

namespace app {

// Outlines of the marked, else of the picked polygon and of the box around a marked object: white in black, as the buffer
// views mark them, and fainter where something hides them.
class MarkLayers {
public:
    explicit MarkLayers(vtkRenderer& world);

    void setContent(const ViewContent* content);
    void setScale(double devicePixels);  // of a pixel of the design

private:
    WorldLayer m_hiddenOuter, m_hiddenInner, m_outer, m_inner;
};

}  // namespace app
