#include "pipeline/formats/numbers/inflate.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "pipeline/formats/text/bytes.h"

namespace pipeline {

namespace {

class Inflate {
public:
    Inflate(std::string_view in, std::size_t size) : m_in(in), m_size(size) {}

    std::optional<std::string> run() {
        constexpr std::size_t kHeader = 2;
        if (!hasBytes(m_in, 0, kHeader) || (m_in[0] & 15) != 8 || (m_in[1] & 32) != 0 ||
            numberAt<std::uint16_t>(m_in, 0, std::endian::big) % 31 != 0)
            return {};
        m_at = kHeader;
        for (bool last = false; !last && m_out.size() < m_size;) {
            last = bits(1) != 0;
            const unsigned type = bits(2);
            if (type == 3 || !(type == 0 ? stored() : type == 1 ? fixed() : dynamic())) return {};
        }
        return m_out.size() == m_size ? std::optional(std::move(m_out)) : std::nullopt;
    }

private:
    // Canonical Huffman codes: how many have each length, and their symbols in order.
    struct Code {
        std::array<std::uint16_t, 16> count{};
        std::array<std::uint16_t, 288> symbol{};
    };
    static Code codeOf(std::span<const std::uint8_t> lengths) {
        Code code;
        for (const std::uint8_t length : lengths) ++code.count[length];
        code.count[0] = 0;
        std::array<std::uint16_t, 16> next{};
        for (std::size_t l = 1; l < 15; ++l) next[l + 1] = std::uint16_t(next[l] + code.count[l]);
        for (std::size_t i = 0; i < lengths.size(); ++i)
            if (lengths[i]) code.symbol[next[lengths[i]]++] = std::uint16_t(i);
        return code;
    }

    unsigned bits(int n) {
        while (m_held < n) {
            if (m_at >= m_in.size()) return m_bad = true, 0u;
            m_bits |= std::uint32_t(static_cast<unsigned char>(m_in[m_at++])) << m_held, m_held += 8;
        }
        const unsigned value = m_bits & ((1u << n) - 1);
        m_bits >>= n, m_held -= n;
        return value;
    }
    // Below 0: no such code, or the end of the stream.
    int symbol(const Code& code) {
        int value = 0, first = 0, index = 0;
        for (std::size_t l = 1; l <= 15; ++l) {
            value |= int(bits(1));
            if (m_bad) return -1;
            const int count = code.count[l];
            if (value - count < first) return code.symbol[std::size_t(index + value - first)];
            index += count, first = (first + count) << 1, value <<= 1;
        }
        return -1;
    }

    bool stored() {
        m_bits = 0, m_held = 0;
        if (m_bad || !hasBytes(m_in, m_at, 4)) return false;
        const std::size_t size = numberAt<std::uint16_t>(m_in, m_at);
        m_at += 4;
        if (!hasBytes(m_in, m_at, size)) return false;
        m_out.append(m_in, m_at, std::min(size, m_size - m_out.size()));
        m_at += size;
        return true;
    }
    bool fixed() {
        std::array<std::uint8_t, 288> lengths;
        for (std::size_t i = 0; i < lengths.size(); ++i) lengths[i] = i < 144 ? 8 : i < 256 ? 9 : i < 280 ? 7 : 8;
        std::array<std::uint8_t, 30> distances;
        distances.fill(5);
        return block(codeOf(lengths), codeOf(distances));
    }
    bool dynamic() {
        static constexpr std::array<std::uint8_t, 19> kOrder{16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                                             11, 4,  12, 3, 13, 2, 14, 1, 15};
        const std::size_t lengths = bits(5) + 257, distances = bits(5) + 1, codes = bits(4) + 4;
        if (m_bad || lengths > 286 || distances > 30) return false;
        std::array<std::uint8_t, 19> ofCodes{};
        for (std::size_t i = 0; i < codes; ++i) ofCodes[kOrder[i]] = std::uint8_t(bits(3));
        const Code code = codeOf(ofCodes);
        std::array<std::uint8_t, 320> all{};
        for (std::size_t i = 0; i < lengths + distances;) {
            const int s = symbol(code);
            if (s < 0 || (s == 16 && i == 0)) return false;
            const auto value = std::uint8_t(s < 16 ? s : s == 16 ? all[i - 1] : 0);
            std::size_t times = s < 16 ? 1 : s == 16 ? 3 + bits(2) : s == 17 ? 3 + bits(3) : 11 + bits(7);
            if (m_bad || i + times > lengths + distances) return false;
            while (times-- > 0) all[i++] = value;
        }
        return block(codeOf(std::span(all).first(lengths)), codeOf(std::span(all).subspan(lengths, distances)));
    }
    bool block(const Code& lengths, const Code& distances) {
        static constexpr std::array<std::uint16_t, 29> kLength{3,  4,  5,  6,   7,   8,   9,   10,  11, 13,
                                                               15, 17, 19, 23,  27,  31,  35,  43,  51, 59,
                                                               67, 83, 99, 115, 131, 163, 195, 227, 258};
        static constexpr std::array<std::uint16_t, 30> kDistance{
            1,   2,   3,   4,   5,   7,    9,    13,   17,   25,   33,   49,   65,    97,    129,
            193, 257, 385, 513, 769, 1025, 1537, 2049, 3073, 4097, 6145, 8193, 12289, 16385, 24577};
        while (m_out.size() < m_size) {
            const int s = symbol(lengths);
            if (s < 0 || s > 285) return false;
            if (s < 256) {
                m_out += char(s);
                continue;
            }
            if (s == 256) return true;
            const auto l = std::size_t(s - 257);
            const std::size_t length = kLength[l] + bits(l < 8 || l == 28 ? 0 : int(l - 4) / 4);
            const int d = symbol(distances);
            if (d < 0 || d > 29) return false;
            const std::size_t back = kDistance[std::size_t(d)] + bits(d < 4 ? 0 : d / 2 - 1);
            if (m_bad || back > m_out.size()) return false;
            for (std::size_t i = 0; i < length && m_out.size() < m_size; ++i) m_out += m_out[m_out.size() - back];
        }
        return true;
    }

    std::string_view m_in;
    std::string m_out;
    std::size_t m_size, m_at = 0;
    std::uint32_t m_bits = 0;
    int m_held = 0;
    bool m_bad = false;  // the stream has ended
};

}  // namespace

std::optional<std::string> inflated(std::string_view stream, std::size_t size) { return Inflate(stream, size).run(); }

}  // namespace pipeline
