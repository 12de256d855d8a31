#include "app/vtk/vtk_data.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkTypeInt32Array.h>
#include <vtkUnsignedCharArray.h>

#include "app/drawing3d/normal_arrows.h"

namespace app {

namespace {

// Points in double: float would make a small scene far from the origin tremble.
vtkSmartPointer<vtkPoints> newPoints() {
    auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetDataTypeToDouble();
    return points;
}

vtkSmartPointer<vtkUnsignedCharArray> newColors() {
    auto colors = vtkSmartPointer<vtkUnsignedCharArray>::New();
    colors->SetNumberOfComponents(3);
    colors->SetName("color");
    return colors;
}

void addColor(vtkUnsignedCharArray& colors, const QColor& color) {
    const unsigned char rgb[3]{static_cast<unsigned char>(color.red()), static_cast<unsigned char>(color.green()),
                               static_cast<unsigned char>(color.blue())};
    colors.InsertNextTypedTuple(rgb);
}

QColor toColor(glm::vec3 c) {
    const glm::ivec3 v(glm::round(glm::clamp(c, 0.0f, 1.0f) * 255.0f));
    return {v.x, v.y, v.z};
}

using pipeline::Color8;
static_assert(sizeof(Color8) == 3 && sizeof(Vec3d) == 3 * sizeof(double));

Color8 toColor8(glm::vec3 c) { return Color8(glm::round(glm::clamp(c, 0.0f, 1.0f) * 255.0f)); }
Color8 toColor8(const QColor& c) { return Color8(c.red(), c.green(), c.blue()); }
Color8 mixed(Color8 a, Color8 b, double shareOfA) {
    if (shareOfA == 1) return a;
    return Color8(glm::round(glm::dvec3(a) * shareOfA + glm::dvec3(b) * (1 - shareOfA)));
}

// Whole arrays at once: a mesh may have millions of points.
vtkSmartPointer<vtkPoints> pointsOf(const std::vector<Vec3d>& positions) {
    auto points = newPoints();
    points->SetNumberOfPoints(vtkIdType(positions.size()));
    if (!positions.empty())
        std::memcpy(points->GetData()->GetVoidPointer(0), positions.data(), positions.size() * sizeof(Vec3d));
    return points;
}

// Cells of so many points each, in 32 bits: half of the memory of vtkIdType.
vtkSmartPointer<vtkCellArray> cellsOf(const std::vector<vtkTypeInt32>& ids, vtkIdType size) {
    auto corners = vtkSmartPointer<vtkTypeInt32Array>::New();
    corners->SetNumberOfValues(vtkIdType(ids.size()));
    std::ranges::copy(ids, corners->GetPointer(0));
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    cells->SetData(size, corners);
    return cells;
}

vtkIdType addPoint(vtkPoints& points, Vec3d p) { return points.InsertNextPoint(p.x, p.y, p.z); }

}  // namespace

vtkSmartPointer<vtkPolyData> facesData(const ViewMesh& mesh, Detail detail, FacesShown shown, double strength,
                                       const ThemeColors& colors) {
    const Color8 ground = toColor8(colors.view);
    const auto colorAt = [&](const Face& face, std::size_t corner) {
        if (shown == FacesShown::Normals && !mesh.vertexNormals.empty())
            return toColor8(colorOfNormal(mesh.vertexNormals[face.vertices[corner]]));
        if (shown == FacesShown::Normals && !mesh.polygonNormals.empty())
            return toColor8(colorOfNormal(mesh.polygonNormals[std::size_t(face.polygon)]));
        return face.shaded ? toColor8(mesh.colorOf(face, corner)) : toColor8(colors.hover);
    };
    // A vertex is one point while the faces around it give it one colour.
    struct Placed {
        vtkTypeInt32 point = -1;
        Color8 color{0};
    };
    std::vector<Placed> placed(mesh.positions.size());
    std::vector<Vec3d> points;
    std::vector<Color8> rgb;
    std::vector<vtkTypeInt32> corners;
    const std::size_t count = detail == Detail::Full ? mesh.faces.size() : mesh.coarse->size();
    points.reserve(std::min(count, mesh.positions.size()));
    rgb.reserve(std::min(count, mesh.positions.size()));
    corners.reserve(3 * count);
    const auto add = [&](const Face& face, const std::array<std::uint32_t, 3>& vertices) {
        if (face.alpha < 1 && shown == FacesShown::Shaded) return;  // TranslucentFaces has those
        for (std::size_t i = 0; i < 3; ++i) {
            Placed& at = placed[vertices[i]];
            const Color8 color = mixed(colorAt(face, i), ground, strength);
            if (at.point < 0 || at.color != color) {
                at = {vtkTypeInt32(points.size()), color};
                points.push_back(mesh.positions[vertices[i]]);
                rgb.push_back(color);
            }
            corners.push_back(at.point);
        }
    };
    if (detail == Detail::Full)
        for (const Face& face : mesh.faces) add(face, face.vertices);
    else
        for (const CoarseFace& coarse : *mesh.coarse) add(mesh.faces[coarse.face], coarse.vertices);
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(pointsOf(points));
    data->SetPolys(cellsOf(corners, 3));
    auto scalars = newColors();
    scalars->SetNumberOfTuples(vtkIdType(rgb.size()));
    if (!rgb.empty()) std::memcpy(scalars->GetPointer(0), rgb.data(), rgb.size() * sizeof(Color8));
    data->GetPointData()->SetScalars(scalars);
    return data;
}

vtkSmartPointer<vtkPolyData> edgesData(const ViewMesh& mesh) {
    std::vector<vtkTypeInt32> ends;
    ends.reserve(2 * mesh.edges.size());
    for (const auto& [a, b] : mesh.edges) ends.push_back(vtkTypeInt32(a)), ends.push_back(vtkTypeInt32(b));
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(pointsOf(mesh.positions));
    data->SetLines(cellsOf(ends, 2));
    return data;
}

vtkSmartPointer<vtkPolyData> segmentsData(std::span<const Segment> segments) {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    auto points = newPoints();
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    for (const Segment& segment : segments) {
        const vtkIdType ids[2]{addPoint(*points, segment.a), addPoint(*points, segment.b)};
        cells->InsertNextCell(2, ids);
    }
    data->SetPoints(points);
    data->SetLines(cells);
    return data;
}

vtkSmartPointer<vtkPolyData> linesData(std::span<const InkedLine> lines, const ThemeColors& colors,
                                       const QColor& background) {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    auto points = newPoints();
    auto rgb = newColors();
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    for (const InkedLine& line : lines) {
        const vtkIdType ids[2]{addPoint(*points, line.a), addPoint(*points, line.b)};
        cells->InsertNextCell(2, ids);
        const QColor ink = colorOf(line.ink, colors);
        addColor(*rgb, mixed(ink, background, double(line.strengthA)));
        addColor(*rgb, mixed(ink, background, double(line.strengthB)));
    }
    data->SetPoints(points);
    data->SetLines(cells);
    data->GetPointData()->SetScalars(rgb);
    return data;
}

vtkSmartPointer<vtkPolyData> solidsData(std::span<const InkedSolid> solids, const ThemeColors& colors) {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    auto points = newPoints();
    auto rgb = newColors();
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    for (const InkedSolid& inked : solids) {
        const vtkIdType first = points->GetNumberOfPoints();
        const QColor ink = mixed(colorOf(inked.ink, colors), colors.view, inked.strength);
        for (const Vec3d& p : inked.solid.positions) {
            addPoint(*points, p);
            addColor(*rgb, ink);
        }
        for (const glm::uvec3& t : inked.solid.triangles) {
            const vtkIdType ids[3]{first + t.x, first + t.y, first + t.z};
            cells->InsertNextCell(3, ids);
        }
    }
    data->SetPoints(points);
    data->SetPolys(cells);
    data->GetPointData()->SetScalars(rgb);
    return data;
}

vtkSmartPointer<vtkPolyData> solidData(const Solid& solid) {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    auto points = newPoints();
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    for (const Vec3d& p : solid.positions) addPoint(*points, p);
    for (const glm::uvec3& t : solid.triangles) {
        const vtkIdType ids[3]{t.x, t.y, t.z};
        cells->InsertNextCell(3, ids);
    }
    data->SetPoints(points);
    data->SetPolys(cells);
    return data;
}

vtkSmartPointer<vtkPolyData> normalsData(std::span<const NormalArrow> arrows, std::optional<Vec3d> except) {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    auto points = newPoints();
    auto directions = vtkSmartPointer<vtkDoubleArray>::New();
    directions->SetNumberOfComponents(3);
    directions->SetName("direction");
    auto lengths = vtkSmartPointer<vtkDoubleArray>::New();
    lengths->SetName("length");
    auto rgb = newColors();
    for (const NormalArrow& arrow : arrows) {
        // The two points are the same mean, computed in two precisions.
        if (except && glm::length(arrow.base - *except) <= 1e-5 * glm::length(*except)) continue;
        addPoint(*points, arrow.base);
        directions->InsertNextTuple3(arrow.direction.x, arrow.direction.y, arrow.direction.z);
        lengths->InsertNextValue(arrow.length);
        addColor(*rgb, toColor(arrow.color));
    }
    data->SetPoints(points);
    data->GetPointData()->AddArray(directions);
    data->GetPointData()->AddArray(lengths);
    data->GetPointData()->SetScalars(rgb);
    return data;
}

vtkSmartPointer<vtkPolyData> pictureQuad(const std::array<Vec3d, 4>& corners) {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    auto points = newPoints();
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    auto texture = vtkSmartPointer<vtkFloatArray>::New();
    texture->SetNumberOfComponents(2);
    for (const Vec3d& corner : corners) addPoint(*points, corner);
    // Texture rows count upwards, the picture's downwards.
    for (const auto& [u, v] : {std::pair{0, 1}, {1, 1}, {1, 0}, {0, 0}}) texture->InsertNextTuple2(u, v);
    const vtkIdType ids[4]{0, 1, 2, 3};
    cells->InsertNextCell(4, ids);
    data->SetPoints(points);
    data->SetPolys(cells);
    data->GetPointData()->SetTCoords(texture);
    return data;
}

vtkSmartPointer<vtkImageData> pictureImage(const Picture& picture) {
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(picture.size.x, picture.size.y, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    const auto width = static_cast<std::size_t>(picture.size.x), height = static_cast<std::size_t>(picture.size.y);
    auto* out = static_cast<unsigned char*>(image->GetScalarPointer());
    for (std::size_t y = height; y-- > 0; out += 3 * width)  // the texture's first row is the lowest
        std::memcpy(out, &picture.pixels[y * width], 3 * width);
    return image;
}

}  // namespace app
