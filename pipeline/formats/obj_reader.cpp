#include <algorithm>
#include <deque>
#include <filesystem>
#include <map>
#include <unordered_map>

#include <fmt/format.h>

#include "pipeline/core/memory.h"
#include "pipeline/formats/lecture_values.h"
#include "pipeline/formats/line_scanner.h"
#include "pipeline/formats/model_formats.h"
#include "pipeline/formats/model_reader.h"

// Wavefront OBJ as its manual describes polygons (Object Files, 1995, appendix B1). Curves,
// surfaces, points, lines, groups, smoothing groups and texture coordinates are skipped.
//
// An own reader: the packaged tinyobjloader takes "nan" and words for 0, lets infinity through, and
// wraps indices beyond 2^31 around, so that every line had to be checked before it in any case.
namespace pipeline {
namespace {

constexpr std::uint32_t kNone = UINT32_MAX;

struct Corner {
    std::uint32_t position, normal;
};

// How the normals of a group's corners are numbered. Most files give none, or a normal with every position.
enum class NormalNumbers : std::uint8_t { None, AsPositions, Own };

// Nobody knows how many there will be, and a vector that grows by copying holds up to three times what is in it.
struct Faces {
    std::deque<std::uint32_t> positions;  // per corner
    NormalNumbers numbers = NormalNumbers::None;
    std::deque<std::uint32_t> normals;  // per corner, of numbers Own; kNone where one has none
    std::deque<std::uint32_t> firstCorner{0};
    std::deque<TextPosition> places;

    std::size_t count() const { return places.size(); }
    bool haveNormals() const {
        return numbers != NormalNumbers::None && std::ranges::find(normals, kNone) == normals.end();
    }
    Corner corner(std::size_t i) const {
        if (numbers == NormalNumbers::Own) return {positions[i], normals[i]};
        return {positions[i], numbers == NormalNumbers::AsPositions ? positions[i] : kNone};
    }
    void addCorner(const Corner& corner) {
        const NormalNumbers its = corner.normal == kNone             ? NormalNumbers::None
                                  : corner.normal == corner.position ? NormalNumbers::AsPositions
                                                                     : NormalNumbers::Own;
        if (positions.empty()) numbers = its;
        if (its != numbers && numbers != NormalNumbers::Own) {
            normals.assign(positions.size(), kNone);
            if (numbers == NormalNumbers::AsPositions) normals = positions;
            numbers = NormalNumbers::Own;
        }
        positions.push_back(corner.position);
        if (numbers == NormalNumbers::Own) normals.push_back(corner.normal);
    }
    void dropCorners(std::size_t first) {
        positions.resize(first);
        normals.resize(std::min(first, normals.size()));
    }
};

// Faces of one `o` with one material.
struct Group {
    std::size_t object = 0;  // counts the `o` lines
    std::string name, material;
    Faces faces;
};

struct ObjFile {
    VertexVectors positions, normals;  // a normal without length is (0, 0, 0)
    std::vector<NamedMaterial> materials;
    std::map<std::string, std::size_t, std::less<>> materialOf;  // by name
    std::vector<Group> groups;
};

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

class ObjReader {
public:
    ObjReader(const SourceText& source, const FileLoader& load, Errors& errors)
        : m_source(source),
          m_load(load),
          m_errors(errors),
          m_window(source),
          m_scanner(m_window, source.name, errors, source.progress) {
        m_objectName = stemOf(source.name);
    }

    ObjFile read() {
        while (m_scanner.nextLine()) {
            const std::string_view word = m_scanner.next();
            if (word == "v")
                m_file.positions.push_back(readVector("vertex", m_file.positions.size() + 1));
            else if (word == "vn")
                readNormal();
            else if (word == "f" || word == "fo")
                readFace();
            else if (word == "o")
                beginObject(m_scanner.rest());
            else if (word == "usemtl")
                useMaterial(m_scanner.rest());
            else if (word == "mtllib")
                loadMaterials(m_scanner.rest());
        }
        return std::move(m_file);
    }

private:
    // The one that gets this number; with what is right of it, where the file is refused.
    Vec3d readVector(std::string_view what, std::size_t number) {
        Vec3d vector(0.0);
        for (int axis = 0; axis < 3; ++axis) {
            const std::optional<double> value = parseNumber(m_scanner.next());
            if (!value || !isCoordinate(*value)) {
                m_scanner.refuse(fmt::format("{} of {} {}, {}", "xyz"[axis], what, number,
                                             numberFrom(-kFarthestVertex, kFarthestVertex)));
                break;
            }
            vector[axis] = *value;
        }
        return vector;
    }

