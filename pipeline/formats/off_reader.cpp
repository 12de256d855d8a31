#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "pipeline/core/text.h"
#include "pipeline/formats/lecture/lecture_values.h"
#include "pipeline/formats/model_formats.h"
#include "pipeline/formats/text/line_scanner.h"
#include "pipeline/formats/text/tally.h"

// OFF as text (Geomview manual, "OFF Files"): vertices, of COFF with their colours, and polygons. What else follows the
// coordinates of a vertex or the indices of a polygon on its line is left out with a remark.
namespace pipeline {
namespace {

class OffReader {
public:
    explicit OffReader(const SourceText& source)
        : m_source(source), m_window(source), m_scanner(m_window, source.name, m_errors, source.progress) {}

    Result<LoadedModel> read() {
        if (const auto counts = readHeader()) {
            readVertices(counts->vertices);
            if (m_errors.empty()) readPolygons(counts->polygons);
        }
        if (!m_errors.empty()) return m_errors;
        LoadedModel model;
        m_colours.say("vertex line", "with more than three numbers, as a colour or a normal,", "read without them",
                      model.remarks);
        m_badColors.say("vertex line", "without a colour of three numbers from 0", "read as 1 1 1", model.remarks);
        m_painted.say("polygon", "with a colour", "shown with the default material", model.remarks);
        remarkOnLeftOut(m_fewCorners.count(), m_fewCorners.about(), model.remarks);
        addObject(std::move(m_mesh), m_source, stemOf(m_source.name), model);
        return model;
    }

private:
    struct Header {
        std::size_t vertices = 0, polygons = 0;
    };

    std::optional<Header> readHeader() {
        std::string_view word;
        if (!nextWord(word)) {
            m_scanner.fail("found the end of the file", "OFF");
            return {};
        }
        // "OFF8 6 12": some data sets lack the space. The keyword itself may be missing.
        const std::size_t digits = word.find_first_of("0123456789", word.starts_with('4') ? 1 : 0);
        const std::string_view keyword = word.starts_with('4') && !word.ends_with("OFF")
                                             ? std::string_view()
                                             : word.substr(0, std::min(digits, word.size()));
        if (!keyword.empty() && !keyword.ends_with("OFF"))
            m_scanner.refuse("OFF");
        else if (keyword.starts_with('4') || keyword.ends_with("nOFF"))
            m_scanner.refuse("OFF: vertices with three coordinates");
        else if (sameLetters(m_scanner.peek(), "BINARY"))
            m_scanner.fail("found a binary OFF file", "one of text: save it as OFF in ASCII, or as PLY");
        if (!m_errors.empty()) return {};
        // "STCNOFF": each letter adds numbers to a vertex line, the normal's before the colour's.
        m_hasNormals = keyword.find('N') < keyword.rfind("OFF"), m_hasColors = keyword.find('C') < keyword.rfind("OFF");
        word.remove_prefix(keyword.size());
        const auto vertices = count(word, "the number of vertices");
        const int line = m_scanner.line();
        const auto polygons = count({}, "the number of polygons");
        // The number of edges, which nobody needs, some programs leave out.
        if (line != m_scanner.line() || !m_scanner.peek().empty()) count({}, "the number of edges");
        if (!vertices || !polygons || !m_errors.empty()) return {};
        return Header{*vertices, *polygons};
    }

    bool nextWord(std::string_view& word) {
        do word = m_scanner.next();
        while (word.empty() && m_scanner.nextLine());
        return !word.empty();
    }
    // The next number, or that of `word` where there is one. expected(): what a message names.
    template <class Expected>
    std::optional<double> number(std::string_view word, Expected expected) {
        if (word.empty() && !nextWord(word)) {
            m_scanner.fail("found the end of the file", expected());
            return {};
        }
        const std::optional<double> value = parseNumber(word);
        if (!value) m_scanner.refuse(expected());
        return value;
    }
    std::optional<std::size_t> count(std::string_view word, std::string_view what) {
        if (!m_errors.empty()) return {};
        const auto value = number(word, [&] { return std::string(what); });
        if (!value) return {};
        if (*value >= 0 && *value <= double(kMaxVertices) && *value == double(std::size_t(*value)))
            return std::size_t(*value);
        m_scanner.refuse(fmt::format("{}, from 0 to {}", what, groupedDigits(kMaxVertices)));
        return {};
    }

    void readVertices(std::size_t vertices) {
        for (std::size_t i = 0; i < vertices && m_errors.empty(); ++i) {
            Vec3d p(0.0);
            for (int axis = 0; axis < 3 && m_errors.empty(); ++axis) {
                const auto expected = [&] {
                    return fmt::format("{} of vertex {}, {}", "xyz"[axis], i,
                                       numberFrom(-kFarthestVertex, kFarthestVertex));
                };
                const auto value = number({}, expected);
                if (value && !isCoordinate(*value)) m_scanner.refuse(expected());
                p[axis] = value.value_or(0);
            }
            m_mesh.positions.push_back(p);
            if (!m_errors.empty()) return;
            if (m_hasColors) {
                readColor();
            } else if (!m_scanner.next().empty()) {
                m_colours.add(m_source.name, m_scanner.line());
                m_scanner.rest();
            }
        }
    }

    // Of the vertex line that is being read. Its opacity is left out.
    void readColor() {
        for (int i = 0; m_hasNormals && i < 3; ++i) m_scanner.next();
        Vec3d color(0.0);
        bool isOne = true, isThere = false;
        for (int c = 0; c < 3; ++c) {
            const std::string_view word = m_scanner.next();
            isThere = isThere || !word.empty();
            const auto value = parseNumber(word);
            isOne = isOne && value && isColor(*value);
            color[c] = isOne ? *value : 0;
        }
        m_scanner.rest();
        if (!isOne && isThere) m_badColors.add(m_source.name, m_scanner.line());
        m_mesh.colors.push_back(isOne ? color : Vec3d(1));
    }

    void readPolygons(std::size_t polygons) {
        const std::size_t vertices = m_mesh.positions.size();
        std::vector<std::uint32_t> corners;
        for (std::size_t i = 0; i < polygons && m_errors.empty(); ++i) {
            const auto n = count({}, "the number of a polygon's vertices");
            const TextPosition place{m_scanner.line(), 1};
            corners.clear();
            for (std::size_t k = 0; n && k < *n && m_errors.empty(); ++k) {
                const auto corner = number({}, [] { return std::string("a vertex index"); });
                if (!corner) break;
                if (*corner >= 0 && *corner < double(vertices) && *corner == double(std::uint32_t(*corner)))
                    corners.push_back(std::uint32_t(*corner));
                else
                    m_scanner.refuse(vertices == 0 ? "no polygon: there are no vertices"
                                                   : fmt::format("a vertex index from 0 to {}", vertices - 1));
            }
            if (!m_errors.empty()) return;
            if (!m_scanner.next().empty()) {
                m_painted.add(m_source.name, place.line);
                m_scanner.rest();
            }
            if (!addPolygon(m_mesh, corners, place)) m_fewCorners.add(m_source.name, place.line);
        }
    }

    const SourceText& m_source;
    Errors m_errors;
    ByteWindow m_window;
    LineScanner m_scanner;
    Mesh m_mesh;
    bool m_hasNormals = false, m_hasColors = false;
    CaseTally m_colours, m_badColors, m_painted, m_fewCorners;
};

}  // namespace

Result<LoadedModel> readOff(const SourceText& source, const FileLoader&) { return OffReader(source).read(); }

}  // namespace pipeline
