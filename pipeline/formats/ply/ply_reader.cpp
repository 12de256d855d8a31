#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "pipeline/core/text.h"
#include "pipeline/formats/lecture/lecture_values.h"
#include "pipeline/formats/model_formats.h"
#include "pipeline/formats/ply/ply_header.h"
#include "pipeline/formats/text/bytes.h"
#include "pipeline/formats/text/tally.h"

// PLY (G. Turk, The PLY Polygon File Format, 1994): vertices with or without normals, and faces.
// Colours of faces, other properties and other elements are left out, with a remark.
namespace pipeline {
namespace {

// The numbers after the header, whatever form they are written in.
class PlyBody {
public:
    PlyBody(const SourceText& source, ByteWindow& bytes, PlyForm form, LineScanner& scanner, Errors& errors)
        : m_name(source.name),
          m_bytes(bytes),
          m_form(form),
          m_scanner(scanner),
          m_errors(errors),
          m_meter(bytes.size(), source.name, source.progress),
          m_at(std::min(scanner.nextLineAt(), bytes.size())) {
        // Where lines end with CR alone, a LF behind the last of them is the first byte of the numbers.
        const std::string_view start = source.text;
        const std::size_t first = start.find('\r');
        const bool endsWithCr = first < start.find('\n') && start.substr(first, 2) != "\r\n";
        if (!isText() && endsWithCr && m_at <= start.size() && start.substr(0, m_at).ends_with("\r\n")) --m_at;
    }

    // In text form the scanner tells.
    bool goesOn() { return isText() || m_meter.goesOn(m_at, m_errors); }

    bool isText() const { return m_form == PlyForm::Text; }

    // Whether the rest of the file has room for so many rows of at least so many words and bytes.
    bool hasRoom(std::size_t rows, std::size_t words, std::size_t bytes) const {
        const std::size_t left = m_bytes.size() - std::min(m_at, m_bytes.size());
        // A word and what parts it from the next take two bytes.
        return isText() ? rows <= (left + 1) / (2 * words) : rows <= left / bytes;
    }

    // Nothing where the file ends or a word is no number; that is reported.
    // mayBeNone: a text may have NaN or infinity there, however it is spelt, which is NaN then.
    std::optional<double> next(PlyType type, std::string_view what, bool mayBeNone = false) {
        if (isText()) return nextWord(what, mayBeNone);
        if (!m_bytes.has(m_at, byteCount(type))) {
            fail(fmt::format("the file ends after {} bytes", groupedDigits(m_bytes.size())), std::string(what));
            return {};
        }
        m_valueAt = m_at;
        m_at += byteCount(type);
        return m_value = read(type);
    }

    // Reports the number read last.
    void refuse(std::string expected) {
        if (isText()) return m_scanner.refuse(std::move(expected));
        fail(fmt::format("found {} at byte {}", shortestText(m_value), groupedDigits(m_valueAt)), std::move(expected));
    }
    void fail(std::string found, std::string expected) {
        if (m_errors.size() < kMaxErrors) m_errors.push_back({{m_name, 0, 0}, std::move(found), std::move(expected)});
    }
    // In text form a row ends with its line, whatever else stands there.
    void endRow() {
        if (!isText() || m_scanner.next().empty()) return;
        m_longer.add(m_name, m_scanner.line());
        m_scanner.rest();
    }
    const CaseTally& longerRows() const { return m_longer; }
    // What is there after the last element, as a remark; empty where nothing is.
    std::string rest() {
        if (!isText()) {
            const std::size_t bytes = m_bytes.size() - std::min(m_at, m_bytes.size());
            if (bytes == 0) return {};
            return fmt::format("The last {} after the last element {} not read.",
                               bytes == 1 ? "byte" : groupedDigits(bytes) + " bytes", bytes == 1 ? "is" : "are");
        }
        if (wordOnAnyLine().empty()) return {};
        return fmt::format("What stands after the last element, from line {} on, is not read.", m_scanner.line());
    }
    // The line suffices: a row is one, and counting columns would take quadratic time where it is not.
    TextPosition place() const { return isText() ? TextPosition{m_scanner.line(), 1} : TextPosition{}; }

private:
    // "nan", "-nan(ind)", "inf", "1.#QNAN".
    static bool isNoNumber(std::string_view word) {
        return word.find_first_of("nN#") != word.npos &&
               word.find_first_not_of("+-.#()0123456789abdfinqstyABDFINQSTY") == word.npos;
    }

