#include "pipeline/formats/scene_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <optional>

#include "pipeline/core/numerics.h"
#include "pipeline/core/text.h"
#include "pipeline/formats/format_table.h"
#include "pipeline/formats/model_reader.h"
#include "pipeline/formats/text/no_memory.h"
#include "pipeline/formats/text/text_scanner.h"
#include "pipeline/scene/alike_remarks.h"
#include "pipeline/scene/mesh/closed_mesh.h"
#include "pipeline/scene/mesh/coplanar.h"
#include "pipeline/scene/settings_table.h"

namespace pipeline {
namespace {

Errors inFile(Errors errors, const std::string& file) {
    for (Error& error : errors)
        if (error.where.file.empty()) error.where.file = file;
    return errors;
}

// Spares reading a large file that cannot be a scene.
bool beginsWithEndlessWord(std::string_view start) {
    Errors none;
    return TextScanner(start, {}, none).next().size() > kMaxWord;
}

Error refused(SourceLocation where, std::string found) { return {std::move(where), std::move(found), knownFormats()}; }

// What packs files is told by its first bytes, whatever the file is called.
std::optional<Error> whyPacked(std::string_view start, const std::string& name) {
    struct Packed {
        std::string_view mark, found, how;
    };
    using namespace std::string_view_literals;
    constexpr Packed kPacked[]{{"\x1f\x8b"sv, "a file packed by gzip (.gz)", "gunzip"},
                               {"PK\3\4"sv, "a ZIP archive (.zip)", "unzip"},
                               {"BZh"sv, "a file packed by bzip2 (.bz2)", "bunzip2"},
                               {"\xFD\x37zXZ\0"sv, "a file packed by xz (.xz)", "unxz"},
                               {"7z\xBC\xAF\x27\x1C"sv, "a 7-Zip archive (.7z)", "7z x"},
                               {"\x28\xB5\x2F\xFD"sv, "a file packed by zstd (.zst)", "unzstd"}};
    for (const Packed& packed : kPacked)
        if (start.starts_with(packed.mark))
            return Error{{name, 0, 0},
                         fmt::format("found {}", packed.found),
                         fmt::format("the scene or model in it: unpack it first, as with {}", packed.how)};
    return {};
}

Result<Scene> readUnchecked(const std::filesystem::path& file, const ReadProgress& progress) {
    const std::string name = file.string();
    const Result<NamedFile> opened = openFile(file);
    if (!opened) return opened.errors();
    const std::string& start = opened->text;
    if (const auto packed = whyPacked(start, name)) return *packed;
    const Format* format = findFormat(start, file.extension().string());
    if (!format) return refused({name, 0, 0}, "found no scene");
    if (isModel(file.extension().string()))
        return format->read({start, name, progress, opened->tail}, filesBeside(file));
    if (!format->looksLike(start) && beginsWithEndlessWord(start))
        return refused({name, 1, 1}, "found a word of more than " + groupedDigits(kMaxWord) + " bytes");
    const Result<std::string> text = wholeText({start, name, progress, opened->tail});
    if (!text) return text.errors();
    return format->read({*text, name, progress}, filesBeside(file));
}

// Whether the normals that a mesh gives to the corners of a polygon, summed, point against its winding.
bool isTurned(const Mesh& mesh, std::size_t polygon) {
    Vec3d along(0), given(0);
    for (std::size_t t = mesh.firstTriangleOf(polygon); t < mesh.firstTriangleOf(polygon + 1); ++t) {
        const auto& v = mesh.triangles[t].vertices;
        const Vec3d origin = mesh.positions[v[0]];
        along += glm::cross(mesh.positions[v[1]] - origin, mesh.positions[v[2]] - origin);
    }
    for (const std::uint32_t corner : mesh.polygon(polygon)) given += normalized(mesh.normals[corner]);
    return glm::dot(normalized(along), given) < 0;
}

// Of given normals, which are computed with as they are.
void remarkOnNormals(const Object& object, AlikeRemarks& remarks) {
    const Mesh& mesh = *object.mesh;
    if (mesh.normals.empty()) return;
    if (!mesh.facts.ownNormals)  // else none is 0
        if (const auto zero = std::ranges::count_if(mesh.normals, [](const Vec3d& n) { return n == Vec3d(0); });
            zero > 0)
            remarks.add("zero", inQuotes(object.name),
                        {object.name,
                         fmt::format("{} of the {} normals that {} gives {} length 0. The normals of the polygons "
                                     "around the vertex take the place of such a normal.",
                                     zero, mesh.normals.size(), inQuotes(object.name), zero == 1 ? "has" : "have")});
    std::int64_t turned = 0;
    for (std::size_t i = 0; i < mesh.polygonCount(); ++i) turned += isTurned(mesh, i);
    if (turned > 0)
        remarks.add(
            "turned", inQuotes(object.name),
            {object.name,
             fmt::format("The given normals of {} of {} point against the winding: with normal_weight = given the side "
                         "that is seen is lit from behind. Turn the normals or the order of the vertices round, or "
                         "choose another normal_weight.",
                         plural(turned, "polygon"), inQuotes(object.name))});
}

// Where backs are left out, or are not lit from behind, the inside of such a mesh is seen.
void remarkOnTurned(const Object& object, StopCheck& check, AlikeRemarks& remarks) {
    const Mesh& mesh = *object.mesh;
    const std::string name = inQuotes(object.name), mend = "cull=none with two_sided=on shows and lights both sides.";
    const auto inward = std::int64_t(mesh.facts.closed ? inwardPolygons(mesh, check) : 0);
    const auto edges = std::int64_t(mesh.facts.closed ? 0 : edgeUseOf(mesh, check).turned);
    const bool isAll = inward == std::int64_t(mesh.polygonCount());
    if (inward > 0)
        remarks.add("inward", name,
                    {object.name,
                     fmt::format("{} turned inside out: seen from outside {} run clockwise, as backs do. Reverse the "
                                 "order of their vertices; {}",
                                 isAll         ? name + " is closed and"
                                 : inward == 1 ? fmt::format("1 polygon of {} is", name)
                                               : fmt::format("{} polygons of {} are", inward, name),
                                 isAll ? "its polygons" : "they", mend)});
    if (edges > 0)
        remarks.add("turned edges", name,
                    {object.name, fmt::format("At {} of {} both polygons run along the edge the same way: one of the "
                                              "two is turned inside out. {}",
                                              plural(edges, "edge"), name, mend)});
}

}  // namespace

Result<Scene> readScene(const std::filesystem::path& file, const ReadProgress& progress) {
    const std::string name = file.string();
    try {
        if (progress.stop.stop_requested()) return readingStopped(name);
        Result<Scene> result = readUnchecked(file, progress);
        if (progress.stop.stop_requested()) return readingStopped(name);
        if (!result) return inFile(result.errors(), name);
        Scene scene = std::move(result).value();
        if (scene.name.empty()) scene.name = printableText(file.filename().string());
        scene.file = name;
        const Errors errors = checkScene(scene);
        if (!errors.empty()) return inFile(errors, name);
        AlikeRemarks ofMeshes;
        StopCheck check(progress.stop);
        for (const Object& object : scene.objects) {
            remarkOnTurned(object, check, ofMeshes);
            remarkOnNormals(object, ofMeshes);
        }
        remarkOnCoplanar(scene, check, ofMeshes);
        if (check.stopped()) return readingStopped(name);
        ofMeshes.moveTo(scene.remarks);
        return scene;
    } catch (const std::bad_alloc&) {
        return noMemoryToRead({name, 0, 0}, "scene");
    }
}

}  // namespace pipeline
