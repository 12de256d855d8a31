#include "app/view3d/world_scene.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkGlyph3DMapper.h>
#include <vtkImageData.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTexture.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/view3d/normal_arrows.h"
#include "app/view3d/space_drawing.h"
#include "app/view3d/vtk_data.h"
#include "app/view3d/world_drawing.h"

namespace app {

namespace {

constexpr float kRestStrength = 0.55f;   // of the edges while a polygon is picked
constexpr double kShineStrength = 0.28;  // of a vector where something stands before it
constexpr double kEdgeWidth = 1.4, kLineWidth = 1.25, kPickedOuter = 5, kPickedInner = 2.5;  // pixels of the design
constexpr double kHalo = 1.6;  // around vectors and normals

void setColor(vtkActor& actor, const QColor& color) {
    actor.GetProperty()->SetColor(color.redF(), color.greenF(), color.blueF());
}

// Lines lie in the polygons' planes; a small pull towards the eye, or away from it where `units`
// is negative, decides who is in front.
void pullLines(vtkPolyDataMapper& mapper, double units) {
    mapper.SetResolveCoincidentTopologyToPolygonOffset();
    mapper.SetRelativeCoincidentTopologyLineOffsetParameters(-units / 8, -units);
}

}  // namespace

WorldScene::WorldScene(vtkOpenGLRenderWindow& window) {
    m_world = vtkSmartPointer<vtkRenderer>::New();
    m_over = vtkSmartPointer<vtkRenderer>::New();
    window.SetNumberOfLayers(2);
    m_over->SetLayer(1);
    m_over->SetActiveCamera(m_world->GetActiveCamera());
    window.AddRenderer(m_world);
    window.AddRenderer(m_over);

    m_ground = addLayer(*m_world);
    m_faces = addLayer(*m_world);
    m_coarseFaces = addLayer(*m_world);
    m_edges = addLayer(*m_world);
    m_pickedOuter = addLayer(*m_world);
    m_pickedInner = addLayer(*m_world);
    m_picture = addPlane();
    m_lines = addLayer(*m_world);
    m_solids = addLayer(*m_world);
    m_vectors = addLayer(*m_world);
    m_halos = addLayer(*m_world);
    m_shine = addLayer(*m_over);

    pullLines(*m_ground.mapper, -16);  // a floor in the ground's plane covers the grid
    pullLines(*m_lines.mapper, 2);
    pullLines(*m_edges.mapper, 2);
    pullLines(*m_pickedOuter.mapper, 4);
    pullLines(*m_pickedInner.mapper, 6);
    // Drawn after the faces, faded edges blend with them as they are; in VTK's pass for what is translucent they would
    // cost as much as all else.
    m_edges.actor->ForceOpaqueOn();
    m_shine.actor->GetProperty()->SetOpacity(kShineStrength);
    // One blended layer a solid: without its inner side it does not darken itself.
    m_shine.actor->GetProperty()->BackfaceCullingOn();
    // The far sides of slightly larger solids: what shows of them is a rim around the solids.
    m_halos.actor->GetProperty()->FrontfaceCullingOn();

    m_normals = addGlyphs(*m_world);
    m_normalHalos = addGlyphs(*m_world);
    m_normalHalos.actor->GetProperty()->FrontfaceCullingOn();
}

WorldScene::~WorldScene() = default;

WorldScene::Layer WorldScene::addLayer(vtkRenderer& renderer) {
    Layer layer{vtkSmartPointer<vtkPolyDataMapper>::New(), vtkSmartPointer<vtkActor>::New()};
    layer.mapper->SetInputData(vtkSmartPointer<vtkPolyData>::New());
    layer.actor->SetMapper(layer.mapper);
    // Colours are those of the frame buffer or of the theme: nothing is lit a second time.
    layer.actor->GetProperty()->LightingOff();
    renderer.AddActor(layer.actor);
    return layer;
}

WorldScene::Plane WorldScene::addPlane() {
    Plane plane{addLayer(*m_world), vtkSmartPointer<vtkTexture>::New()};
    plane.texture->InterpolateOff();
    plane.layer.actor->SetTexture(plane.texture);
    plane.layer.actor->VisibilityOff();
    return plane;
}

WorldScene::Glyphs WorldScene::addGlyphs(vtkRenderer& renderer) {
    Glyphs glyphs{vtkSmartPointer<vtkGlyph3DMapper>::New(), vtkSmartPointer<vtkActor>::New()};
    glyphs.mapper->SetOrientationArray("direction");
    glyphs.mapper->SetOrientationModeToDirection();
    glyphs.mapper->ScalingOn();
    glyphs.mapper->SetScaleArray("length");
    glyphs.mapper->SetScaleModeToScaleByMagnitude();
    glyphs.mapper->ScalarVisibilityOff();
    glyphs.actor->SetMapper(glyphs.mapper);
    glyphs.actor->GetProperty()->LightingOff();
    renderer.AddActor(glyphs.actor);
    return glyphs;
}

void WorldScene::setContent(std::shared_ptr<const ViewContent> content, const std::vector<InkedLine>& ground) {
    // A newly picked pixel comes with the mesh that is there: its polygons stay as they are.
    const bool sameMesh = m_content && content && content->mesh == m_content->mesh;
    const bool sameEdges = m_content && content && content->mesh->edges == m_content->mesh->edges &&
                           content->mesh->positions == m_content->mesh->positions;
    m_content = std::move(content);
    m_groundLines = ground;
    static const ViewMesh kNone;
    const ViewMesh& mesh = m_content ? *m_content->mesh : kNone;
    const auto loop = m_content ? std::span(m_content->outlinedLoop()) : std::span<const std::uint32_t>();
    m_pickedOuter.mapper->SetInputData(loopData(mesh, loop));
    m_pickedInner.mapper->SetInputData(loopData(mesh, loop));
    if (!sameMesh) {
        if (!sameEdges) m_edges.mapper->SetInputData(edgesData(mesh));
        m_isPictureOld = true;
        colorMesh();
    }
    setOptions(m_options);
    colorLines();
}

void WorldScene::placeFrusta() {
    std::size_t used = 0;
    if (m_content)
        for (const LightFrustum& frustum : m_content->frusta) {
            if (!isShown(frustum, *m_content, m_options)) continue;
            if (used == m_frusta.size()) m_frusta.push_back(addPlane());
            Plane& plane = m_frusta[used++];
            plane.layer.mapper->SetInputData(pictureQuad(pictureCorners(frustum.view, frustum.plane)));
            plane.texture->SetInputData(pictureImage(frustum.picture));
        }
    for (std::size_t i = 0; i < m_frusta.size(); ++i) m_frusta[i].layer.actor->SetVisibility(i < used);
}

void WorldScene::setOptions(const ViewOptions& options) {
    const bool otherFaces = options.faces != m_options.faces;
    m_options = options;
    if (otherFaces) colorMesh();
    placeFrusta();
    std::vector<NormalArrow> arrows = m_content ? shownNormals(*m_content, options) : std::vector<NormalArrow>();
    for (Glyphs* glyphs : {&m_normals, &m_normalHalos}) glyphs->actor->SetVisibility(!arrows.empty());
    const bool ownNormal = m_content && m_content->foot && options.shows(VectorCode::N);
    placeNormals(std::move(arrows), ownNormal ? m_content->foot : std::nullopt);
    m_normals.mapper->SetScalarVisibility(options.normalColors == NormalColors::Direction);
    // A rim lifts single arrows off their faces; around hundreds it is clutter, and slow.
    constexpr vtkIdType kMostRims = 150;
    if (m_placedNormals.data->GetNumberOfPoints() > kMostRims) m_normalHalos.actor->VisibilityOff();
}

// VTK makes glyphs anew for every input that it is given; a camera that is dragged leaves normals where they are.
void WorldScene::placeNormals(std::vector<NormalArrow> arrows, std::optional<Vec3d> except) {
    PlacedNormals& last = m_placedNormals;
    if (last.data && last.except == except && last.arrows == arrows) return;
    last = {std::move(arrows), except, nullptr};
    last.data = normalsData(last.arrows, except);
    for (Glyphs* glyphs : {&m_normals, &m_normalHalos}) glyphs->mapper->SetInputData(last.data);
}

void WorldScene::setBackground(const QColor& color) {
    m_background = color;
    m_world->SetBackground(color.redF(), color.greenF(), color.blueF());
    m_ground.mapper->SetInputData(linesData(m_groundLines, m_colors, m_background));
    m_lines.mapper->SetInputData(linesData(m_drawnLines, m_colors, m_background));
}

void WorldScene::setColors(const ThemeColors& colors) {
    m_colors = colors;
    setBackground(colors.view);
    setColor(*m_pickedOuter.actor, Qt::black);
    setColor(*m_pickedInner.actor, Qt::white);
    setColor(*m_normals.actor, colors.N);
    setColor(*m_normalHalos.actor, colors.view);
    // Glyphs keep the colour that their actor had when they were made.
    for (Glyphs* glyphs : {&m_normals, &m_normalHalos}) glyphs->mapper->Modified();
    setColor(*m_halos.actor, colors.view);
    colorMesh();
    colorLines();
}

void WorldScene::colorMesh() {
    m_isFullOld = m_isCoarseOld = true;
    makeFaces();
}

void WorldScene::makeFaces() {
    if (!m_colors.view.isValid()) return;
    const bool isCoarse = m_isCoarse && hasCoarse();
    m_faces.actor->SetVisibility(!isCoarse);
    m_coarseFaces.actor->SetVisibility(isCoarse);
    bool& isOld = isCoarse ? m_isCoarseOld : m_isFullOld;
    if (!isOld) return;
    isOld = false;
    (isCoarse ? m_coarseFaces : m_faces)
        .mapper->SetInputData(m_content ? facesData(*m_content->mesh, isCoarse ? Detail::Coarse : Detail::Full,
                                                    m_options.faces, m_content->faceStrength, m_colors)
                                        : vtkSmartPointer<vtkPolyData>::New());
}

void WorldScene::setCoarse(bool coarse) {
    if (coarse == m_isCoarse) return;
    m_isCoarse = coarse;
    makeFaces();
    showEdges();
}

void WorldScene::colorLines() {
    if (!m_colors.view.isValid()) return;
    m_ground.mapper->SetInputData(linesData(m_groundLines, m_colors, m_background));
    const bool picked = m_content && !m_content->outlinedLoop().empty();
    setColor(*m_edges.actor, mixed(m_colors.text2, m_colors.view, picked ? kRestStrength : 1));
}

void WorldScene::setView(const ViewFrame& view, const Drawing& drawing, double pixelRatio) {
    m_pixelRatio = pixelRatio;
    const auto width = [&](Layer& layer, double pixels) {
        layer.actor->GetProperty()->SetLineWidth(float(pixels * view.scale * pixelRatio));
    };
    width(m_edges, kEdgeWidth);
    fadeEdges(view);
    width(m_ground, kLineWidth);
    width(m_lines, kLineWidth);
    width(m_pickedOuter, kPickedOuter);
    width(m_pickedInner, kPickedInner);

    m_drawnLines = drawing.lines;
    m_lines.mapper->SetInputData(linesData(m_drawnLines, m_colors, m_background));
    m_solids.mapper->SetInputData(solidsData(drawing.solids, m_colors));
    const auto vectors = solidsData(drawing.vectors, m_colors);
    m_vectors.mapper->SetInputData(vectors);
    m_shine.mapper->SetInputData(vectors);
    Solid halos;
    for (const auto* solids : {&drawing.vectors, &drawing.solids})
        for (const InkedSolid& inked : *solids) append(halos, inflated(inked.solid, kHalo * inked.unit));
    m_halos.mapper->SetInputData(solidData(halos));
    scaleNormals(view);
    showPicture(view);
    // Nothing to draw in it: its pass would only clear it.
    m_over->SetDraw(!drawing.vectors.empty());
    placeCamera(view);
}

void WorldScene::showPicture(const ViewFrame& view) {
    const bool isShown =
        m_content && m_options.eye && !m_content->mesh->picture.pixels.empty() && showsWholeEye(*m_content, view);
    m_picture.layer.actor->SetVisibility(isShown);
    if (!isShown || !std::exchange(m_isPictureOld, false)) return;
    m_picture.layer.mapper->SetInputData(pictureQuad(pictureCorners(m_content->eye, m_content->pictureDistance)));
    m_picture.texture->SetInputData(pictureImage(m_content->mesh->picture));
}

// Edges closer together than they are wide would cover the faces that they bound.
void WorldScene::fadeEdges(const ViewFrame& view) {
    constexpr double kGone = 3, kFull = 14;  // mean length
    const double pixels = m_content ? m_content->mesh->meanEdge / view.unitsPerMarkPixel() : kFull;
    m_edgeStrength = std::clamp((pixels - kGone) / (kFull - kGone), 0.0, 1.0);
    m_edges.actor->GetProperty()->SetOpacity(m_edgeStrength);
    showEdges();
}

void WorldScene::showEdges() { m_edges.actor->SetVisibility(m_edgeStrength > 0 && !(m_isCoarse && hasCoarse())); }

void WorldScene::scaleNormals(const ViewFrame& view) {
    const double scale = view.unitsPerMarkPixel();
    if (std::exchange(m_glyphLength, m_options.normalLength) != m_options.normalLength) {
        // Made in pixels; a glyph's own direction is x.
        constexpr double kRadius = 1.1;
        const Solid glyph =
            placed(smallArrow(m_options.normalLength, kRadius), {.along = {1, 0, 0}, .towardsEye = {0, 0, 1}});
        m_normals.mapper->SetSourceData(solidData(glyph));
        m_normalHalos.mapper->SetSourceData(solidData(inflated(glyph, kHalo)));
    }
    for (Glyphs* glyphs : {&m_normals, &m_normalHalos}) glyphs->mapper->SetScaleFactor(scale);
}

void WorldScene::setPart(const Part& part) {
    vtkCamera& vtk = *m_world->GetActiveCamera();
    const double tangent = std::tan(glm::radians(m_fovY) / 2) * part.half.y;
    vtk.SetViewAngle(glm::degrees(2 * std::atan(tangent)));
    vtk.SetParallelScale(m_halfHeight * part.half.y);
    vtk.SetWindowCenter(part.middle.x / part.half.x, part.middle.y / part.half.y);
}

void WorldScene::placeCamera(const ViewFrame& view) {
    const OrbitCamera& camera = view.camera;
    vtkCamera& vtk = *m_world->GetActiveCamera();
    // An orthographic camera may stand anywhere on its axis; far back, nothing is behind it.
    double back = 0;
    if (camera.orthographic) {
        double bounds[6];
        m_world->ComputeVisiblePropBounds(bounds);
        const Vec3d min{bounds[0], bounds[2], bounds[4]}, max{bounds[1], bounds[3], bounds[5]};
        if (min.x <= max.x) back = glm::length(max - min) + glm::length(camera.target - (min + max) / 2.0);
    }
    const Vec3d position = camera.position() - back * camera.forward;
    vtk.SetPosition(position.x, position.y, position.z);
    vtk.SetFocalPoint(camera.target.x, camera.target.y, camera.target.z);
    vtk.SetViewUp(camera.up.x, camera.up.y, camera.up.z);
    m_fovY = camera.fovY;
    m_halfHeight = camera.unitsPerPixel(view.size.y) * view.size.y / 2;
    vtk.SetViewAngle(m_fovY);
    vtk.SetParallelProjection(camera.orthographic);
    vtk.SetParallelScale(m_halfHeight);
    vtk.SetWindowCenter(0, 0);
    m_world->ResetCameraClippingRange();
}

}  // namespace app
