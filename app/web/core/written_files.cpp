#include "app/web/core/written_files.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "app/web/core/core.h"
#include "pipeline/core/text.h"
#include "pipeline/core/version.h"
#include "pipeline/export/buffers/byte_file.h"
#include "pipeline/export/buffers/csv_file.h"
#include "pipeline/export/buffers/exporter.h"
#include "pipeline/export/buffers/npy_file.h"
#include "pipeline/export/buffers/png_file.h"

// Files without a disk, and pictures without a library that packs them.

namespace web {

std::map<std::string, std::string, std::less<>>& writtenFiles() {
    static std::map<std::string, std::string, std::less<>> files;
    return files;
}

}  // namespace web

namespace pipeline {

ByteFile::ByteFile(const std::filesystem::path& path) : m_path(path) { web::writtenFiles()[path.string()].clear(); }
void ByteFile::write(std::span<const std::byte> bytes) {
    web::writtenFiles()[m_path.string()].append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    m_size += bytes.size();
}
Result<std::uint64_t> ByteFile::close() { return m_size; }

namespace {
std::string_view picturesAlone(const BufferInfo& info) {
    const bool isPicture = info.domain == Domain::Pixel || info.domain == Domain::Texel;
    return isPicture                       ? ""
           : info.domain == Domain::Vertex ? "A picture has pixels, not vertices."
                                           : "A picture has pixels, not polygons.";
}
constexpr std::array kTable{kNpyExporter,
                            Exporter{"png", "A picture: the colours as they are, all else through its palette.", true,
                                     picturesAlone, pngEstimate, false, writePng},
                            kCsvExporter};
constexpr std::array kFrameTable{kSceneExporter};

// ISO 3309, as PNG asks for it.
std::uint32_t crc32(std::string_view bytes) {
    std::uint32_t sum = ~0u;
    for (const char byte : bytes) {
        sum ^= static_cast<unsigned char>(byte);
        for (int bit = 0; bit < 8; ++bit) sum = sum >> 1 ^ (sum & 1 ? 0xEDB88320u : 0);
    }
    return ~sum;
}
std::string number32(std::uint32_t value) {
    return {char(value >> 24), char(value >> 16), char(value >> 8), char(value)};
}
std::string chunk(const std::string& kind, const std::string& data) {
    return number32(std::uint32_t(data.size())) + kind + data + number32(crc32(kind + data));
}
// Blocks that are stored as they are (RFC 1950 and 1951): larger than the program's, with the same pixels.
std::string pngWith(const Buffer2D<Color8>& picture, const std::string& texts) {
    std::string rows;
    std::size_t i = 0;
    for (int y = 0; y < picture.size.y; ++y) {
        rows += '\0';  // no filter
        for (int x = 0; x < picture.size.x; ++x, ++i)
            for (int c = 0; c < 3; ++c) rows += char(picture.pixels[i][c]);
    }
    std::string packed("\x78\x01", 2);
    constexpr std::size_t kMostStored = 65535;
    std::uint32_t a = 1, b = 0;  // Adler-32
    for (const char byte : rows) a = (a + static_cast<unsigned char>(byte)) % 65521, b = (b + a) % 65521;
    for (std::size_t at = 0; at < rows.size(); at += kMostStored) {
        const std::size_t count = std::min(kMostStored, rows.size() - at);
        const auto low = char(count & 255), high = char(count >> 8);
        packed += char(at + count == rows.size());
        packed.append({low, high, char(~low), char(~high)}).append(rows, at, count);
    }
    packed += number32(b << 16 | a);
    const std::string head = number32(std::uint32_t(picture.size.x)) + number32(std::uint32_t(picture.size.y));
    return "\x89PNG\r\n\x1a\n" + chunk("IHDR", head + std::string("\x08\x02\0\0\0", 5)) + texts +
           chunk("IDAT", packed) + chunk("IEND", {});
}
}  // namespace

std::uint64_t pngEstimate(const AnyBuffer& buffer) { return 1000 + buffer.rows() * buffer.columns() * 3 / 2; }
std::span<const Exporter> exporterTable() { return kTable; }
std::span<const FrameExporter> frameExporterTable() { return kFrameTable; }

std::string pngOf(const Buffer2D<Color8>& picture, Packing) { return pngWith(picture, {}); }

Result<std::uint64_t> writePng(const ExportItem& item, const std::filesystem::path& file) {
    const AnyBuffer& buffer = item.buffer;
    Buffer2D<Color8> picture({int(buffer.columns()), int(buffer.rows())}, Color8(0));
    for (std::size_t y = 0; y < buffer.rows(); ++y)
        for (std::size_t x = 0; x < buffer.columns(); ++x)
            picture.at({int(x), int(y)}) = elementColor(buffer, x, y, item.range);
    std::string texts = chunk("sRGB", std::string(1, '\0'));
    const std::string range = shortestText(item.range.first) + ' ' + shortestText(item.range.last);
    for (const auto& [key, text] : std::initializer_list<std::pair<std::string, std::string>>{
             {"Title", buffer.name.text()},
             {"Software", "Shadescope " + std::string(programVersion())},
             {"Palette", std::string(paletteName(buffer.info->palette))},
             {"Range", range}})
        texts += chunk("tEXt", key + '\0' + text);
    ByteFile out(file);
    const std::string bytes = pngWith(picture, texts);
    out.write(std::as_bytes(std::span(bytes)));
    return out.close();
}

}  // namespace pipeline
