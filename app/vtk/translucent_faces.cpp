#include "app/vtk/translucent_faces.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <utility>

namespace app {

TranslucentFaces::TranslucentFaces()
    : m_mapper(vtkSmartPointer<vtkPolyDataMapper>::New()),
      m_actor(vtkSmartPointer<vtkActor>::New()),
      m_data(vtkSmartPointer<vtkPolyData>::New()) {
    m_mapper->SetInputData(m_data);
    m_actor->SetMapper(m_mapper);
    m_actor->GetProperty()->LightingOff();
    m_actor->VisibilityOff();
    // Blended where it comes in the order, like the edges; VTK's own pass would cost as much as all else.
    m_actor->ForceOpaqueOn();
}

TranslucentFaces::~TranslucentFaces() = default;

void TranslucentFaces::addTo(vtkRenderer& renderer) { renderer.AddActor(m_actor); }

void TranslucentFaces::set(const ViewMesh* mesh, Detail detail, double strength, const ThemeColors& colors) {
    m_middles.clear();
    m_data = vtkSmartPointer<vtkPolyData>::New();
    auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetDataTypeToDouble();
    auto rgba = vtkSmartPointer<vtkUnsignedCharArray>::New();
    rgba->SetNumberOfComponents(4);
    const auto toGlm = [](const QColor& color) { return glm::vec3(color.redF(), color.greenF(), color.blueF()); };
    const glm::vec3 ground = toGlm(colors.view), culled = toGlm(colors.hover);
    const auto add = [&](const Face& face, const std::array<std::uint32_t, 3>& vertices) {
        if (face.alpha >= 1 || face.alpha <= 0) return;
        Vec3d sum(0.0);
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3d& at = mesh->positions[vertices[i]];
            sum += at;
            points->InsertNextPoint(at.x, at.y, at.z);
            const glm::vec3 color = glm::mix(ground, face.shaded ? mesh->colorOf(face, i) : culled, float(strength));
            const glm::vec4 bytes = glm::round(255.0f * glm::clamp(glm::vec4(color, face.alpha), 0.0f, 1.0f));
            rgba->InsertNextTuple4(bytes.r, bytes.g, bytes.b, bytes.a);
        }
        m_middles.push_back(sum / 3.0);
    };
    if (mesh && detail == Detail::Full)
        for (const Face& face : mesh->faces) add(face, face.vertices);
    else if (mesh)
        for (const CoarseFace& coarse : *mesh->coarse) add(mesh->faces[coarse.face], coarse.vertices);
    m_data->SetPoints(points);
    m_data->GetPointData()->SetScalars(rgba);
    m_actor->SetVisibility(!m_middles.empty());
    sort();
}

void TranslucentFaces::look(Vec3d forward) {
    if (std::exchange(m_forward, forward) != forward) sort();
}

void TranslucentFaces::sort() {
    if (m_middles.empty()) return;
    std::vector<std::pair<double, vtkIdType>> order;
    order.reserve(m_middles.size());
    for (std::size_t i = 0; i < m_middles.size(); ++i)
        order.emplace_back(-glm::dot(m_forward, m_middles[i]), vtkIdType(i));
    std::ranges::sort(order);  // of equal depths in the order of the mesh
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    cells->AllocateExact(vtkIdType(order.size()), 3 * vtkIdType(order.size()));
    for (const auto& [depth, face] : order) {
        const vtkIdType corners[3]{3 * face, 3 * face + 1, 3 * face + 2};
        cells->InsertNextCell(3, corners);
    }
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->ShallowCopy(m_data);
    data->SetPolys(cells);
    m_mapper->SetInputData(data);
}

}  // namespace app