    // Some programs write comments between rows as well.
    std::string_view wordOnAnyLine() {
        std::string_view word = m_scanner.next();
        while (word.empty() && m_scanner.nextLine()) {
            word = m_scanner.next();
            if (word != "comment" && word != "obj_info") continue;
            m_scanner.rest();
            word = {};
        }
        return word;
    }

    std::optional<double> nextWord(std::string_view what, bool mayBeNone) {
        const std::string_view word = wordOnAnyLine();
        m_at = m_scanner.at();
        const std::optional<double> value = parseNumber(word);
        if (!value && mayBeNone && isNoNumber(word)) return std::numeric_limits<double>::quiet_NaN();
        if (!value) {
            if (word.empty())
                m_scanner.fail("found the end of the file", std::string(what));
            else
                m_scanner.refuse(std::string(what));
        }
        return value;
    }

    double read(PlyType type) const {
        const std::string_view bytes = m_bytes.view().substr(m_valueAt - m_bytes.begin());
        const std::endian order = m_form == PlyForm::BigEndian ? std::endian::big : std::endian::little;
        switch (type) {
            case PlyType::Int8: return numberAt<std::int8_t>(bytes, 0);
            case PlyType::Uint8: return numberAt<std::uint8_t>(bytes, 0);
            case PlyType::Int16: return numberAt<std::int16_t>(bytes, 0, order);
            case PlyType::Uint16: return numberAt<std::uint16_t>(bytes, 0, order);
            case PlyType::Int32: return numberAt<std::int32_t>(bytes, 0, order);
            case PlyType::Uint32: return numberAt<std::uint32_t>(bytes, 0, order);
            case PlyType::Float: return numberAt<float>(bytes, 0, order);
            case PlyType::Double: return numberAt<double>(bytes, 0, order);
        }
        return 0;
    }

