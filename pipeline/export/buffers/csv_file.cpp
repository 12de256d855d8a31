#include "pipeline/export/buffers/csv_file.h"

#include <array>
#include <charconv>
#include <string>

#include "pipeline/export/buffers/byte_file.h"

namespace pipeline {

namespace {

std::string_view placeNames(Domain domain) {
    switch (domain) {
        case Domain::Vertex: return "vertex";
        case Domain::Polygon: return "polygon";
        case Domain::Pixel:
        case Domain::Texel: break;
    }
    return "column,row";  // x and y are components
}

std::string_view valueNames(const BufferInfo& info) {
    if (info.channels == 1) return "value";
    if (info.id == BufferId::Barycentric) return "b0,b1,b2";
    return info.palette == Palette::Color ? "r,g,b" : "x,y,z";
}

template <class T>
void append(std::string& text, T number) {
    std::array<char, 40> digits;
    const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), number);
    text.append(digits.data(), end);
}

}  // namespace

std::uint64_t csvEstimate(const AnyBuffer& buffer) {
    const std::uint64_t lines = buffer.rows() * buffer.columns();
    return 16 + lines * 8 + buffer.count() * 10;
}

Result<std::uint64_t> writeCsv(const ExportItem& item, const std::filesystem::path& file) {
    const AnyBuffer& buffer = item.buffer;
    const bool picture = buffer.info->domain == Domain::Pixel || buffer.info->domain == Domain::Texel;
    const auto channels = static_cast<std::size_t>(buffer.channels());
    ByteFile out(file);
    std::string text =
        std::string(placeNames(buffer.info->domain)) + ',' + std::string(valueNames(*buffer.info)) + '\n';
    std::visit(
        [&](const auto& numbers) {
            for (std::size_t y = 0; y < buffer.rows() && out.good(); ++y) {
                for (std::size_t x = 0; x < buffer.columns(); ++x) {
                    if (picture) {
                        append(text, x);
                        text += ',';
                    }
                    append(text, y);
                    const bool isEmpty = buffer.hasValue && !(*buffer.hasValue)[y];
                    for (std::size_t c = 0; c < channels; ++c) {
                        text += ',';
                        if (!isEmpty) append(text, numbers[(y * buffer.columns() + x) * channels + c]);
                    }
                    text += '\n';
                }
                out.write(text);
                text.clear();
            }
        },
        buffer.data);
    out.write(text);  // the names alone, where there is no line
    return out.close();
}

}  // namespace pipeline