    void readNormal() {
        const Vec3d normal = readVector("normal", m_file.normals.size() + 1);
        m_file.normals.push_back(unitVector(normal).value_or(Vec3d(0.0)));
    }

    // v, v/vt, v//vn or v/vt/vn. Texture coordinates are not looked at.
    std::optional<Corner> readCorner(std::string_view word) {
        const std::size_t slash = word.find('/');
        const std::optional<std::uint32_t> position = readIndex(word.substr(0, slash), m_file.positions.size());
        if (!position) {
            m_scanner.refuse(indexRange("vertex", m_file.positions.size()));
            return {};
        }
        const std::size_t second = slash == std::string_view::npos ? slash : word.find('/', slash + 1);
        if (second == std::string_view::npos) return Corner{*position, kNone};
        const std::optional<std::uint32_t> normal = readIndex(word.substr(second + 1), m_file.normals.size());
        if (!normal) {
            m_scanner.refuse(fmt::format("after the second slash {}", indexRange("normal", m_file.normals.size())));
            return {};
        }
        return Corner{*position, m_file.normals[*normal] == Vec3d(0.0) ? kNone : *normal};
    }

    void readFace() {
        const TextPosition place = m_scanner.place();
        Faces& faces = currentGroup().faces;
        const std::size_t first = faces.positions.size();
        std::size_t written = 0;
        for (std::string_view word = m_scanner.next(); !word.empty(); word = m_scanner.next(), ++written) {
            const std::optional<Corner> corner = readCorner(word);
            if (!corner) {
                faces.dropCorners(first);
                return;
            }
            faces.addCorner(*corner);
        }
        if (written < 3) {
            m_scanner.refuse("at least three corners in a face");
            faces.dropCorners(first);
            return;
        }
        faces.firstCorner.push_back(static_cast<std::uint32_t>(faces.positions.size()));
        faces.places.push_back(place);
    }

    Group& currentGroup() {
        if (m_group == kNone) {
            const auto [found, isNew] =
                m_groupOf.try_emplace({m_object, m_material}, static_cast<std::uint32_t>(m_file.groups.size()));
            if (isNew) m_file.groups.push_back({m_object, m_objectName, m_material, {}});
            m_group = found->second;
        }
        return m_file.groups[m_group];
    }

    void beginObject(std::string_view name) {
        m_objectName = shownName(name, stemOf(m_source.name));
        ++m_object;
        m_group = kNone;
    }

    void useMaterial(std::string_view name) {
        // Without a library the names mean nothing, and the model is still a model.
        if (!m_file.materials.empty() && !m_file.materialOf.contains(name))
            m_scanner.refuse("the name of a material of the mtllib files");
        m_material = name;
        m_group = kNone;
    }

    // One name with spaces, or several names without.
    void loadMaterials(std::string_view names) {
        if (names.empty()) return m_scanner.refuse("the name of a material file");
        const Errors failed = loadMaterialFile(names);
        if (failed.empty()) return;
        if (names.find_first_of(" \t") == std::string_view::npos)
            return m_scanner.fail(failed[0].found, failed[0].expected);
        LineScanner words(names, {}, m_errors);
        words.nextLine();
        for (std::string_view name = words.next(); !name.empty(); name = words.next()) {
            const Errors missing = loadMaterialFile(name);
            if (!missing.empty()) return m_scanner.fail(missing[0].found, missing[0].expected);
        }
    }

    // Why the file cannot be loaded; nothing where it can.
    Errors loadMaterialFile(std::string_view name) {
        const std::string extension = std::filesystem::path(name).extension().string();
        if (isModel(extension))
            return {Error{{}, quotedInput(name) + " is a model", "a file of materials, as in x.mtl"}};
        const Result<NamedFile> file = m_load(name);
        if (!file) return file.errors();
        const std::size_t known = m_file.materials.size();
        readMtl({file->text, file->path, m_source.progress, file->tail}, m_file.materials, m_errors);
        for (std::size_t i = known; i < m_file.materials.size(); ++i)
            m_file.materialOf.try_emplace(m_file.materials[i].name, i);
        return {};
    }

    const SourceText& m_source;
    const FileLoader& m_load;
    Errors& m_errors;
    ByteWindow m_window;
    LineScanner m_scanner;
    ObjFile m_file;
    std::string m_objectName, m_material;
    std::size_t m_object = 0;
    std::uint32_t m_group = kNone;  // of the next face, once it is known
    std::map<std::pair<std::size_t, std::string>, std::uint32_t, std::less<>> m_groupOf;
};

// Numbers the vertices of the groups of a file. A position with one normal is one vertex; with another normal it is another
// one.
class VertexMaker {
public:
    explicit VertexMaker(const ObjFile& file) : m_file(file), m_first(file.positions.size(), kNone) {}

