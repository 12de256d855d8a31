#include <algorithm>
#include <iterator>
#include <map>
#include <unordered_map>

#include <fmt/format.h>

#include "pipeline/core/memory.h"
#include "pipeline/core/text.h"
#include "pipeline/formats/model_formats.h"
#include "pipeline/formats/model_reader.h"
#include "pipeline/formats/obj/obj_file.h"
#include "pipeline/formats/obj/obj_smoothing.h"
#include "pipeline/formats/text/text_scanner.h"
#include "pipeline/scene/mesh/make_mesh.h"

// Wavefront OBJ as its manual describes polygons (Object Files, 1995, appendix B1). Curves, surfaces, points, lines and
// texture coordinates are left out.
//
// An own reader: the packaged tinyobjloader takes "nan" and words for 0, lets infinity through, and
// wraps indices beyond 2^31 around, so that every line had to be checked before it in any case.
namespace pipeline {
namespace {

// Numbers the vertices of the groups of a file. A position with one normal is one vertex; with another normal it is another
// one.
class VertexMaker {
public:
    VertexMaker(const ObjFile& file, StopCheck& check)
        : m_file(file), m_check(check), m_first(file.positions.size(), kNone) {}

    // A mesh of a group's vertices alone; the positions of its corners become their numbers.
    Mesh verticesOf(ObjFaces& faces) {
        const bool hasNormals = faces.haveNormals();
        m_corners.clear(), m_others.clear();
        m_corners.reserve(std::min(m_first.size(), faces.positions.size()));
        std::size_t i = 0;
        for (std::uint32_t& position : faces.positions) {
            if (m_check.stopped()) return {};
            position = vertex({position, hasNormals ? faces.normal(i++) : kNoNormal});
        }
        faces.normals.clear();
        Mesh mesh;
        mesh.positions.reserve(m_corners.size());
        if (hasNormals) mesh.normals.reserve(m_corners.size());
        const bool hasColors = std::ranges::any_of(
            m_corners, [&](const ObjCorner& corner) { return corner.position < m_file.colors.size(); });
        for (const ObjCorner& corner : m_corners) {
            mesh.positions.push_back(m_file.positions[corner.position]);
            if (hasNormals) mesh.normals.push_back(m_file.normals[corner.normal]);
            if (hasColors)
                mesh.colors.push_back(corner.position < m_file.colors.size() ? m_file.colors[corner.position]
                                                                             : Vec3d(1));
            m_first[corner.position] = kNone;
        }
        return mesh;
    }

private:
    static constexpr std::uint32_t kNone = UINT32_MAX;

