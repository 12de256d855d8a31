#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "pipeline/core/number.h"
#include "pipeline/formats/numbers/number_file.h"
#include "pipeline/formats/text/bytes.h"

namespace pipeline {

namespace {

// The words of a header or of a plain picture; # begins a comment.
class PnmWords {
public:
    explicit PnmWords(std::string_view bytes) : m_bytes(bytes) {}
    std::size_t at() const { return m_at; }
    std::string_view next() {
        while (m_at < m_bytes.size()) {
            if (m_bytes[m_at] == '#')
                m_at = std::min(m_bytes.find('\n', m_at), m_bytes.size());
            else if (isSpace(m_bytes[m_at]))
                ++m_at;
            else
                break;
        }
        const std::size_t from = m_at;
        while (m_at < m_bytes.size() && !isSpace(m_bytes[m_at]) && m_bytes[m_at] != '#') ++m_at;
        return m_bytes.substr(from, m_at - from);
    }
    std::optional<std::size_t> count() {
        const std::string_view word = next();
        std::size_t value = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        return error == std::errc() && end == word.data() + word.size() ? std::optional(value) : std::nullopt;
    }
    // A digit by itself: plain PBM may have no spaces.
    std::optional<std::size_t> bit() {
        while (m_at < m_bytes.size() && isSpace(m_bytes[m_at])) ++m_at;
        if (m_at == m_bytes.size() || (m_bytes[m_at] != '0' && m_bytes[m_at] != '1')) return {};
        return std::size_t(m_bytes[m_at++] - '0');
    }

private:
    static bool isSpace(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
    std::string_view m_bytes;
    std::size_t m_at = 0;
};

Result<NumberFile> readPfm(std::string_view bytes, const std::string& name, std::size_t channels, PnmWords& words,
                           NumberFile file) {
    const std::size_t at = words.at();
    const auto scale = readNumber(words.next());
    if (!scale || *scale == 0) return wrongAt(name, at, "no scale", "a number, below 0 for little-endian");
    const std::size_t start = words.at() + 1, line = file.shape[1] * channels;
    const std::size_t count = file.shape[0] * line;
    if (!hasBytes(bytes, start, 4 * count))
        return wrongAt(name, bytes.size(),
                       fmt::format("{} numbers", bytes.size() < start ? 0 : (bytes.size() - start) / 4),
                       fmt::format("{}", count));
    file.values.resize(count);
    const std::endian order = *scale < 0 ? std::endian::little : std::endian::big;
    for (std::size_t y = 0; y < file.shape[0]; ++y)  // the bottom row stands first
        for (std::size_t i = 0; i < line; ++i)
            file.values[(file.shape[0] - 1 - y) * line + i] = numberAt<float>(bytes, start + 4 * (y * line + i), order);
    file.digits = 24;
    return file;
}

}  // namespace

Result<NumberFile> readPnm(std::string_view bytes, const std::string& name, std::size_t most) {
    PnmWords words(bytes);
    const std::string_view magic = words.next();
    const bool isPfm = magic == "PF" || magic == "Pf";
    if (!isPfm && (magic.size() != 2 || magic[0] != 'P' || magic[1] < '1' || magic[1] > '6'))
        return wrongAt(name, 0, "no picture of the PNM family", "P1 to P6, PF or Pf");
    const int kind = isPfm ? 0 : magic[1] - '0';
    const std::size_t channels = magic == "PF" || kind == 3 || kind == 6 ? 3 : 1;
    const std::size_t at = words.at();
    const auto width = words.count(), height = words.count();
    if (!width || !height || *width == 0 || *height == 0) return wrongAt(name, at, "no size", "width and height");
    if (*width > most / channels / *height)
        return wrongAt(name, at, fmt::format("a picture of {} × {}", *width, *height),
                       fmt::format("at most {} pixels", most / channels));
    NumberFile file{name, {*height, *width}, {}};
    if (channels == 3) file.shape.push_back(3);
    if (isPfm) return readPfm(bytes, name, channels, words, std::move(file));
    const std::size_t atMost = words.at();
    const auto largest = kind == 1 || kind == 4 ? std::optional<std::size_t>(1) : words.count();
    if (!largest || *largest == 0 || *largest > 65535) return wrongAt(name, atMost, "no largest value", "1 to 65535");
    const std::size_t count = *width * *height * channels;
    // What the file calls white becomes 255 or 65535.
    file.kind = *largest > 255 ? NumberKind::Levels16 : NumberKind::Levels8;
    const double scale = (*largest > 255 ? 65535.0 : 255.0) / double(*largest);
    if (kind <= 3) {
        if (bytes.size() - words.at() < (kind == 1 ? count : 2 * count - 1))  // a digit each, and a space
            return wrongAt(name, bytes.size(), "the end of the file", fmt::format("{} numbers", count));
        file.values.resize(count);
        for (double& value : file.values) {
            const std::size_t place = words.at();
            const auto number = kind == 1 ? words.bit() : words.count();
            if (!number || *number > *largest)
                return wrongAt(name, place, "no number of the picture", fmt::format("0 to {}", *largest));
            value = kind == 1 ? 255.0 * double(1 - *number) : double(*number) * scale;
        }
        return file;
    }
    const std::size_t start = words.at() + 1, size = *largest > 255 ? 2 : 1;
    const std::size_t line = kind == 4 ? (*width + 7) / 8 : *width * channels * size;
    if (!hasBytes(bytes, start, line * *height))
        return wrongAt(name, bytes.size(),
                       fmt::format("{} bytes of pixels", bytes.size() < start ? 0 : bytes.size() - start),
                       fmt::format("{}", line * *height));
    file.values.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        if (kind == 4) {
            const std::size_t x = i % *width, byte = start + i / *width * line + x / 8;
            file.values[i] = (static_cast<unsigned char>(bytes[byte]) >> (7 - x % 8)) & 1 ? 0 : 255;
        } else {
            file.values[i] =
                scale * (size == 1 ? double(numberAt<std::uint8_t>(bytes, start + i))
                                   : double(numberAt<std::uint16_t>(bytes, start + 2 * i, std::endian::big)));
        }
    }
    return file;
}

}  // namespace pipeline
