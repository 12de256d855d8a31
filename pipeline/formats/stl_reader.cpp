#include <array>
#include <unordered_map>

#include <fmt/format.h>

#include "pipeline/core/text.h"
#include "pipeline/formats/bytes.h"
#include "pipeline/formats/lecture_values.h"
#include "pipeline/formats/line_scanner.h"
#include "pipeline/formats/model_formats.h"

// STL in both forms (3D Systems, StereoLithography Interface Specification, 1989). The normals of
// the facets are not read: they say nothing that the corners' order does not say. Keywords are
// small letters there; some programs write capitals.
namespace pipeline {
namespace {

constexpr std::size_t kHeader = 80, kFirstFacet = 84, kFacet = 50;  // bytes

struct PositionHash {
    std::size_t operator()(const std::array<double, 3>& p) const {
        std::size_t hash = 0;
        for (const double x : p) hash = (hash ^ std::hash<double>{}(x)) * 0x9E3779B97F4A7C15u;
        return hash ^ hash >> 32;
    }
};

// Every facet of an STL file brings its own corners. Equal ones become one vertex, so that the
// mesh of a closed surface is closed.
class WeldedMesh {
public:
    std::uint32_t vertex(const std::array<double, 3>& p) {
        // Adding 0 makes -0 the same as 0.
        const std::array<double, 3> key{p[0] + 0.0, p[1] + 0.0, p[2] + 0.0};
        const auto [found, isNew] = m_vertexOf.try_emplace(key, static_cast<std::uint32_t>(m_mesh.positions.size()));
        if (isNew) m_mesh.positions.emplace_back(key[0], key[1], key[2]);
        return found->second;
    }
    Mesh& mesh() { return m_mesh; }

private:
    Mesh m_mesh;
    std::unordered_map<std::array<double, 3>, std::uint32_t, PositionHash> m_vertexOf;
};

void addObject(WeldedMesh& welded, const SourceText& source, std::string name, std::vector<Object>& objects) {
    dropUnusedVertices(welded.mesh());
    welded.mesh().file = meshFileOf(source);
    if (welded.mesh().polygonCount() > 0) {
        Object& object = objects.emplace_back();
        object.name = std::move(name);
        object.mesh = makeMesh(std::move(welded.mesh()));
    }
    welded = {};
}

Result<LoadedModel> readBinary(const SourceText& source) {
    ByteWindow bytes(source);
    if (bytes.size() < kFirstFacet)
        return Error{{source.name, 0, 0},
                     fmt::format("the file ends after {} bytes", bytes.size()),
                     "an STL file: \"solid\", or 84 bytes before the first facet"};
    const std::size_t count = numberAt<std::uint32_t>(source.text, kHeader);
    if (count > (bytes.size() - kFirstFacet) / kFacet)
        return Error{{source.name, 0, 0},
                     fmt::format("{} facets announced, the file ends after {} bytes", groupedDigits(count),
                                 groupedDigits(bytes.size())),
                     {}};
    Errors errors;
    WeldedMesh welded;
    ReadMeter meter(bytes.size(), source.name, source.progress);
    std::size_t leftOut = 0;
    for (std::size_t i = 0; i < count && errors.size() < kMaxErrors; ++i) {
        const std::size_t facet = kFirstFacet + i * kFacet;
        if (!meter.goesOn(i * kFacet, errors)) break;
        if (!bytes.has(facet, kFacet))
            return Error{{source.name, 0, 0}, fmt::format("the file ends after {} bytes", groupedDigits(bytes.size()))};
        std::array<std::uint32_t, 3> corners{};
        for (std::size_t k = 0; k < 3; ++k) {
            std::array<double, 3> p{};
            for (std::size_t axis = 0; axis < 3; ++axis) {
                // The facet's normal comes first, 12 bytes.
                const std::size_t at = facet + 12 + k * 12 + axis * 4;
                p[axis] = numberAt<float>(bytes.view(), at - bytes.begin());
                if (isCoordinate(p[axis])) continue;
                errors.push_back({{source.name, 0, 0},
                                  fmt::format("facet {}, corner {}: {} is {} at byte {}", i, k, "xyz"[axis],
                                              shortestText(p[axis]), groupedDigits(at)),
                                  numberFrom(-kFarthestVertex, kFarthestVertex)});
                p[axis] = 0;
                if (errors.size() == kMaxErrors) return errors;
            }
            corners[k] = welded.vertex(p);
        }
        if (!addPolygon(welded.mesh(), corners)) ++leftOut;
    }
    meter.goesOn(bytes.size(), errors);
    if (!errors.empty()) return errors;
    LoadedModel model;
    remarkOnLeftOut(leftOut, source.name, model.remarks);
    if (const std::size_t rest = bytes.size() - kFirstFacet - count * kFacet; rest > 0)
        model.remarks.push_back(
            {source.name, fmt::format("The last {} after the last of {} facet{} {} not read.",
                                      rest == 1 ? "byte" : groupedDigits(rest) + " bytes", groupedDigits(count),
                                      count == 1 ? "" : "s", rest == 1 ? "is" : "are")});
    addObject(welded, source, stemOf(source.name), model.objects);
    return model;
}

std::optional<std::uint32_t> readVertex(LineScanner& scanner, WeldedMesh& welded) {
    std::array<double, 3> p{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::optional<double> value = parseNumber(scanner.next());
        if (!value || !isCoordinate(*value)) {
            scanner.refuse(
                fmt::format("{} of a vertex, {}", "xyz"[axis], numberFrom(-kFarthestVertex, kFarthestVertex)));
            return {};
        }
        p[axis] = *value;
    }
    return welded.vertex(p);
}

Result<LoadedModel> readText(const SourceText& source) {
    Errors errors;
    ByteWindow window(source);
    LineScanner scanner(window, source.name, errors, source.progress);
    LoadedModel model;
    std::string name = stemOf(source.name);
    WeldedMesh welded;
    std::vector<std::uint32_t> corners;
    TextPosition place;
    bool ended = false;
    std::size_t leftOut = 0;
    while (scanner.nextLine()) {
        const std::string_view word = scanner.next();
        if (word.empty()) continue;
        const auto is = [&](std::string_view keyword) { return sameLetters(word, keyword); };
        ended = is("endsolid");
        if (is("solid")) {
            name = shownName(scanner.rest(), stemOf(source.name));
        } else if (is("facet")) {
            place = scanner.place();
        } else if (is("outer")) {
            corners.clear();
        } else if (is("vertex")) {
            if (const std::optional<std::uint32_t> vertex = readVertex(scanner, welded)) corners.push_back(*vertex);
        } else if (is("endloop")) {
            if (corners.size() < 3 && errors.empty()) scanner.fail("a loop of fewer than three vertices", "three");
            if (place.line == 0) place = scanner.place();  // no facet so far: every polygon has a place, or none
            if (!addPolygon(welded.mesh(), corners, place)) ++leftOut;
            corners.clear();
        } else if (ended) {
            addObject(welded, source, name, model.objects);
            corners.clear();  // vertices of the object that is over
        } else if (!is("endfacet")) {
            scanner.refuse("solid, facet, outer loop, vertex, endloop, endfacet or endsolid");
        }
    }
    if (!ended && errors.empty()) scanner.fail("found the end of the file", "endsolid");
    if (!errors.empty()) return errors;
    remarkOnLeftOut(leftOut, source.name, model.remarks);
    return model;
}

// Some programs begin a binary file with "solid" as well; its size gives it away.
bool isBinary(const SourceText& source) {
    const std::string_view bytes = source.text;
    const std::size_t size = ByteWindow(source).size();
    const bool hasSize = size >= kFirstFacet &&
                         (size - kFirstFacet) / kFacet == numberAt<std::uint32_t>(bytes, kHeader) &&
                         (size - kFirstFacet) % kFacet == 0;
    Errors none;
    LineScanner scanner(bytes, {}, none);
    std::string_view word;
    while (word.empty() && scanner.nextLine()) word = scanner.next();
    return hasSize || !sameLetters(word, "solid") || bytes.substr(0, 512).find('\0') != std::string_view::npos;
}

}  // namespace

Result<LoadedModel> readStl(const SourceText& source, const FileLoader&) {
    return isBinary(source) ? readBinary(source) : readText(source);
}

}  // namespace pipeline
