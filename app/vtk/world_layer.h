#pragma once
#include <vtkSmartPointer.h>

#include <QColor>

class vtkActor;
class vtkPolyDataMapper;
class vtkRenderer;

namespace app {

constexpr double kHalo = 1.6;  // around vectors and normals, pixels of the design

// One kind of thing that a WorldScene draws: its data and how it looks.
struct WorldLayer {
    vtkSmartPointer<vtkPolyDataMapper> mapper;
    vtkSmartPointer<vtkActor> actor;
};
WorldLayer addLayer(vtkRenderer& renderer);  // empty, and not lit
void setColor(vtkActor& actor, const QColor& color);
// Lines lie in the planes of polygons. A small pull towards the eye, or away from it if `units` is negative, decides
// which is in front.
void pullLines(WorldLayer& layer, double units);
void setWidth(WorldLayer& layer, double devicePixels);

}  // namespace app
