#include "app/vtk/normal_glyphs.h"

#include <vtkActor.h>
#include <vtkGlyph3DMapper.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <utility>

#include "app/drawing3d/normal_arrows.h"
#include "app/vtk/vtk_data.h"
#include "app/vtk/world_layer.h"

namespace app {

NormalGlyphs::NormalGlyphs(vtkRenderer& world) : m_arrows(addGlyphs(world)), m_rims(addGlyphs(world)) {
    m_rims.actor->GetProperty()->FrontfaceCullingOn();
}

NormalGlyphs::Glyphs NormalGlyphs::addGlyphs(vtkRenderer& world) {
    Glyphs glyphs{vtkSmartPointer<vtkGlyph3DMapper>::New(), vtkSmartPointer<vtkActor>::New()};
    glyphs.mapper->SetOrientationArray("direction");
    glyphs.mapper->SetOrientationModeToDirection();
    glyphs.mapper->ScalingOn();
    glyphs.mapper->SetScaleArray("length");
    glyphs.mapper->SetScaleModeToScaleByMagnitude();
    glyphs.mapper->ScalarVisibilityOff();
    glyphs.actor->SetMapper(glyphs.mapper);
    glyphs.actor->GetProperty()->LightingOff();
    world.AddActor(glyphs.actor);
    return glyphs;
}

void NormalGlyphs::set(const ViewContent* content, const ViewOptions& options) {
    m_length = options.normalLength;
    std::vector<NormalArrow> arrows = content ? shownNormals(*content, options) : std::vector<NormalArrow>();
    for (Glyphs* glyphs : {&m_arrows, &m_rims}) glyphs->actor->SetVisibility(!arrows.empty());
    const bool ownNormal = content && content->foot && options.shows(VectorCode::N);
    place(std::move(arrows), ownNormal ? content->foot : std::nullopt);
    m_arrows.mapper->SetScalarVisibility(options.normalColors == NormalColors::Direction);
    // A rim lifts single arrows off their faces; around hundreds it is clutter, and slow.
    constexpr vtkIdType kMostRims = 150;
    if (m_placed.data->GetNumberOfPoints() > kMostRims) m_rims.actor->VisibilityOff();
}

// VTK makes glyphs anew for every input that it is given; a camera that is dragged leaves normals where they are.
void NormalGlyphs::place(std::vector<NormalArrow> arrows, std::optional<Vec3d> except) {
    if (m_placed.data && m_placed.except == except && m_placed.arrows == arrows) return;
    m_placed = {std::move(arrows), except, nullptr};
    m_placed.data = normalsData(m_placed.arrows, except);
    for (Glyphs* glyphs : {&m_arrows, &m_rims}) glyphs->mapper->SetInputData(m_placed.data);
}

void NormalGlyphs::setColors(const ThemeColors& colors) {
    setColor(*m_arrows.actor, colors.N);
    setColor(*m_rims.actor, colors.view);
    // Glyphs keep the colour that their actor had when they were made.
    for (Glyphs* glyphs : {&m_arrows, &m_rims}) glyphs->mapper->Modified();
}

void NormalGlyphs::setView(const ViewFrame& view) {
    const double scale = view.unitsPerMarkPixel();
    if (std::exchange(m_glyphLength, m_length) != m_length) {
        // Made in pixels; a glyph's own direction is x.
        constexpr double kConeRadius = 1.1;
        const Solid glyph = placed(smallArrow(m_length, kConeRadius), {.along = {1, 0, 0}, .towardsEye = {0, 0, 1}});
        m_arrows.mapper->SetSourceData(solidData(glyph));
        m_rims.mapper->SetSourceData(solidData(inflated(glyph, kHalo)));
    }
    for (Glyphs* glyphs : {&m_arrows, &m_rims}) glyphs->mapper->SetScaleFactor(scale);
}

}  // namespace app
