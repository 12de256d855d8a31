#include <algorithm>
#include <array>
#include <map>

#include <fmt/format.h>

#include "pipeline/formats/lecture/lecture_values.h"
#include "pipeline/formats/obj/obj_file.h"
#include "pipeline/formats/text/line_scanner.h"

namespace pipeline {
namespace {

constexpr std::uint32_t kNoGroup = UINT32_MAX;
// Objects that `g` makes: a file may name as many groups as it has faces.
constexpr std::size_t kMostGroups = 4096;

// An index from 1, or from -1 for the last one; returned from 0.
std::optional<std::uint32_t> readIndex(std::string_view word, std::size_t count) {
    const bool fromLast = word.starts_with('-');
    if (fromLast) word.remove_prefix(1);
    const std::optional<std::uint64_t> index = word.starts_with('+') ? std::nullopt : parseCount(word);
    if (!index || *index == 0 || *index > count) return {};
    return static_cast<std::uint32_t>(fromLast ? count - *index : *index - 1);
}

std::string indexRange(std::string_view what, std::size_t count) {
    if (count == 0) return fmt::format("a {} before the first index of one", what);
    return fmt::format("the index of a {} above, 1 to {} or -{} to -1", what, count, count);
}

// The number that is meant by "0,25" or "1.234,5", as a hint behind what a message expects.
std::string commaHint(std::string_view word) {
    const std::size_t comma = word.find(',');
    if (comma == word.npos) return {};
    std::string meant;
    for (const char c : word)
        if (c == ',')
            meant += '.';
        else if (c != '.')
            meant += c;
    return parseNumber(meant) ? fmt::format("; write the decimal point as in {}", meant) : std::string();
}

// Statements of the format that change no polygon: of textures, of the surfaces and curves that are counted
// themselves, and of how they are displayed.
constexpr auto kIdleStatements = std::to_array<std::string_view>(
    {"vp",     "cstype",     "deg",       "bmat",  "step",  "parm",     "trim",     "hole",  "scrv",
     "sp",     "end",        "con",       "mg",    "bevel", "c_interp", "d_interp", "lod",   "maplib",
     "usemap", "shadow_obj", "trace_obj", "ctech", "stech", "merge",    "res",      "matlib"});

class ObjParser {
public:
    ObjParser(const SourceText& source, ObjMaterials& materials, Errors& errors)
        : m_source(source),
          m_materials(materials),
          m_window(source),
          m_scanner(m_window, source.name, errors, source.progress) {
        m_objectName = stemOf(source.name);
    }

    ObjFile read() {
        while (m_scanner.nextLine()) {
            const std::string_view word = m_scanner.next();
            if (word == "v")
                readVertex();
            else if (word == "vt" || word.empty())
                continue;
            else if (word == "vn")
                readNormal();
            else if (word == "f" || word == "fo")
                readFace();
            else
                readOther(word);
        }
        return std::move(m_file);
    }

private:
    void readOther(std::string_view word) {
        if (word == "o")
            beginObject(m_scanner.rest());
        else if (word == "g")
            beginGroup(m_scanner.rest());
        else if (word == "s")
            m_smoothing = smoothingGroup(m_scanner.next());
        else if (word == "usemtl")
            m_material = m_scanner.rest(), m_group = kNoGroup;
        else if (word == "mtllib")
            m_materials.load(m_scanner.rest(), m_scanner.line());
        else if (word == "p")
            count(m_file.tallies.points);
        else if (word == "l")
            count(m_file.tallies.lines);
        else if (word == "curv" || word == "curv2" || word == "surf" || word == "bzp" || word == "bsp" ||
                 word == "cdc" || word == "cdp")
            count(m_file.tallies.freeForms);
        else if (word == "call" || word == "csh")
            count(m_file.tallies.calls);
        else if (std::ranges::find(kIdleStatements, word) == kIdleStatements.end())
            countUnknown(word);
    }

