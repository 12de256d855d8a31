#include "pipeline/export/buffers/vtk_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <vector>

#include "pipeline/export/buffers/byte_file.h"
#include "pipeline/scene/mesh/topology.h"

namespace pipeline {

namespace {

// Its numbers from the first byte to the last, of which the first weighs most.
template <class T>
void write(ByteFile& out, std::span<const T> numbers) {
    std::vector<std::array<std::byte, sizeof(T)>> bytes(numbers.size());
    std::ranges::transform(numbers, bytes.begin(), [](T number) {
        auto of = std::bit_cast<std::array<std::byte, sizeof(T)>>(number);
        if constexpr (std::endian::native == std::endian::little) std::ranges::reverse(of);
        return of;
    });
    out.write(std::as_bytes(std::span(bytes)));
}

const char* typeOf(const AnyBuffer& buffer) {
    constexpr std::array<const char*, 4> kTypes{"float", "double", "int", "unsigned_char"};
    return kTypes[buffer.data.index()];
}

// One line, of printing characters, of at most 256 bytes with its end.
std::string head(std::string_view title, std::string_view dataset) {
    std::string line;
    for (const char c : title.substr(0, 200)) line += c >= ' ' && c <= '~' ? c : '?';
    return fmt::format("# vtk DataFile Version 3.0\n{}\nBINARY\nDATASET {}\n", line, dataset);
}

// What the numbers that follow are.
std::string attribute(const AnyBuffer& buffer) {
    const BufferInfo& info = *buffer.info;
    const bool isColor = info.palette == Palette::Color;
    if (buffer.channels() == 3 && info.id == BufferId::VerticesNormal)
        return fmt::format("NORMALS {} {}\n", buffer.name.text(), typeOf(buffer));
    if (buffer.channels() == 3 && !isColor) return fmt::format("VECTORS {} {}\n", buffer.name.text(), typeOf(buffer));
    return fmt::format("SCALARS {} {} {}\nLOOKUP_TABLE default\n", buffer.name.text(), typeOf(buffer),
                       buffer.channels());
}

// Of a shadow buffer; any other picture is one.
std::size_t facesOf(const AnyBuffer& buffer) {
    return buffer.shape.size() > 2 && buffer.channels() == 1 ? buffer.shape[0] : 1;
}

std::string pictureHead(const AnyBuffer& buffer) {
    const std::size_t faces = facesOf(buffer);
    return head(buffer.name.text(), "STRUCTURED_POINTS") +
           fmt::format("DIMENSIONS {} {} {}\nORIGIN 0.5 0.5 0\nSPACING 1 1 1\nPOINT_DATA {}\n", buffer.columns(),
                       buffer.rows() / faces, faces, buffer.rows() * buffer.columns()) +
           attribute(buffer);
}

std::size_t bytesOf(const AnyBuffer& buffer) {
    return std::visit([](const auto& numbers) { return numbers.size_bytes(); }, buffer.data);
}

void writeNumbers(ByteFile& out, const AnyBuffer& buffer) {
    std::visit([&](const auto& numbers) { write(out, numbers); }, buffer.data);
    out.write("\n");
}

void writeAttributes(ByteFile& out, const Frame& frame, Domain domain) {
    for (const BufferInfo& info : bufferTable()) {
        if (info.domain != domain || info.perLight || info.id == BufferId::VerticesWorld) continue;
        if (const auto buffer = frame.buffer({info.id})) out.write(attribute(*buffer)), writeNumbers(out, *buffer);
    }
}

}  // namespace

std::uint64_t vtkSize(const AnyBuffer& buffer) { return pictureHead(buffer).size() + bytesOf(buffer) + 1; }

Result<std::uint64_t> writeVtk(const ExportItem& item, const std::filesystem::path& file) {
    const AnyBuffer& buffer = item.buffer;
    ByteFile out(file);
    out.write(pictureHead(buffer));
    const std::size_t width = buffer.columns() * std::size_t(buffer.channels());
    const std::size_t height = buffer.rows() / facesOf(buffer);
    std::visit(
        [&](const auto& numbers) {
            for (std::size_t row = 0; row < buffer.rows() && out.good(); ++row) {
                const std::size_t inFace = row % height, upwards = row - inFace + (height - 1 - inFace);
                write(out, numbers.subspan(upwards * width, width));
            }
        },
        buffer.data);
    out.write("\n");
    return out.close();
}

Result<std::uint64_t> writeVtkPolygons(const Frame& frame, const std::filesystem::path& file) {
    const auto world = frame.buffer({BufferId::VerticesWorld});
    if (!world) return Error{{file.string()}, "there are no vertices: the run ended before them", {}};
    const Topology& topology = frame.topology();
    const std::size_t polygons = topology.polygonCount();
    std::vector<std::int32_t> corners, objects;
    for (std::size_t p = 0; p < polygons; ++p) {
        const Topology::Corners of = topology.corners(p);
        corners.push_back(std::int32_t(of.size()));
        for (std::size_t i = 0; i < of.size(); ++i) corners.push_back(std::int32_t(of[i]));
        objects.push_back(std::int32_t(topology.objectOfPolygon(p)));
    }
    ByteFile out(file);
    out.write(head(frame.scene().name, "POLYDATA"));
    out.write(fmt::format("POINTS {} {}\n", world->rows(), typeOf(*world)));
    writeNumbers(out, *world);
    out.write(fmt::format("POLYGONS {} {}\n", polygons, corners.size()));
    write(out, std::span<const std::int32_t>(corners));
    out.write(fmt::format("\nPOINT_DATA {}\n", world->rows()));
    writeAttributes(out, frame, Domain::Vertex);
    out.write(fmt::format("CELL_DATA {}\nSCALARS object int 1\nLOOKUP_TABLE default\n", polygons));
    write(out, std::span<const std::int32_t>(objects));
    out.write("\n");
    writeAttributes(out, frame, Domain::Polygon);
    return out.close();
}

}  // namespace pipeline
