#include "app/vtk/world_scene.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>

#include <cmath>
#include <utility>

#include "app/vtk/vtk_data.h"

namespace app {

namespace {

constexpr double kLineWidth = 1.25;  // pixels of the design

}  // namespace

WorldScene::WorldScene(vtkOpenGLRenderWindow& window)
    : m_world(vtkSmartPointer<vtkRenderer>::New()),
      m_over(vtkSmartPointer<vtkRenderer>::New()),
      m_ground{addLayer(*m_world), {}},
      m_mesh(*m_world),
      m_marks(*m_world),
      m_planes(*m_world),
      m_lines{addLayer(*m_world), {}},
      m_solids(*m_world, *m_over),
      m_normals(*m_world) {
    window.SetNumberOfLayers(2);
    m_over->SetLayer(1);
    m_over->SetActiveCamera(m_world->GetActiveCamera());
    window.AddRenderer(m_world);
    window.AddRenderer(m_over);
    m_mesh.addGlass(*m_world);
    pullLines(m_ground.layer, -16);  // a floor in the ground's plane covers the grid
    pullLines(m_lines.layer, 2);
}

WorldScene::~WorldScene() = default;

void WorldScene::setContent(std::shared_ptr<const ViewContent> content, const std::vector<InkedLine>& ground) {
    m_content = std::move(content);
    m_ground.lines = ground;
    m_marks.setContent(m_content.get());
    if (m_mesh.setContent(m_content)) m_planes.forgetPicture();
    setOptions(m_options);
    colorLines();
}

void WorldScene::setOptions(const ViewOptions& options) {
    m_options = options;
    m_mesh.setFaces(options.faces);
    m_planes.placeFrusta(m_content.get(), options);
    m_normals.set(m_content.get(), options);
}

void WorldScene::showLines(Lines& lines) {
    lines.layer.mapper->SetInputData(linesData(lines.lines, m_colors, m_background));
}

void WorldScene::setBackground(const QColor& color) {
    m_background = color;
    m_world->SetBackground(color.redF(), color.greenF(), color.blueF());
    showLines(m_ground);
    showLines(m_lines);
}

void WorldScene::setColors(const ThemeColors& colors) {
    m_colors = colors;
    setBackground(colors.view);
    m_normals.setColors(colors);
    m_solids.setColors(colors);
    m_mesh.setColors(colors);
    colorLines();
}

void WorldScene::setCoarse(bool coarse) { m_mesh.setCoarse(coarse); }

void WorldScene::colorLines() {
    if (!m_colors.view.isValid()) return;
    showLines(m_ground);
    m_mesh.showPicked();
}

void WorldScene::setView(const ViewFrame& view, const Drawing& drawing, double pixelRatio) {
    const double markPixel = view.scale * pixelRatio;
    m_mesh.setView(view, pixelRatio);
    setWidth(m_ground.layer, kLineWidth * markPixel);
    setWidth(m_lines.layer, kLineWidth * markPixel);
    m_marks.setScale(markPixel);
    m_lines.lines = drawing.lines;
    showLines(m_lines);
    m_solids.show(drawing, m_colors);
    m_normals.setView(view);
    m_planes.showPicture(m_content.get(), m_options, view);
    // Nothing to draw in it: its pass would only clear it.
    m_over->SetDraw(!drawing.vectors.empty());
    placeCamera(view);
}

void WorldScene::setPart(const Part& part) {
    vtkCamera& vtk = *m_world->GetActiveCamera();
    const double tangent = std::tan(glm::radians(m_whole.fovY) / 2) * part.half.y;
    vtk.SetViewAngle(glm::degrees(2 * std::atan(tangent)));
    vtk.SetParallelScale(m_whole.halfHeight * part.half.y);
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
    m_whole.fovY = camera.fovY;
    m_whole.halfHeight = camera.unitsPerPixel(view.size.y) * view.size.y / 2;
    vtk.SetViewAngle(m_whole.fovY);
    vtk.SetParallelProjection(camera.orthographic);
    vtk.SetParallelScale(m_whole.halfHeight);
    vtk.SetWindowCenter(0, 0);
    m_world->ResetCameraClippingRange();
}

}  // namespace app
