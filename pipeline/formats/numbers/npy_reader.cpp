#include <fmt/format.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>

#include "pipeline/core/text.h"
#include "pipeline/formats/numbers/number_file.h"
#include "pipeline/formats/text/bytes.h"

// NumPy's array file: "numpy.lib.format", NumPy reference, versions 1.0 to 3.0.
namespace pipeline {

namespace {

struct ElementType {
    char kind = 'f';  // f, i, u, b
    int size = 8;     // bytes
    std::endian order = std::endian::little;
};

// The value that stands after 'key': in the header's dictionary.
std::string_view npyField(std::string_view header, std::string_view key) {
    const std::string quoted = fmt::format("'{}'", key);
    auto at = header.find(quoted);
    if (at == header.npos) return {};
    at = header.find(':', at + quoted.size());
    if (at == header.npos) return {};
    at = header.find_first_not_of(' ', at + 1);
    return at == header.npos ? std::string_view() : header.substr(at);
}

std::optional<ElementType> npyType(std::string_view field) {
    // '<f4', '|u1', '>i2', '=f8', '|b1'
    if (field.size() < 5 || (field[0] != '\'' && field[0] != '"')) return {};
    ElementType type;
    const char order = field[1];
    if (order != '<' && order != '>' && order != '=' && order != '|') return {};
    type.order = order == '>' ? std::endian::big : order == '<' ? std::endian::little : std::endian::native;
    type.kind = field[2] == '?' ? 'b' : field[2];
    const auto [end, error] = std::from_chars(field.data() + 3, field.data() + field.size(), type.size);
    if (error != std::errc() || end == field.data() + field.size() || *end != field[0]) return {};
    const int size = type.size;
    const bool known = type.kind == 'f'   ? size == 2 || size == 4 || size == 8
                       : type.kind == 'b' ? size == 1
                                          : (type.kind == 'i' || type.kind == 'u') &&
                                                (size == 1 || size == 2 || size == 4 || size == 8);
    return known ? std::optional(type) : std::nullopt;
}

std::optional<std::vector<std::size_t>> npyShape(std::string_view field) {
    if (field.empty() || field[0] != '(') return {};
    std::vector<std::size_t> shape;
    const char* at = field.data() + 1;
    const char* const end = field.data() + field.size();
    while (at != end && *at != ')') {
        if (*at == ' ' || *at == ',') {
            ++at;
            continue;
        }
        std::size_t length = 0;
        const auto [after, error] = std::from_chars(at, end, length);
        if (error != std::errc() || shape.size() == 4) return {};
        shape.push_back(length);
        at = after;
    }
    return at == end ? std::nullopt : std::optional(shape);
}

double halfToDouble(std::uint16_t bits) {
    const int exponent = (bits >> 10) & 31, fraction = bits & 1023;
    const double magnitude = exponent == 31  ? (fraction ? std::nan("") : HUGE_VAL)
                             : exponent == 0 ? std::ldexp(fraction, -24)
                                             : std::ldexp(1024 + fraction, exponent - 25);
    return bits >> 15 ? -magnitude : magnitude;
}

double npyElement(std::string_view bytes, std::size_t at, const ElementType& type) {
    const auto as = [&]<class T>(T) { return static_cast<double>(numberAt<T>(bytes, at, type.order)); };
    switch (type.kind) {
        case 'f':
            if (type.size == 2) return halfToDouble(numberAt<std::uint16_t>(bytes, at, type.order));
            return type.size == 4 ? as(float{}) : as(double{});
        case 'i':
            switch (type.size) {
                case 1: return as(std::int8_t{});
                case 2: return as(std::int16_t{});
                case 4: return as(std::int32_t{});
                default: return as(std::int64_t{});
            }
        case 'b': return numberAt<std::uint8_t>(bytes, at) != 0 ? 1 : 0;
        default: break;
    }
    switch (type.size) {
        case 1: return as(std::uint8_t{});
        case 2: return as(std::uint16_t{});
        case 4: return as(std::uint32_t{});
        default: return as(std::uint64_t{});
    }
}

// Where the element that stands at `i` in C order stands in Fortran's.
std::size_t fortranPlace(std::size_t i, const std::vector<std::size_t>& shape) {
    std::size_t place = 0;
    std::vector<std::size_t> at(shape.size());
    for (std::size_t axis = shape.size(); axis-- > 0;) at[axis] = i % shape[axis], i /= shape[axis];
    for (std::size_t axis = shape.size(); axis-- > 0;) place = place * shape[axis] + at[axis];
    return place;
}

}  // namespace

Result<NumberFile> readNpy(std::string_view bytes, const std::string& name, std::size_t most) {
    constexpr std::string_view kMagic = "\x93NUMPY";
    if (!bytes.starts_with(kMagic)) return wrongAt(name, 0, "no array of NumPy", "a file that numpy.save has written");
    if (!hasBytes(bytes, 6, 4)) return wrongAt(name, bytes.size(), "the end of the file", "a header");
    const int version = static_cast<unsigned char>(bytes[6]);
    if (version < 1 || version > 3) return wrongAt(name, 6, fmt::format("version {}", version), "1, 2 or 3");
    const std::size_t before = version == 1 ? 10 : 12;
    if (!hasBytes(bytes, 8, before - 8)) return wrongAt(name, bytes.size(), "the end of the file", "a header");
    const std::size_t length = version == 1 ? numberAt<std::uint16_t>(bytes, 8) : numberAt<std::uint32_t>(bytes, 8);
    if (!hasBytes(bytes, before, length))
        return wrongAt(name, bytes.size(), "the end of the file", fmt::format("a header of {} bytes", length));
    const std::string_view header = bytes.substr(before, length);
    const auto type = npyType(npyField(header, "descr"));
    if (!type)
        return wrongAt(name, before, "an array of " + inQuotes(npyField(header, "descr").substr(0, 12)),
                       "whole or floating-point numbers of up to 8 bytes");
    const auto shape = npyShape(npyField(header, "shape"));
    if (!shape) return wrongAt(name, before, "no shape of up to 4 lengths", "as in (480, 640, 3)");
    std::size_t count = 1;
    for (const std::size_t side : *shape) {
        if (side != 0 && count > most / side)
            return wrongAt(name, before, "an array of " + NumberFile{name, *shape, {}}.sizeText(),
                           fmt::format("at most {} numbers", most));
        count *= side;
    }
    const std::size_t start = before + length, size = std::size_t(type->size);
    const std::size_t there = (bytes.size() - start) / size;
    if (there < count)
        return wrongAt(name, bytes.size(), fmt::format("{} numbers", there),
                       fmt::format("{}, of an array of {}", count, NumberFile{name, *shape, {}}.sizeText()));
    NumberFile file{name, *shape, std::vector<double>(count)};
    file.kind = type->kind == 'f' ? NumberKind::Real : NumberKind::Whole;
    file.digits = type->kind != 'f' ? 53 : size == 2 ? 11 : size == 4 ? 24 : 53;
    const std::string_view order = npyField(header, "fortran_order");
    const bool fortran = order.starts_with("True");
    for (std::size_t i = 0; i < count; ++i)
        file.values[i] = npyElement(bytes, start + size * (fortran ? fortranPlace(i, *shape) : i), *type);
    return file;
}

}  // namespace pipeline
