#include <array>
#include <system_error>

#include "pipeline/export/buffers/csv_file.h"
#include "pipeline/export/buffers/exporter.h"
#include "pipeline/export/buffers/exr_file.h"
#include "pipeline/export/buffers/gl_calls.h"
#include "pipeline/export/buffers/npy_file.h"
#include "pipeline/export/buffers/png_file.h"
#include "pipeline/export/buffers/vtk_file.h"

namespace pipeline {

namespace {

std::string_view picturesOnly(const BufferInfo& info) {
    switch (info.domain) {
        case Domain::Vertex: return "A picture has pixels, not vertices.";
        case Domain::Polygon: return "A picture has pixels, not polygons.";
        case Domain::Pixel:
        case Domain::Texel: break;
    }
    return {};
}

std::string_view floatPicturesOnly(const BufferInfo& info) {
    if (info.element != Element::Real) return "OpenEXR has no signed and no 8-bit integers.";
    return picturesOnly(info);
}

std::string_view pointsOnly(const BufferInfo& info) {
    return picturesOnly(info).empty() ? "" : "It stands with the polygons, in the format polydata.";
}

constexpr std::array kTable{
    kNpyExporter,
    Exporter{"png", "A picture: the colours as they are, all else through its palette.", true, picturesOnly,
             pngEstimate, false, writePng},
    kCsvExporter,
    Exporter{"exr", "A picture of 32-bit floats, for OpenEXR; the numbers of a run in double are rounded.", false,
             floatPicturesOnly, exrEstimate, false, writeExr},
    Exporter{"vtk", "The numbers as a picture of points, for VTK and ParaView.", false, pointsOnly, vtkSize, true,
             writeVtk},
};

constexpr std::array kFrameTable{
    kSceneExporter,
    FrameExporter{"polydata", "The polygons in world space, for VTK and ParaView.", ".polydata.vtk", anyScene,
                  writeVtkPolygons},
    FrameExporter{"opengl", "The OpenGL calls that draw the scene, as a C function.", ".gl.c", glRefuses, writeGlC},
};

}  // namespace

std::span<const Exporter> exporterTable() { return kTable; }

std::span<const FrameExporter> frameExporterTable() { return kFrameTable; }

Error writeError(const std::filesystem::path& file, int errorNumber) {
    return {{file.string()}, "could not write: " + std::generic_category().message(errorNumber), {}};
}

}  // namespace pipeline
