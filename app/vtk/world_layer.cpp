#include "app/vtk/world_layer.h"

#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

namespace app {

WorldLayer addLayer(vtkRenderer& renderer) {
    WorldLayer layer{vtkSmartPointer<vtkPolyDataMapper>::New(), vtkSmartPointer<vtkActor>::New()};
    layer.mapper->SetInputData(vtkSmartPointer<vtkPolyData>::New());
    layer.actor->SetMapper(layer.mapper);
    // Colours are those of the frame buffer or of the theme: nothing is lit a second time.
    layer.actor->GetProperty()->LightingOff();
    renderer.AddActor(layer.actor);
    return layer;
}

void setColor(vtkActor& actor, const QColor& color) {
    actor.GetProperty()->SetColor(color.redF(), color.greenF(), color.blueF());
}

void pullLines(WorldLayer& layer, double units) {
    layer.mapper->SetResolveCoincidentTopologyToPolygonOffset();
    layer.mapper->SetRelativeCoincidentTopologyLineOffsetParameters(-units / 8, -units);
}

void setWidth(WorldLayer& layer, double devicePixels) { layer.actor->GetProperty()->SetLineWidth(float(devicePixels)); }

}  // namespace app
