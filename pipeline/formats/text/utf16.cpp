#include "pipeline/formats/text/utf16.h"

#include <array>
#include <cstdint>
#include <streambuf>

namespace pipeline {
namespace {

constexpr std::uint32_t kNoCharacter = 0xFFFD;

class Decoder {
public:
    // The first two bytes of the text are the mark.
    void add(std::string_view bytes, std::string& text) {
        for (const char byte : bytes) {
            m_unit = m_unit << 8 | static_cast<unsigned char>(byte);
            if (m_half = !m_half; m_half) continue;
            const std::uint32_t unit = m_unit & 0xFFFF;
            addUnit(m_isLittle ? unit >> 8 | (unit & 0xFF) << 8 : unit, text);
        }
    }
    void end(std::string& text) {
        if (m_half || m_high != 0) append(kNoCharacter, text);
    }

private:
    void addUnit(std::uint32_t unit, std::string& text) {
        if (!m_begun) {
            m_begun = true;
            m_isLittle = unit == 0xFFFE;
            return;
        }
        const bool isHigh = unit >= 0xD800 && unit < 0xDC00, isLow = unit >= 0xDC00 && unit < 0xE000;
        if (m_high != 0 && isLow) return append(0x10000 + ((m_high - 0xD800) << 10) + (unit - 0xDC00), text), clear();
        if (m_high != 0) append(kNoCharacter, text), clear();
        if (isHigh)
            m_high = unit;
        else
            append(isLow ? kNoCharacter : unit, text);
    }
    void clear() { m_high = 0; }

    static void append(std::uint32_t code, std::string& text) {
        const auto add = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
        if (code < 0x80) return add(code);
        if (code < 0x800) return add(0xC0 | code >> 6), add(0x80 | (code & 0x3F));
        if (code < 0x10000) return add(0xE0 | code >> 12), add(0x80 | (code >> 6 & 0x3F)), add(0x80 | (code & 0x3F));
        add(0xF0 | code >> 18), add(0x80 | (code >> 12 & 0x3F)), add(0x80 | (code >> 6 & 0x3F)),
            add(0x80 | (code & 0x3F));
    }

    bool m_begun = false, m_isLittle = false, m_half = false;
    std::uint32_t m_unit = 0;
    std::uint32_t m_high = 0;  // the first half of a pair of units
};

class Utf8Buffer : public std::streambuf {
public:
    explicit Utf8Buffer(std::unique_ptr<std::istream> from) : m_from(std::move(from)) {}

private:
    int_type underflow() override {
        m_text.clear();
        while (m_text.empty() && !m_ended) {
            std::array<char, 1 << 16> bytes;
            m_from->read(bytes.data(), bytes.size());
            m_decoder.add({bytes.data(), static_cast<std::size_t>(m_from->gcount())}, m_text);
            if (*m_from) continue;
            m_ended = true;
            m_decoder.end(m_text);
        }
        setg(m_text.data(), m_text.data(), m_text.data() + m_text.size());
        return m_text.empty() ? traits_type::eof() : traits_type::to_int_type(m_text.front());
    }

    std::unique_ptr<std::istream> m_from;
    Decoder m_decoder;
    std::string m_text;
    bool m_ended = false;
};

class Utf8Stream : public std::istream {
public:
    explicit Utf8Stream(std::unique_ptr<std::istream> from) : std::istream(nullptr), m_buffer(std::move(from)) {
        rdbuf(&m_buffer);
    }

private:
    Utf8Buffer m_buffer;
};

}  // namespace

bool isUtf16(std::string_view start) {
    if (start.size() < 10) return false;
    const bool isLittle = start.starts_with("\xFF\xFE");
    if (!isLittle && !start.starts_with("\xFE\xFF")) return false;
    for (std::size_t i = 2; i < 10; i += 2) {
        const auto low = static_cast<unsigned char>(start[isLittle ? i : i + 1]);
        if (low == 0 || low > 0x7F || start[isLittle ? i + 1 : i] != 0) return false;
    }
    return true;
}

std::string utf8Of(std::string_view text) {
    Decoder decoder;
    std::string decoded;
    decoder.add(text, decoded);
    decoder.end(decoded);
    return decoded;
}

std::unique_ptr<std::istream> utf8Of(std::unique_ptr<std::istream> stream) {
    return std::make_unique<Utf8Stream>(std::move(stream));
}

}  // namespace pipeline
