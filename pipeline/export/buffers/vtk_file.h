#pragma once
#include "pipeline/export/buffers/exporter.h"

namespace pipeline {

// VTK's legacy files, binary, version 3.0: a text that says what follows, and the numbers, big-endian.
// "VTK File Formats", The VTK User's Guide, Kitware.

// A picture as structured points: a point in each pixel's centre, x to the right, y up, so that it stands upright where
// VTK draws it; the faces of a shadow buffer lie one behind the other. Numbers of three channels that are no colours are
// vectors, for arrows to be drawn along.
std::uint64_t vtkSize(const AnyBuffer& buffer);
Result<std::uint64_t> writeVtk(const ExportItem& item, const std::filesystem::path& file);

// The polygons in world space as poly data, with every buffer of vertices and polygons that the frame has, and the number
// of each polygon's object.
Result<std::uint64_t> writeVtkPolygons(const Frame& frame, const std::filesystem::path& file);

}  // namespace pipeline