    std::uint32_t vertex(const ObjCorner& corner) {
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
    StopCheck& m_check;
    std::vector<std::uint32_t> m_first;                         // vertex of a position, or kNone
    std::unordered_map<std::uint64_t, std::uint32_t> m_others;  // by position and normal, where it has several
    std::vector<ObjCorner> m_corners;                           // per vertex
};

// faces: the vertex of each corner stands where its position stood. leftOut: counts the polygons without area.
void addPolygons(ObjFaces faces, Mesh& mesh, const std::string& file, CaseTally& leftOut, StopCheck& check) {
    mesh.reservePolygons(faces.count(), faces.positions.size());
    mesh.polygonPlaces.reserve(faces.count());
    std::vector<std::uint32_t> corners;
    auto from = faces.positions.cbegin();
    auto first = faces.firstCorner.cbegin();
    for (const TextPosition& place : faces.places) {
        const auto to = from + (first[1] - first[0]);
        if (check.stopped(first[1] - first[0])) return;
        corners.assign(from, to);
        if (addPolygon(mesh, corners))
            mesh.polygonPlaces.push_back(place);
        else
            leftOut.add(file, place.line);
        from = to, ++first;
    }
}

// Of each group. What the file gives and what becomes of it are twice the meshes at most: the polygons are made when its
// positions and normals are gone.
std::vector<Mesh> meshesOf(ObjFile& file, const std::string& name, StopCheck& check) {
    file.positions.shrink_to_fit(), file.normals.shrink_to_fit();
    giveBackFreedMemory();
    std::vector<Mesh> meshes;
    {
        VertexMaker maker(file, check);
        for (ObjGroup& group : file.groups) meshes.push_back(maker.verticesOf(group.faces));
    }
    file.positions.clear(), file.normals.clear(), file.colors.clear();
    giveBackFreedMemory();
    for (std::size_t i = 0; i < meshes.size(); ++i)
        addPolygons(std::move(file.groups[i].faces), meshes[i], name, file.tallies.fewCorners, check);
    giveBackFreedMemory();
    return meshes;
}

// Groups of which some corners have normals and others none, counted at the first face that lacks one.
CaseTally mixedNormals(const ObjFile& file, const std::string& name) {
    CaseTally mixed;
    for (const ObjGroup& group : file.groups) {
        const ObjFaces& faces = group.faces;
        const auto none = std::ranges::find(faces.normals, kNoNormal);
        if (faces.numbers != NormalNumbers::Own || none == faces.normals.end()) continue;
        if (std::ranges::all_of(faces.normals, [](std::uint32_t normal) { return normal == kNoNormal; })) continue;
        const auto corner = static_cast<std::uint32_t>(none - faces.normals.begin());
        const auto after = std::ranges::upper_bound(faces.firstCorner, corner);
        mixed.add(name, faces.places[std::size_t(after - faces.firstCorner.begin()) - 1].line);
    }
    return mixed;
}

// Faces whose material no file gives. Where a file of materials is missing, that has been said.
CaseTally unknownMaterials(const ObjFile& file, const ObjMaterials& materials, const std::string& name) {
    CaseTally unknown;
    if (materials.someMissing()) return unknown;
    for (const ObjGroup& group : file.groups)
        if (!group.material.empty() && group.faces.count() > 0 && !materials.find(group.material))
            unknown.add(name, group.faces.places.front().line, group.faces.count());
    return unknown;
}

void say(const ObjTallies& of, const CaseTally& mixed, const CaseTally& unknown, std::vector<Remark>& remarks) {
    unknown.say("face", "with a material that no material file gives", "shown with the default material", remarks);
    remarkOnLeftOut(of.fewCorners.count(), of.fewCorners.about(), remarks);
    of.badNormals.say("normal", "without a direction", "taken as missing", remarks);
    of.unknownNormals.say("normal", "of corners, named by a number that the file has not above,", "taken as missing",
                          remarks);
    mixed.say("object", "with normals at some corners and none at others", "shown without the file's normals", remarks);
    of.badColors.say("colour", "of vertices, not three numbers from 0 up,", "taken as white", remarks);
    of.points.say("statement", "of points", "left out", remarks);
    of.lines.say("statement", "of lines", "left out", remarks);
    of.freeForms.say("curve and surface statement", "", "left out", remarks);
    of.calls.say("call or csh statement", "", "left out: other files and commands are never run", remarks);
    of.furtherGroups.say("group statement", "beyond 4096 groups", "joined to one object", remarks);
    of.unknownStatements.say("statement", "that OBJ files do not have, as " + of.firstUnknown + ",", "left out",
                             remarks);
}

}  // namespace

Result<LoadedModel> readObj(const SourceText& source, const FileLoader& load) {
    Errors errors;
    ObjMaterials materials(source, load, errors);
    ObjFile file = parseObj(source, materials, errors);
    if (!errors.empty()) return errors;
    std::map<std::size_t, int> groupsOf;
    for (const ObjGroup& group : file.groups) groupsOf[group.object] += group.faces.count() > 0;
    const CaseTally mixed = mixedNormals(file, source.name), unknown = unknownMaterials(file, materials, source.name);
    StopCheck check(source.progress.stop);
    smoothNormals(file, check);
    if (check.stopped(0)) return readingStopped(source.name);
    LoadedModel model;
    model.remarks = materials.remarks();
    settleColors(file.colors, source.name, model.remarks);
    std::vector<Mesh> meshes = meshesOf(file, source.name, check);
    if (check.stopped(0)) return readingStopped(source.name);
    say(file.tallies, mixed, unknown, model.remarks);
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        const ObjGroup& group = file.groups[i];
        if (meshes[i].polygonCount() == 0) continue;
        meshes[i].file = meshFileOf(source);
        Object& object = model.objects.emplace_back();
        object.name = group.name;
        if (groupsOf[group.object] > 1) object.name += ", " + shownName(group.material, "no material");
        object.material = defaultMaterial(meshes[i]);
        object.mesh = makeMesh(std::move(meshes[i]), source.progress.stop);
        if (const Material* material = materials.find(group.material)) object.material = *material;
    }
    return model;
}

}  // namespace pipeline
