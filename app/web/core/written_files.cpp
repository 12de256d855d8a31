#include "app/web/core/written_files.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "app/web/core/core.h"
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
constexpr std::array kTable{kNpyExporter, kCsvExporter};
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
}  // namespace

std::span<const Exporter> exporterTable() { return kTable; }
std::span<const FrameExporter> frameExporterTable() { return kFrameTable; }

// Blocks that are stored as they are (RFC 1950 and 1951): larger than the program's, with the same pixels.
std::string pngOf(const Buffer2D<Color8>& picture, Packing) {
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
    return "\x89PNG\r\n\x1a\n" + chunk("IHDR", head + std::string("\x08\x02\0\0\0", 5)) + chunk("IDAT", packed) +
           chunk("IEND", {});
}

}  // namespace pipeline
