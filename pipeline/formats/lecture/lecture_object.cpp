#include <algorithm>
#include <filesystem>

#include "pipeline/formats/lecture/lecture_formats.h"
#include "pipeline/formats/lecture/lecture_values.h"
#include "pipeline/scene/framing.h"
#include "pipeline/scene/mesh/make_mesh.h"

namespace pipeline {
namespace {

constexpr std::size_t kMaxPolygonVertices = std::size_t{1} << 20;
constexpr Countable kVertices{"vertex", "vertices", 3, kMaxVertices, 3};
constexpr Countable kPolygons{"polygon", "polygons", 1, kMaxTriangles, 4};
constexpr Countable kCorners{"vertex", "vertices", 3, kMaxPolygonVertices, 1};

// In the order of the file.
constexpr std::string_view kMaterialKeys[] = {"material.#.kr", "material.#.kg", "material.#.kb", "material.#.ks",
                                              "material.#.n"};

// The scanner of a long list, which may be given up.
struct LongList {
    TextScanner& scanner;
    ReadMeter meter;
    Errors& errors;
    bool good() { return scanner.good() && meter.goesOn(scanner.size() - scanner.bytesLeft(), errors); }
};

void readVertices(LongList& list, std::size_t count, Mesh& mesh) {
    TextScanner& scanner = list.scanner;
    const Setting& place = settingRow("object.#.tx");  // a vertex may be as far away as an object
    for (std::size_t i = 0; i < count && list.good(); ++i) {
        Vec3d position(0.0);
        for (int axis = 0; axis < 3; ++axis) {
            const std::optional<double> value = parseNumber(scanner.next());
            if (value && *value >= place.min && *value <= place.max)
                position[axis] = *value;
            else
                scanner.refuse(std::string(1, "xyz"[axis]) + " of vertex " + std::to_string(i) + ", " +
                               numberFrom(place.min, place.max));
        }
        mesh.positions.push_back(position);
    }
}

void readPolygon(LongList& list, std::size_t cornerCount, Mesh& mesh) {
    TextScanner& scanner = list.scanner;
    std::vector<std::uint32_t> polygon;
    for (std::size_t k = 0; k < cornerCount && list.good(); ++k) {
        const std::optional<std::uint64_t> index = parseCount(scanner.next());
        const bool known = index && *index < mesh.positions.size();
        const std::uint32_t corner = known ? static_cast<std::uint32_t>(*index) : UINT32_MAX;
        if (!known)
            scanner.refuse("a vertex index from 0 to " + std::to_string(mesh.positions.size() - 1));
        else if (k > 0 && corner == polygon.back())
            scanner.refuse("a vertex other than the one before");
        else if (k > 0 && k + 1 == cornerCount && corner == polygon[0])
            scanner.refuse("a vertex other than the polygon's first: a polygon closes by itself");
        polygon.push_back(corner);
    }
    mesh.addPolygon(polygon);
}

// False when the rest of the file cannot be made sense of.
bool readPolygons(LongList& list, std::size_t count, Mesh& mesh) {
    TextScanner& scanner = list.scanner;
    for (std::size_t i = 0; i < count && list.good(); ++i) {
        const std::optional<std::size_t> corners = readCount(scanner, kCorners, i);
        if (!corners) return false;
        mesh.polygonPlaces.push_back(scanner.place());
        readPolygon(list, *corners, mesh);
    }
    return list.good();
}

}  // namespace

ObjectDescription readObjectDescription(const SourceText& source, Errors& errors) {
    TextScanner scanner(source.text, source.name, errors);
    ObjectDescription description;
    const std::optional<std::size_t> vertices = readCount(scanner, kVertices);
    if (!vertices || *vertices < kVertices.least) return description;
    const std::optional<std::size_t> polygons = readCount(scanner, kPolygons);
    if (!polygons) return description;
    LongList list{scanner, {source.text.size(), source.name, source.progress}, errors};
    readVertices(list, *vertices, description.mesh);
    if (!readPolygons(list, *polygons, description.mesh)) return description;

    Scene scratch;  // settings belong to scenes
    scratch.objects.emplace_back();
    readSettings(scanner, kMaterialKeys, scratch);
    description.material = scratch.objects[0].material;
    description.material.ambient = description.material.diffuse;  // one coefficient for both in lecture 1
    expectEnd(scanner);
    return description;
}

Result<Scene> readLectureObject(const SourceText& source, const FileLoader&) {
    Errors errors;
    ObjectDescription description = readObjectDescription(source, errors);
    if (!errors.empty()) return errors;
    const std::filesystem::path file(source.name);
    Mesh& mesh = description.mesh;
    mesh.file = file.filename().string();

    Scene scene;
    Object& object = scene.objects.emplace_back();
    object.name = printableText(file.stem().string());
    object.mesh = makeMesh(std::move(mesh), source.progress.stop);
    object.material = description.material;
    frameModel(scene);
    return scene;
}

bool looksLikeLectureObject(std::string_view start) {
    const std::vector<std::string_view> words = firstWords(start, 6);
    return words.size() >= 2 && parseCount(words[0]) && parseCount(words[1]) &&
           std::all_of(words.begin(), words.end(), parseNumber);
}

}  // namespace pipeline
