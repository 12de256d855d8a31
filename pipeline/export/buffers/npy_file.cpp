#include "pipeline/export/buffers/npy_file.h"

#include <array>
#include <bit>

#include "pipeline/export/buffers/byte_file.h"

namespace pipeline {

namespace {

static_assert(std::endian::native == std::endian::little, "the numbers are written as they lie in memory");

std::size_t elementSize(const AnyBuffer& buffer) {
    return std::visit([](const auto& numbers) { return sizeof(numbers[0]); }, buffer.data);
}

// "numpy.lib.format", NumPy reference: magic, version, length of the text, then the text, padded
// with spaces and ended by a line end so that the numbers begin at a multiple of 64.
std::string header(const AnyBuffer& buffer) {
    constexpr std::array<const char*, 4> kTypes{"<f4", "<f8", "<i4", "|u1"};
    std::string shape;
    for (const std::size_t length : buffer.shape) {
        if (!shape.empty()) shape += ", ";
        shape += std::to_string(length);
    }
    if (buffer.shape.size() == 1) shape += ',';  // a tuple of one keeps its comma
    std::string text = "{'descr': '";
    text.append(kTypes[buffer.data.index()]).append("', 'fortran_order': False, 'shape': (");
    text.append(shape).append("), }");
    constexpr std::size_t kBefore = 10;  // magic 6, version 2, length 2
    text.append(63 - (kBefore + text.size()) % 64, ' ') += '\n';
    std::string bytes("\x93NUMPY\x01\x00", 8);
    bytes += static_cast<char>(text.size() & 0xff);
    bytes += static_cast<char>(text.size() >> 8);
    return bytes + text;
}

}  // namespace

std::uint64_t npySize(const AnyBuffer& buffer) { return header(buffer).size() + buffer.count() * elementSize(buffer); }

Result<std::uint64_t> writeNpy(const ExportItem& item, const std::filesystem::path& file) {
    ByteFile out(file);
    out.write(header(item.buffer));
    std::visit([&](const auto& numbers) { out.write(std::as_bytes(numbers)); }, item.buffer.data);
    return out.close();
}

}  // namespace pipeline
