#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "pipeline/core/memory.h"
#include "pipeline/core/text.h"
#include "pipeline/formats/lecture/lecture_values.h"
#include "pipeline/formats/model_formats.h"
#include "pipeline/formats/text/bytes.h"
#include "pipeline/formats/text/line_scanner.h"
#include "pipeline/formats/welded_vertices.h"

// STL in both forms (3D Systems, StereoLithography Interface Specification, 1989). The normals of
// the facets are not read: they say nothing that the corners' order does not say. Keywords are
// small letters there; some programs write capitals.
namespace pipeline {
namespace {

constexpr std::string_view kSpaces = " \t\v\f";
constexpr std::size_t kHeader = 80, kFirstFacet = 84, kFacet = 50;  // bytes

Result<LoadedModel> readBinary(const SourceText& source) {
    ByteWindow bytes(source);
    if (bytes.size() < kFirstFacet)
        return Error{{source.name, 0, 0},
                     fmt::format("the file ends after {} bytes", bytes.size()),
                     "an STL file: \"solid\", or 84 bytes before the first facet"};
    const std::size_t announced = numberAt<std::uint32_t>(source.text, kHeader);
    const std::size_t fitting = (bytes.size() - kFirstFacet) / kFacet;
    // Some programs never fill the count in.
    const std::size_t count = announced == 0 ? fitting : announced;
    if (count > fitting)
        return Error{{source.name, 0, 0},
                     fmt::format("{} facets announced, the file ends after {} bytes", groupedDigits(count),
                                 groupedDigits(bytes.size())),
                     {}};
    Errors errors;
    Mesh mesh;
    mesh.reservePolygons(count, 3 * count);
    WeldedVertices vertices(mesh, false);
    vertices.reserve(count / 2 + 2);  // of a closed surface by Euler's formula; others grow
    ReadMeter meter(bytes.size(), source.name, source.progress);
    std::size_t leftOut = 0, attributes = 0;
    for (std::size_t i = 0; i < count && errors.size() < kMaxErrors; ++i) {
        const std::size_t facet = kFirstFacet + i * kFacet;
        if (!meter.goesOn(i * kFacet, errors)) break;
        if (!bytes.has(facet, kFacet))
            return Error{{source.name, 0, 0}, fmt::format("the file ends after {} bytes", groupedDigits(bytes.size()))};
        std::array<std::uint32_t, 3> corners{};
        for (std::size_t k = 0; k < 3; ++k) {
            Vec3d p(0.0);
            for (int axis = 0; axis < 3; ++axis) {
                // The facet's normal comes first, 12 bytes.
                const std::size_t at = facet + 12 + k * 12 + std::size_t(axis) * 4;
                p[axis] = numberAt<float>(bytes.view(), at - bytes.begin());
                if (isCoordinate(p[axis])) continue;
                errors.push_back({{source.name, 0, 0},
                                  fmt::format("facet {}, corner {}: {} is {} at byte {}", i, k, "xyz"[axis],
                                              shortestText(p[axis]), groupedDigits(at)),
                                  numberFrom(-kFarthestVertex, kFarthestVertex)});
                p[axis] = 0;
                if (errors.size() == kMaxErrors) return errors;
            }
            corners[k] = vertices.at(p);
        }
        if (!addPolygon(mesh, corners)) ++leftOut;
        if (numberAt<std::uint16_t>(bytes.view(), facet + kFacet - 2 - bytes.begin()) != 0) ++attributes;
    }
    meter.goesOn(bytes.size(), errors);
    if (!errors.empty()) return errors;
    LoadedModel model;
    if (announced == 0 && count > 0)
        model.remarks.push_back(
            {source.name, fmt::format("The file announces 0 facets; as many are read as its size has room for: {}.",
                                      groupedDigits(count))});
    if (attributes > 0)
        model.remarks.push_back(
            {source.name,
             fmt::format("The attributes of {} facet{}, in which some programs write a colour, are not read.",
                         groupedDigits(attributes), attributes == 1 ? "" : "s")});
    remarkOnLeftOut(leftOut, source.name, model.remarks);
    if (const std::size_t rest = bytes.size() - kFirstFacet - count * kFacet; rest > 0)
        model.remarks.push_back(
            {source.name, fmt::format("The last {} after the last of {} facet{} {} not read.",
                                      rest == 1 ? "byte" : groupedDigits(rest) + " bytes", groupedDigits(count),
                                      count == 1 ? "" : "s", rest == 1 ? "is" : "are")});
    vertices.clear(), giveBackFreedMemory();
    addObject(std::move(mesh), source, stemOf(source.name), model);
    return model;
}

// The words of a text one after the other, whatever lines they stand on: false at the end.
bool nextWord(LineScanner& scanner, std::string_view& word) {
    do word = scanner.next();
    while (word.empty() && scanner.nextLine());
    return !word.empty();
}

std::optional<std::uint32_t> readVertex(LineScanner& scanner, WeldedVertices& vertices) {
    Vec3d p(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        std::string_view word;
        const bool atEnd = !nextWord(scanner, word);
        const std::optional<double> value = parseNumber(word);
        if (!value || !isCoordinate(*value)) {
            std::string expected =
                fmt::format("{} of a vertex, {}", "xyz"[axis], numberFrom(-kFarthestVertex, kFarthestVertex));
            atEnd ? scanner.fail("found the end of the file", expected) : scanner.refuse(expected);
            return {};
        }
        p[axis] = *value;
    }
    return vertices.at(p);
}

std::string_view wordAt(std::string_view text, std::size_t begin) {
    return text.substr(begin, std::min(text.find_first_of(kSpaces, begin), text.size()) - begin);
}

// Reads the name behind solid or endsolid. It ends with its line, but for a facet with its normal, or the solid of one,
// that stands on the same line: a name may hold spaces, and one of the words alone.
std::string_view readName(LineScanner& scanner, bool ofEnd) {
    const std::string_view rest = scanner.rest();
    std::size_t solid = rest.npos;
    for (std::size_t i = 0; (i = rest.find_first_not_of(kSpaces, i)) != rest.npos;) {
        const std::string_view word = wordAt(rest, i);
        const std::size_t next = rest.find_first_not_of(kSpaces, i + word.size());
        if (ofEnd && sameLetters(word, "solid")) solid = i;
        if (next != rest.npos && sameLetters(word, "facet") && sameLetters(wordAt(rest, next), "normal")) {
            const std::size_t end = std::min(solid, i);
            scanner.goBackTo(rest.substr(end));
            const std::string_view name = rest.substr(0, end);
            return name.substr(0, name.find_last_not_of(kSpaces) + 1);
        }
        i += word.size();
    }
    return rest;
}

// What a word begins: "end loop", in two words as some programs write it, is endloop.
std::string_view keywordAt(LineScanner& scanner, std::string_view word) {
    if (!sameLetters(word, "end")) return word;
    for (const std::string_view whole : {"endsolid", "endfacet", "endloop"})
        if (sameLetters(scanner.peek(), whole.substr(3))) {
            scanner.next();
            return whole;
        }
    return word;
}

Result<LoadedModel> readText(const SourceText& source) {
    Errors errors;
    ByteWindow window(source);
    LineScanner scanner(window, source.name, errors, source.progress);
    LoadedModel model;
    std::string name = stemOf(source.name);
    Mesh mesh;
    WeldedVertices vertices(mesh, false);
    std::vector<std::uint32_t> corners;
    TextPosition place;
    bool ended = false;
    int ofNormal = 0;  // words that may still come, "normal" and its numbers: none of them is read
    std::size_t leftOut = 0, facets = 0, loops = 0, open = 0;
    int firstOpen = 0;  // line
    // Adds the polygon of the vertices since the last one. A loop without its end has them all the same.
    const auto finishLoop = [&](bool isEnded) {
        if (!isEnded && corners.empty()) return;
        if (corners.size() < 3 && errors.empty()) scanner.fail("a loop of fewer than three vertices", "three");
        if (place.line == 0) place = scanner.place();  // no facet so far: every polygon has a place, or none
        if (!isEnded && open++ == 0) firstOpen = place.line;
        ++loops;
        if (!addPolygon(mesh, corners, place)) ++leftOut;
        corners.clear();
    };
    for (std::string_view word; nextWord(scanner, word);) {
        if (word[0] < 'A' && --ofNormal >= 0)
            continue;  // a number: compared with every keyword it took as long as read
        const std::string_view keyword = keywordAt(scanner, word);
        const auto is = [&](std::string_view other) { return sameLetters(keyword, other); };
        ended = false;
        if (is("vertex")) {
            if (const std::optional<std::uint32_t> vertex = readVertex(scanner, vertices))
                corners.push_back(*vertex);
            else
                scanner.rest();  // one error for a line
        } else if (is("endloop")) {
            finishLoop(true);
        } else if (is("facet")) {
            finishLoop(false);
            ++facets;
            place = scanner.place();
            ofNormal = 4;
        } else if (is("outer")) {
            finishLoop(false);
            ofNormal = 0;
        } else if (is("endfacet")) {
            finishLoop(false);
        } else if (is("solid")) {
            finishLoop(false);
            name = shownName(readName(scanner, false), stemOf(source.name));
        } else if (is("endsolid")) {
            finishLoop(false);
            readName(scanner, true);
            vertices.clear();
            addObject(std::exchange(mesh, {}), source, name, model);
            ended = true;
        } else if (!is("loop") && --ofNormal < 0) {
            scanner.refuse("solid, facet, outer loop, vertex, endloop, endfacet or endsolid");
            scanner.rest();
        }
    }
    if (!ended && errors.empty()) scanner.fail("found the end of the file", "endsolid");
    if (!errors.empty()) return errors;
    if (open > 0)
        model.remarks.push_back(
            {source.name, fmt::format("{} without endloop, the first at line {}; {} read all the same.",
                                      open == 1 ? "1 facet is" : groupedDigits(open) + " facets are", firstOpen,
                                      open == 1 ? "it is" : "they are")});
    if (facets > loops)
        model.remarks.push_back(
            {source.name,
             fmt::format("{} without vertices; nothing of {} is drawn.",
                         facets - loops == 1 ? "1 facet is" : groupedDigits(facets - loops) + " facets are",
                         facets - loops == 1 ? "it" : "them")});
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
