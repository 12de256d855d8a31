#include "app/vtk/solid_layers.h"

#include <vtkActor.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include "app/vtk/vtk_data.h"

namespace app {

namespace {

constexpr double kShineStrength = 0.28;  // of a vector where something stands before it

}  // namespace

SolidLayers::SolidLayers(vtkRenderer& world, vtkRenderer& over)
    : m_solids(addLayer(world)), m_vectors(addLayer(world)), m_halos(addLayer(world)), m_shine(addLayer(over)) {
    m_shine.actor->GetProperty()->SetOpacity(kShineStrength);
    // One blended layer a solid: without its inner side it does not darken itself.
    m_shine.actor->GetProperty()->BackfaceCullingOn();
    // The far sides of slightly larger solids: what shows of them is a rim around the solids.
    m_halos.actor->GetProperty()->FrontfaceCullingOn();
}

void SolidLayers::setColors(const ThemeColors& colors) { setColor(*m_halos.actor, colors.view); }

void SolidLayers::show(const Drawing& drawing, const ThemeColors& colors) {
    m_solids.mapper->SetInputData(solidsData(drawing.solids, colors));
    const auto vectors = solidsData(drawing.vectors, colors);
    m_vectors.mapper->SetInputData(vectors);
    m_shine.mapper->SetInputData(vectors);
    Solid halos;
    for (const auto* solids : {&drawing.vectors, &drawing.solids})
        for (const InkedSolid& inked : *solids) append(halos, inflated(inked.solid, kHalo * inked.unit));
    m_halos.mapper->SetInputData(solidData(halos));
}

}  // namespace app
