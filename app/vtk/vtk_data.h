#pragma once
#include <QColor>
#include <optional>
#include <span>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "app/drawing3d/drawing.h"
#include "app/drawing3d/view_content.h"
#include "app/drawing3d/view_options.h"

class vtkImageData;

namespace app {

// Converts the project's plain data to VTK's: positions, cells and, where colours are given, an RGB array of unsigned
// bytes, one tuple a point.

// Three points a face, so that neighbours may differ in colour. strength: as ViewContent::faceStrength. Coloured by
// normals, all faces are there and opaque, with the vertices' normals where the mesh has them, else the polygons'.
// Otherwise the result holds the opaque faces alone.
enum class Detail : unsigned char { Full, Coarse };  // Coarse: only where the mesh has it
vtkSmartPointer<vtkPolyData> facesData(const ViewMesh& mesh, Detail detail, FacesShown shown, double strength,
                                       const ThemeColors& colors);
vtkSmartPointer<vtkPolyData> edgesData(const ViewMesh& mesh);
vtkSmartPointer<vtkPolyData> segmentsData(std::span<const Segment> segments);  // without colours
// A line's colour is blended with the background's by its strength.
vtkSmartPointer<vtkPolyData> linesData(std::span<const InkedLine> lines, const ThemeColors& colors,
                                       const QColor& background);
vtkSmartPointer<vtkPolyData> solidsData(std::span<const InkedSolid> solids, const ThemeColors& colors);
vtkSmartPointer<vtkPolyData> solidData(const Solid& solid);  // without colours
// Points with a vector ("direction") and a number ("length") each, coloured by (N + 1) / 2. Leaves out the point
// `except`, where N of the picked point starts.
vtkSmartPointer<vtkPolyData> normalsData(std::span<const NormalArrow> arrows, std::optional<Vec3d> except);
// With texture coordinates; corners as pictureCorners gives them.
vtkSmartPointer<vtkPolyData> pictureQuad(const std::array<Vec3d, 4>& corners);
vtkSmartPointer<vtkImageData> pictureImage(const Picture& picture);

}  // namespace app