    void count(CaseTally& tally) { tally.add(m_source.name, m_scanner.line()); }
    void countUnknown(std::string_view word) {
        if (m_file.tallies.firstUnknown.empty()) m_file.tallies.firstUnknown = quotedInput(word);
        count(m_file.tallies.unknownStatements);
    }

    // Behind x, y and z may stand a weight, which only curves have, or a colour. Vertices without one are white.
    void readVertex() {
        Vec3d vector(0.0);
        for (int axis = 0; axis < 3; ++axis) {
            const std::string_view word = m_scanner.next();
            const std::optional<double> value = parseNumber(word);
            if (!value || !isCoordinate(*value)) {
                const std::string hint = commaHint(word);
                m_scanner.refuse(fmt::format("{} of vertex {}, {}{}", "xyz"[axis], m_file.positions.size() + 1,
                                             numberFrom(-kFarthestVertex, kFarthestVertex), hint));
                break;
            }
            vector[axis] = *value;
        }
        m_file.positions.push_back(vector);
        std::string_view words[]{m_scanner.next(), m_scanner.next(), m_scanner.next(), m_scanner.next()};
        if (words[1].empty()) return;
        if (!words[3].empty()) std::shift_left(words, words + 4, 1);  // a weight as well
        const std::optional<double> color[]{parseNumber(words[0]), parseNumber(words[1]), parseNumber(words[2])};
        if (!std::ranges::all_of(color, [](const auto& one) { return one && isColor(*one); }))
            return count(m_file.tallies.badColors);
        while (m_file.colors.size() + 1 < m_file.positions.size()) m_file.colors.push_back(Vec3d(1));
        m_file.colors.push_back({*color[0], *color[1], *color[2]});
    }

    void readNormal() {
        Vec3d vector(0.0);
        bool isOne = true;
        for (int axis = 0; axis < 3; ++axis) {
            const std::optional<double> value = parseNumber(m_scanner.next());
            isOne = isOne && value;
            vector[axis] = value.value_or(0);
        }
        const std::optional<Vec3d> unit = isOne ? unitVector(vector) : std::nullopt;
        if (!unit) count(m_file.tallies.badNormals);
        m_file.normals.push_back(unit.value_or(Vec3d(0.0)));
    }

    // v, v/vt, v//vn or v/vt/vn, also with nothing behind a slash. Texture coordinates are not looked at.
    std::optional<ObjCorner> readCorner(std::string_view word) {
        const std::size_t slash = word.find('/');
        const std::optional<std::uint32_t> position = readIndex(word.substr(0, slash), m_file.positions.size());
        if (!position) {
            m_scanner.refuse(indexRange("vertex", m_file.positions.size()));
            return {};
        }
        const std::size_t second = slash == std::string_view::npos ? slash : word.find('/', slash + 1);
        if (second == std::string_view::npos || second + 1 == word.size()) return ObjCorner{*position, kNoNormal};
        const std::optional<std::uint32_t> normal = readIndex(word.substr(second + 1), m_file.normals.size());
        if (!normal) count(m_file.tallies.unknownNormals);
        const bool isOne = normal && m_file.normals[*normal] != Vec3d(0.0);
        return ObjCorner{*position, isOne ? *normal : kNoNormal};
    }

    void readFace() {
        const TextPosition place = m_scanner.place();
        ObjFaces& faces = currentGroup().faces;
        const std::size_t first = faces.positions.size();
        std::size_t written = 0;
        for (std::string_view word = m_scanner.next(); !word.empty(); word = m_scanner.next(), ++written) {
            const std::optional<ObjCorner> corner = readCorner(word);
            if (!corner) {
                faces.dropCorners(first);
                return;
            }
            faces.addCorner(*corner);
        }
        if (written < 3) {
            m_file.tallies.fewCorners.add(m_source.name, place.line);
            faces.dropCorners(first);
            return;
        }
        faces.endFace(place, m_smoothing);
        m_file.smooths = m_file.smooths || m_smoothing > 0;
    }