    const std::string& m_name;
    ByteWindow& m_bytes;
    PlyForm m_form;
    LineScanner& m_scanner;
    Errors& m_errors;
    ReadMeter m_meter;
    CaseTally m_longer;
    std::size_t m_at;  // the next byte
    std::size_t m_valueAt = 0;
    double m_value = 0;
};

struct PlyRow {
    double values[9] = {};  // x, y, z, the normal and the colour
    std::vector<std::uint32_t> corners;
};

bool isWhole(double value, double end) { return value >= 0 && value < end && value == std::floor(value); }

// Between two strips.
constexpr std::uint32_t kNextStrip = UINT32_MAX;

bool readList(PlyBody& body, const PlyProperty& property, std::size_t vertexCount, bool isStrips, PlyRow& row) {
    const std::optional<double> count = body.next(property.countType, "the length of a list");
    if (!count) return false;
    const bool whole = isWhole(*count, 4294967296.0);
    if (!whole || !body.hasRoom(static_cast<std::size_t>(*count), 1, byteCount(property.type))) {
        body.refuse("the length of a list that the file has room for");
        return false;
    }
    const auto length = static_cast<std::size_t>(*count);
    const bool isCorners = property.role == PlyRole::Corners;
    if (isCorners) row.corners.clear();
    for (std::size_t k = 0; k < length; ++k) {
        const std::optional<double> value = body.next(property.type, "a number");
        if (!value) return false;
        if (!isCorners) continue;
        if (isStrips && *value == -1) {
            row.corners.push_back(kNextStrip);
            continue;
        }
        if (!isWhole(*value, double(vertexCount))) {
            body.refuse(vertexCount == 0 ? "no corner: there are no vertices"
                                         : fmt::format("a vertex index from 0 to {}", vertexCount - 1));
            return false;
        }
        row.corners.push_back(static_cast<std::uint32_t>(*value));
    }
    return true;
}

// What stands for 1 in a colour of whole numbers.
double wholeOf(const PlyProperty& property) {
    if (property.role < PlyRole::Red || property.role > PlyRole::Blue) return 1;
    return property.type == PlyType::Uint8 ? 255 : property.type == PlyType::Uint16 ? 65535 : 1;
}
// Whether all three roles from this one on are there.
bool hasThree(const PlyElement& element, PlyRole first) {
    int found = 0;
    for (int i = 0; i < 3; ++i)
        found += std::ranges::find(element.properties, PlyRole(int(first) + i), &PlyProperty::role) !=
                 element.properties.end();
    return found == 3;
}

// False when the rest of the file cannot be made sense of.
bool readRow(PlyBody& body, const PlyElement& element, std::size_t index, std::size_t vertexCount, PlyRow& row) {
    for (const PlyProperty& property : element.properties) {
        if (property.isList) {
            if (!readList(body, property, vertexCount, isStrips(element), row)) return false;
            continue;
        }
        const std::optional<double> value = body.next(property.type, "a number", property.role > PlyRole::Z);
        if (!value) return false;
        if (property.role == PlyRole::Other) continue;
        row.values[static_cast<std::size_t>(property.role)] = *value / wholeOf(property);
        if (property.role <= PlyRole::Z && !isCoordinate(*value)) {
            body.refuse(
                fmt::format("a coordinate of vertex {}, {}", index, numberFrom(-kFarthestVertex, kFarthestVertex)));
            return false;
        }
    }
    return true;
}

bool checkRoom(PlyBody& body, const PlyElement& element, std::size_t fileSize) {
    std::size_t bytes = 0;
    for (const PlyProperty& property : element.properties)
        bytes += byteCount(property.isList ? property.countType : property.type);
    const bool fits = element.count == 0 || body.hasRoom(element.count, element.properties.size(), bytes);
    const std::string announced =
        fmt::format("{} elements {} announced", groupedDigits(element.count), quotedInput(element.name));
    if (!fits)
        body.fail(fmt::format("{}, the file ends after {} bytes", announced, groupedDigits(fileSize)), {});
    else if (element.count > kMaxVertices)
        body.fail(announced, fmt::format("at most {}", groupedDigits(kMaxVertices)));
    return fits && element.count <= kMaxVertices;
}

// The triangles of strips, every other one turned round so that all face alike. One that repeats a corner has no area:
// strips go on elsewhere by such triangles, which are no loss.
void addStrips(Mesh& mesh, std::span<const std::uint32_t> corners, TextPosition place) {
    std::size_t first = 0;  // of this strip
    for (std::size_t k = 0; k < corners.size(); ++k) {
        if (corners[k] == kNextStrip) first = k + 1;
        if (k < first + 2) continue;
        const bool turned = (k - first) % 2 == 1;
        const std::uint32_t triangle[3]{corners[k - 2], corners[turned ? k : k - 1], corners[turned ? k - 1 : k]};
        addPolygon(mesh, triangle, place);
    }
}

// What there is of the rows beside polygons and normals that are used.
struct Counts {
    std::size_t leftOut = 0;         // polygons
    std::size_t unknownNormals = 0;  // of vertices
    std::size_t unknownColors = 0;   // likewise
};

Counts readElements(PlyBody& body, const PlyHeader& header, std::size_t fileSize, Mesh& mesh) {
    Counts counts;
    bool hasAllNormals = true;
    PlyRow row;
    for (const PlyElement& element : header.elements) {
        if (!checkRoom(body, element, fileSize)) return counts;
        const bool hasCorners =
            std::ranges::find(element.properties, PlyRole::Corners, &PlyProperty::role) != element.properties.end();
        const bool isVertex = element.name == "vertex", isFace = element.name == "face" && hasCorners;
        const bool strips = isStrips(element) && hasCorners;
        const bool hasNormals = isVertex && hasThree(element, PlyRole::NormalX);
        const bool hasColors = isVertex && hasThree(element, PlyRole::Red);
        if (isVertex) hasAllNormals = hasNormals;
        if (isVertex) mesh.positions.reserve(element.count);
        if (hasNormals) mesh.normals.reserve(element.count);
        if (hasColors) mesh.colors.reserve(element.count);
        if (isFace) mesh.reservePolygons(element.count, 3 * element.count);  // mostly they are triangles
        for (std::size_t i = 0; i < element.count; ++i) {
            if (!body.goesOn() || !readRow(body, element, i, mesh.positions.size(), row)) return counts;
            body.endRow();
            if (isVertex) mesh.positions.push_back({row.values[0], row.values[1], row.values[2]});
            if (hasNormals) {
                const std::optional<Vec3d> normal = unitVector({row.values[3], row.values[4], row.values[5]});
                if (!normal) ++counts.unknownNormals;
                mesh.normals.push_back(normal.value_or(Vec3d(0.0)));
            }
            if (hasColors) {
                const double* const color = &row.values[std::size_t(PlyRole::Red)];
                const bool isOne = std::all_of(color, color + 3, isColor);
                counts.unknownColors += !isOne;
                mesh.colors.push_back(isOne ? Vec3d(color[0], color[1], color[2]) : Vec3d(1));
            }
            if (strips) addStrips(mesh, row.corners, body.place());
            if (isFace && !addPolygon(mesh, row.corners, body.place())) ++counts.leftOut;
        }
    }
    body.goesOn();
    if (!hasAllNormals || counts.unknownNormals > 0) mesh.normals.clear();
    return counts;
}

// Colours first; the other properties by their names.
void remarkOnProperties(const PlyElement& element, const std::string& file, std::vector<Remark>& remarks) {
    constexpr std::string_view kColors[]{"red",
                                         "green",
                                         "blue",
                                         "alpha",
                                         "diffuse_red",
                                         "diffuse_green",
                                         "diffuse_blue",
                                         "diffuse_alpha",
                                         "ambient_red",
                                         "ambient_green",
                                         "ambient_blue",
                                         "specular_red",
                                         "specular_green",
                                         "specular_blue",
                                         "r",
                                         "g",
                                         "b",
                                         "a"};
    const bool isColored = element.name == "vertex" && hasThree(element, PlyRole::Red);
    bool hasColor = false;
    std::vector<std::string> names;
    for (const PlyProperty& property : element.properties) {
        const bool isPart = property.role >= PlyRole::Red && property.role <= PlyRole::Blue;
        if (isPart ? isColored : property.role != PlyRole::Other) continue;
        if (!isColored && std::ranges::find(kColors, property.name) != std::end(kColors))
            hasColor = true;
        else if (names.size() < 5)
            names.push_back(inQuotes(property.name));
        else if (names.size() == 5)
            names.emplace_back("others");
    }
    const std::string of =
        fmt::format("{} of the element {}", groupedDigits(element.count) + (element.count == 1 ? " row" : " rows"),
                    inQuotes(element.name));
    if (hasColor) remarks.push_back({file, fmt::format("The colours of {} are not read.", of)});
    if (!names.empty())
        remarks.push_back(
            {file, fmt::format("{} of {} {} not read.", fmt::join(names, ", "), of, names.size() == 1 ? "is" : "are")});
}

void remarkOnElements(const PlyHeader& header, const std::string& file, std::vector<Remark>& remarks) {
    if (header.unknownLines > 0)
        remarks.push_back(
            {file, fmt::format("{} of the header, from line {} on, {} no keyword of PLY and {} not read.",
                               plural(std::int64_t(header.unknownLines), "line"), header.firstUnknown,
                               header.unknownLines == 1 ? "has" : "have", header.unknownLines == 1 ? "is" : "are")});
    for (const PlyElement& element : header.elements) {
        if (element.count == 0) continue;
        if (element.name == "vertex" || hasPolygons(element))
            remarkOnProperties(element, file, remarks);
        else
            remarks.push_back(
                {file, fmt::format("The element {} ({}) is not read.", inQuotes(element.name),
                                   groupedDigits(element.count) + (element.count == 1 ? " row" : " rows"))});
    }
}

}  // namespace

Result<LoadedModel> readPly(const SourceText& source, const FileLoader&) {
    Errors errors;
    ByteWindow bytes(source);
    LineScanner scanner(bytes, source.name, errors, source.progress);
    const PlyHeader header = readPlyHeader(scanner);
    if (!errors.empty()) return errors;
    Mesh mesh;
    PlyBody body(source, bytes, header.form, scanner, errors);
    const Counts counts = readElements(body, header, bytes.size(), mesh);
    if (!errors.empty()) return errors;
    LoadedModel model;
    remarkOnElements(header, source.name, model.remarks);
    body.longerRows().say("row", "with more words than the header says", "read without them", model.remarks);
    if (counts.unknownNormals > 0)
        model.remarks.push_back(
            {source.name,
             fmt::format("{} no direction; the normals of the file are not used.",
                         counts.unknownNormals == 1 ? "1 normal has"
                                                    : groupedDigits(counts.unknownNormals) + " normals have")});
    if (counts.unknownColors > 0)
        model.remarks.push_back(
            {source.name, fmt::format("{} not three numbers from 0 up; it is taken as white.",
                                      counts.unknownColors == 1
                                          ? "1 colour of a vertex is"
                                          : groupedDigits(counts.unknownColors) + " colours of vertices are")});
    remarkOnLeftOut(counts.leftOut, source.name, model.remarks);
    if (std::string rest = body.rest(); !rest.empty()) model.remarks.push_back({source.name, std::move(rest)});
    if (!errors.empty()) return errors;
    addObject(std::move(mesh), source, stemOf(source.name), model);
    return model;
}

}  // namespace pipeline
