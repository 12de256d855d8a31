#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>

#include "pipeline/export/byte_file.h"
#include "pipeline/export/csv_file.h"
#include "pipeline/export/exporter.h"
#include "pipeline/export/exr_file.h"
#include "pipeline/export/gl_calls.h"
#include "pipeline/export/npy_file.h"
#include "pipeline/export/png_file.h"
#include "pipeline/export/vtk_file.h"
#include "pipeline/formats/toml_writer.h"

namespace pipeline {

namespace {

std::string_view holdsAll(const BufferInfo&) { return {}; }

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

std::string anyScene(const Scene&) { return {}; }

Result<std::uint64_t> writeSceneFile(const Frame& frame, const std::filesystem::path& file) {
    const Result<std::string> text = toTomlScene(frame.scene());
    if (!text) return text.errors();
    ByteFile out(file);
    out.write(std::as_bytes(std::span(*text)));
    return out.close();
}

constexpr std::array kTable{
    Exporter{"npy", "The numbers as they are, for NumPy: version 1.0, little-endian, C order.", false, holdsAll,
             npySize, true, writeNpy},
    Exporter{"png", "A picture: the colours as they are, all else through its palette.", true, picturesOnly,
             pngEstimate, false, writePng},
    Exporter{"csv", "A table: one line a pixel, vertex or polygon.", false, holdsAll, csvEstimate, false, writeCsv},
    Exporter{"exr", "A picture of 32-bit floats, for OpenEXR; the numbers of a run in double are rounded.", false,
             floatPicturesOnly, exrEstimate, false, writeExr},
    Exporter{"vtk", "The numbers as a picture of points, for VTK and ParaView.", false, pointsOnly, vtkSize, true,
             writeVtk},
};

constexpr std::array kFrameTable{
    FrameExporter{"scene", "The scene and its settings as TOML, which opens again.", ".toml", anyScene, writeSceneFile},
    FrameExporter{"polydata", "The polygons in world space, for VTK and ParaView.", ".polydata.vtk", anyScene,
                  writeVtkPolygons},
    FrameExporter{"opengl", "The OpenGL calls that draw the scene, as a C function.", ".gl.c", glRefuses, writeGlC},
};

}  // namespace

std::span<const Exporter> exporterTable() { return kTable; }

const Exporter* findExporter(std::string_view name) {
    const auto found = std::ranges::find(kTable, name, &Exporter::name);
    return found == kTable.end() ? nullptr : &*found;
}

std::span<const FrameExporter> frameExporterTable() { return kFrameTable; }

const FrameExporter* findFrameExporter(std::string_view name) {
    const auto found = std::ranges::find(kFrameTable, name, &FrameExporter::name);
    return found == kFrameTable.end() ? nullptr : &*found;
}

std::string sceneFileName(const std::string& scene, const FrameExporter& exporter) {
    std::string file = std::filesystem::path(scene).stem().string();
    constexpr std::size_t kLongest = 200;  // bytes; file systems allow 255, the endings too
    if (file.size() > kLongest) {
        std::size_t end = kLongest;
        while ((static_cast<unsigned char>(file[end]) & 0xC0) == 0x80) --end;  // no half of a UTF-8 character
        file.resize(end);
    }
    if (file.empty()) file = "scene";
    return file.append(exporter.ending);
}

Error writeError(const std::filesystem::path& file, int errorNumber) {
    return {{file.string()}, "could not write: " + std::generic_category().message(errorNumber), {}};
}

}  // namespace pipeline