    ObjGroup& currentGroup() {
        if (m_group == kNoGroup) {
            const auto [found, isNew] =
                m_groupOf.try_emplace({m_object, m_material}, static_cast<std::uint32_t>(m_file.groups.size()));
            if (isNew) m_file.groups.push_back({m_object, m_objectName, m_material, {}});
            m_group = found->second;
        }
        return m_file.groups[m_group];
    }

    void beginObject(std::string_view name) {
        m_objectName = shownName(name, stemOf(m_source.name));
        m_object = ++m_objects;
        m_hasObjects = true;
        m_group = kNoGroup;
    }

    // Where no `o` divides the file its groups do; one that is named again goes on.
    void beginGroup(std::string_view name) {
        if (m_hasObjects) return;
        m_group = kNoGroup;
        const bool isFurther = m_objectOf.size() >= kMostGroups && !m_objectOf.contains(name);
        if (isFurther) count(m_file.tallies.furtherGroups);
        const std::string key(isFurther ? std::string_view() : name);
        const auto [object, isNew] = m_objectOf.try_emplace(key, m_objects + 1);
        if (isNew) ++m_objects;
        m_object = object->second;
        m_objectName = shownName(key, stemOf(m_source.name));
    }

    // "off" and 0 are the same; so is what is no number.
    static std::uint32_t smoothingGroup(std::string_view word) {
        if (word == "on") return 1;
        return static_cast<std::uint32_t>(std::min<std::uint64_t>(parseCount(word).value_or(0), UINT32_MAX));
    }

    const SourceText& m_source;
    ObjMaterials& m_materials;
    ByteWindow m_window;
    LineScanner m_scanner;
    ObjFile m_file;
    std::string m_objectName, m_material;
    std::size_t m_object = 0, m_objects = 0;  // the one that faces go to, and the last
    bool m_hasObjects = false;                // an `o` was met
    std::uint32_t m_smoothing = 0;
    std::uint32_t m_group = kNoGroup;  // of the next face, once it is known
    std::map<std::pair<std::size_t, std::string>, std::uint32_t, std::less<>> m_groupOf;
    std::map<std::string, std::size_t, std::less<>> m_objectOf;  // by name of a group
};

}  // namespace

bool ObjFaces::haveNormals() const {
    return numbers != NormalNumbers::None && std::ranges::find(normals, kNoNormal) == normals.end();
}

std::uint32_t ObjFaces::normal(std::size_t corner) const {
    if (numbers == NormalNumbers::Own) return normals[corner];
    return numbers == NormalNumbers::AsPositions ? positions[corner] : kNoNormal;
}

void ObjFaces::addCorner(const ObjCorner& corner) {
    const NormalNumbers its = corner.normal == kNoNormal         ? NormalNumbers::None
                              : corner.normal == corner.position ? NormalNumbers::AsPositions
                                                                 : NormalNumbers::Own;
    if (positions.empty()) numbers = its;
    if (its != numbers && numbers != NormalNumbers::Own) {
        normals.assign(positions.size(), kNoNormal);
        if (numbers == NormalNumbers::AsPositions) normals = positions;
        numbers = NormalNumbers::Own;
    }
    positions.push_back(corner.position);
    if (numbers == NormalNumbers::Own) normals.push_back(corner.normal);
}

void ObjFaces::dropCorners(std::size_t first) {
    positions.resize(first);
    normals.resize(std::min(first, normals.size()));
}

void ObjFaces::endFace(const TextPosition& place, std::uint32_t smoothingGroup) {
    const std::uint32_t before = smoothing.empty() ? 0 : smoothing.back().second;
    if (smoothingGroup != before) smoothing.emplace_back(static_cast<std::uint32_t>(count()), smoothingGroup);
    firstCorner.push_back(static_cast<std::uint32_t>(positions.size()));
    places.push_back(place);
}

ObjFile parseObj(const SourceText& source, ObjMaterials& materials, Errors& errors) {
    return ObjParser(source, materials, errors).read();
}

}  // namespace pipeline