    // A mesh of a group's vertices alone; the positions of its corners become their numbers.
    Mesh verticesOf(Faces& faces) {
        const bool hasNormals = faces.haveNormals();
        m_corners.clear(), m_others.clear();
        m_corners.reserve(std::min(m_first.size(), faces.positions.size()));
        std::size_t i = 0;
        for (std::uint32_t& position : faces.positions)
            position = vertex(hasNormals ? faces.corner(i++) : Corner{position, kNone});
        faces.normals.clear();
        Mesh mesh;
        mesh.positions.reserve(m_corners.size());
        if (hasNormals) mesh.normals.reserve(m_corners.size());
        for (const Corner& corner : m_corners) {
            mesh.positions.push_back(m_file.positions[corner.position]);
            if (hasNormals) mesh.normals.push_back(m_file.normals[corner.normal]);
            m_first[corner.position] = kNone;
        }
        return mesh;
    }

private:
    std::uint32_t vertex(const Corner& corner) {
        const auto next = static_cast<std::uint32_t>(m_corners.size());
        std::uint32_t& first = m_first[corner.position];
        if (first == kNone) {
            first = next;
        } else {
            if (m_corners[first].normal == corner.normal) return first;
            const std::uint64_t key = std::uint64_t{corner.position} << 32 | corner.normal;
            if (const auto [other, isNew] = m_others.try_emplace(key, next); !isNew) return other->second;
        }
        m_corners.push_back(corner);
        return next;
    }

    const ObjFile& m_file;
    std::vector<std::uint32_t> m_first;                         // vertex of a position, or kNone
    std::unordered_map<std::uint64_t, std::uint32_t> m_others;  // by position and normal, where it has several
    std::vector<Corner> m_corners;                              // per vertex
};

// faces: the vertex of each corner stands where its position stood. The number of polygons that were left out.
std::size_t addPolygons(Faces faces, Mesh& mesh) {
    mesh.reservePolygons(faces.count(), faces.positions.size());
    mesh.polygonPlaces.reserve(faces.count());
    std::vector<std::uint32_t> corners;
    auto from = faces.positions.cbegin();
    auto first = faces.firstCorner.cbegin();
    for (const TextPosition& place : faces.places) {
        const auto to = from + (first[1] - first[0]);
        corners.assign(from, to);
        if (addPolygon(mesh, corners)) mesh.polygonPlaces.push_back(place);
        from = to, ++first;
    }
    return faces.count() - mesh.polygonPlaces.size();
}

// Of each group. What the file gives and what becomes of it are twice the meshes at most: the polygons are made when its
// positions and normals are gone.
std::vector<Mesh> meshesOf(ObjFile& file, std::size_t& leftOut) {
    file.positions.shrink_to_fit(), file.normals.shrink_to_fit();
    giveBackFreedMemory();
    std::vector<Mesh> meshes;
    {
        VertexMaker maker(file);
        for (Group& group : file.groups) meshes.push_back(maker.verticesOf(group.faces));
    }
    file.positions.clear(), file.normals.clear();
    giveBackFreedMemory();
    for (std::size_t i = 0; i < meshes.size(); ++i) leftOut += addPolygons(std::move(file.groups[i].faces), meshes[i]);
    giveBackFreedMemory();
    return meshes;
}

}  // namespace

Result<LoadedModel> readObj(const SourceText& source, const FileLoader& load) {
    Errors errors;
    ObjFile file = ObjReader(source, load, errors).read();
    if (!errors.empty()) return errors;
    std::map<std::size_t, int> groupsOf;
    for (const Group& group : file.groups) ++groupsOf[group.object];
    std::size_t leftOut = 0;
    std::vector<Mesh> meshes = meshesOf(file, leftOut);
    LoadedModel model;
    remarkOnLeftOut(leftOut, source.name, model.remarks);
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        const Group& group = file.groups[i];
        if (meshes[i].polygonCount() == 0) continue;
        meshes[i].file = meshFileOf(source);
        Object& object = model.objects.emplace_back();
        object.name = group.name;
        if (groupsOf[group.object] > 1) object.name += ", " + shownName(group.material, "no material");
        object.mesh = makeMesh(std::move(meshes[i]));
        const auto material = file.materialOf.find(group.material);
        if (material != file.materialOf.end()) object.material = file.materials[material->second].material;
    }
    return model;
}

}  // namespace pipeline
