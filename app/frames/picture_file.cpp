#include "app/frames/picture_file.h"

#include <fmt/format.h>

#include <QImageReader>
#include <QRegularExpression>
#include <cstring>

#include "pipeline/export/buffers/exr_file.h"
#include "pipeline/formats/scene_folder.h"
#include "pipeline/scene/key_places.h"

namespace app {

using pipeline::AnyBuffer;
using pipeline::Error;
using pipeline::Result;

namespace {

Error wrong(const QString& file, std::string found, std::string expected = {}) {
    return {{file.toStdString()}, std::move(found), std::move(expected)};
}

template <class T>
void take(AnyBuffer& buffer, const QByteArray& bytes, std::size_t count) {
    auto numbers = std::make_shared<std::vector<T>>(count);
    std::memcpy(numbers->data(), bytes.constData(), count * sizeof(T));
    buffer.data = std::span<const T>(*numbers);
    buffer.owner = std::move(numbers);
}

// "numpy.lib.format", NumPy reference: 6 bytes of magic, 2 of version, the length of the header in
// 2 bytes (4 from version 2 on), the header as a Python dictionary, the numbers.
Result<AnyBuffer> readNpy(const QString& file, const AnyBuffer& like) {
    // A buffer as large as a picture may be, in the widest type, and a header.
    constexpr std::size_t kMost = (std::size_t{1} << 30) + (std::size_t{1} << 16);
    const auto text = pipeline::readFile(file.toStdString(), kMost);
    if (!text) return pipeline::namedAt({file.toStdString()}, text.errors());
    const auto bytes = QByteArray::fromRawData(text->data(), qsizetype(text->size()));
    const auto byte = [&](qsizetype i) { return qsizetype(static_cast<unsigned char>(bytes[i])); };
    if (bytes.size() < 12 || !bytes.startsWith("\x93NUMPY")) return wrong(file, "no NumPy array");
    const bool isFirst = byte(6) == 1;
    const qsizetype start = isFirst ? 10 : 12;
    const qsizetype length = byte(8) + (byte(9) << 8) + (isFirst ? 0 : (byte(10) << 16) + (byte(11) << 24));
    if (start + length > bytes.size()) return wrong(file, "the file ends within its header");
    const QString header = QString::fromLatin1(bytes.mid(start, length));
    static const QRegularExpression kHeader(
        R"(^\{'descr': '([<|])(f4|f8|i4|u1)', 'fortran_order': False, 'shape': \(([0-9, ]*)\), \}\s*$)");
    const auto match = kHeader.match(header);
    if (!match.hasMatch())
        return wrong(file, fmt::format("its header is {}", header.trimmed().toStdString()),
                     "float32, float64, int32 or uint8, little-endian, in C order");
    AnyBuffer read{like.name, like.info, {}, {}, nullptr};
    double count = 1;  // cannot overflow
    for (const QString& part : match.captured(3).split(',')) {
        if (part.trimmed().isEmpty()) continue;
        read.shape.push_back(std::size_t(part.trimmed().toULongLong()));
        count *= double(read.shape.back());
    }
    if (read.shape.size() != like.shape.size())
        return wrong(file, fmt::format("an array of {} dimensions", read.shape.size()),
                     std::to_string(like.shape.size()));
    const QString type = match.captured(2);
    const QByteArray numbers = bytes.mid(start + length);
    const double needed = count * (type == "f8" ? 8 : type == "u1" ? 1 : 4);
    if (needed != double(numbers.size()))
        return wrong(file, fmt::format("{} bytes of numbers", numbers.size()), fmt::format("{:.0f}", needed));
    const auto n = std::size_t(count);
    if (type == "f4") take<float>(read, numbers, n);
    if (type == "f8") take<double>(read, numbers, n);
    if (type == "i4") take<std::int32_t>(read, numbers, n);
    if (type == "u1") take<std::uint8_t>(read, numbers, n);
    return read;
}

Result<AnyBuffer> readColors(const QString& file, const AnyBuffer& like) {
    if (like.info->element != pipeline::Element::UInt8 || like.channels() != 3)
        return wrong(file, fmt::format("8-bit colours cannot be compared with {}", like.name.text()),
                     "the buffer color, or a .npy file");
    QImageReader reader(file);
    const QImage image = reader.read().convertToFormat(QImage::Format_RGB888);
    if (image.isNull()) return wrong(file, reader.errorString().toStdString());
    auto numbers = std::make_shared<std::vector<std::uint8_t>>();
    for (int y = 0; y < image.height(); ++y)
        numbers->insert(numbers->end(), image.constScanLine(y), image.constScanLine(y) + 3 * image.width());
    AnyBuffer read{like.name, like.info, {std::size_t(image.height()), std::size_t(image.width()), 3}, {}, nullptr};
    read.data = std::span<const std::uint8_t>(*numbers);
    read.owner = std::move(numbers);
    return read;
}

}  // namespace

Result<AnyBuffer> readPicture(const QString& file, const AnyBuffer& like) {
    if (file.endsWith(".exr", Qt::CaseInsensitive)) return pipeline::readExr(file.toStdString(), like);
    return file.endsWith(".npy", Qt::CaseInsensitive) ? readNpy(file, like) : readColors(file, like);
}

}  // namespace app
