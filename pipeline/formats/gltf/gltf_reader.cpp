#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "pipeline/core/text.h"
#include "pipeline/formats/gltf/gltf_accessor.h"
#include "pipeline/formats/gltf/gltf_formats.h"
#include "pipeline/formats/lecture/lecture_values.h"
#include "pipeline/formats/model_formats.h"
#include "pipeline/formats/text/read_budget.h"
#include "pipeline/formats/welded_vertices.h"
#include "pipeline/scene/mesh/make_mesh.h"

// glTF 2.0 (Khronos Group, glTF 2.0 Specification, 2021): the triangles of a scene's nodes, their
// normals, and the factors of their materials.
//
// An own reader on a JSON parser: the packaged tinygltf recurses as deep as a file nests.
namespace pipeline {
namespace {

constexpr std::size_t kMaxObjects = 65536;
// Looked at, also where nothing comes of them: nodes may name the same mesh again and again.
constexpr std::size_t kMaxPrimitives = 1 << 20;
constexpr std::size_t kShares = 1000;  // of one instance, for who waits

enum Mode : std::uint64_t { kTriangles = 4, kStrip = 5, kFan = 6 };

// Corners of the triangle `i` (section 3.7.2.1). Every other one of a strip is turned round, so that all face alike.
std::array<std::size_t, 3> cornersOf(std::uint64_t mode, std::size_t i) {
    if (mode == kStrip) return {i, i + 1 + i % 2, i + 2 - i % 2};
    if (mode == kFan) return {i + 1, i + 2, 0};
    return {3 * i, 3 * i + 1, 3 * i + 2};
}

constexpr std::string_view kQuantized = "KHR_mesh_quantization";

// Extensions of materials, pictures, lights and what is said about the file leave the shape as it is.
bool isBesideGeometry(std::string_view extension) {
    constexpr std::string_view kBeside[]{"KHR_materials_", "EXT_materials_", "KHR_texture_",      "EXT_texture_",
                                         "MSFT_texture_",  "KHR_lights_",    "EXT_lights_",       "KHR_xmp",
                                         "KHR_audio",      "KHR_animation_", "KHR_interactivity", "KHR_techniques_"};
    return std::ranges::any_of(kBeside, [&](std::string_view start) { return extension.starts_with(start); });
}

class GltfReader {
public:
    // bytes: of the file.
    GltfReader(GltfFile& file, const FileLoader& load, const ReadProgress& progress, std::size_t bytes)
        : m_file(file), m_buffers(load), m_progress(progress), m_bytes(bytes) {}

    LoadedModel read() {
        checkHead();
        if (!m_file.errors.empty()) return {};
        const std::vector<GltfInstance> instances = instancesOf(m_file);
        ReadMeter meter(kShares * instances.size(), m_file.name, m_progress);
        m_meter = &meter;
        m_someNormals = std::ranges::any_of(instances, givesNormals);
        for (const GltfInstance& instance : instances) {
            if (m_file.errors.size() >= kMaxErrors || !meter.goesOn(m_told, m_file.errors)) break;
            const GltfValue primitives = instance.mesh["primitives"];
            if (!primitives.isThere()) primitives.refuse("an array of primitives");
            for (std::size_t k = 0; k < primitives.size() && m_primitives <= kMaxPrimitives; ++k)
                readPrimitive(instance, primitives.at(k), primitives.size() > 1);
            m_told += kShares;
        }
        LoadedModel model{std::move(m_objects), remarksOf(m_file), m_file.doubleSided};
        remarkOnLeftOut(m_leftOut, m_file.name, model.remarks);
        return model;
    }

private:
    static bool givesNormals(const GltfInstance& instance) {
        const GltfValue primitives = instance.mesh["primitives"];
        for (std::size_t k = 0; k < primitives.size() && k <= kMaxPrimitives; ++k)
            if (primitives.at(k)["attributes"]["NORMAL"].isThere()) return true;
        return false;
    }
    static bool isIn(const GltfValue& list, std::string_view name) {
        for (std::size_t i = 0; i < list.size(); ++i)
            if (list.at(i).text() == name) return true;
        return false;
    }

    void checkHead() {
        const GltfValue top(m_file), asset = top["asset"];
        for (const GltfValue& version : {asset["version"], asset["minVersion"]}) {
            const auto text = version.text();
            const bool needed = version.pointer() == "/asset/version";
            if ((!text && needed && !version.isThere()) || (text && !text->starts_with("2.")))
                version.refuse("\"2.0\"");
        }
        const GltfValue required = top["extensionsRequired"], used = top["extensionsUsed"];
        for (std::size_t i = 0; i < required.size(); ++i)
            if (const auto name = required.at(i).text(); name && *name != kQuantized && !isBesideGeometry(*name))
                required.at(i).fail(fmt::format("{} is {}, which is not read, and the shape depends on it",
                                                required.at(i).pointer(), quotedInput(*name)),
                                    "a file that does not require it");
        for (const GltfValue& list : {required, used})
            for (std::size_t i = 0; i < list.size(); ++i)
                if (const auto name = list.at(i).text(); name && *name == kQuantized)
                    m_quantized = true;
                else if (name && (*name == kSpecularGlossiness || *name == "KHR_lights_punctual"))
                    continue;
                else if (name && !isIn(required, *name))
                    remark(m_file, fmt::format("The extension {} is not read.", quotedInput(*name)));
                else if (name && list.pointer() == required.pointer())
                    remark(m_file, fmt::format("The file requires the extension {}, which is not read; the shape does "
                                               "not depend on it.",
                                               quotedInput(*name)));
        if (top["animations"].isThere()) remark(m_file, "Animations are not read; every node stays as it is written.");
        if (const std::size_t cameras = top["cameras"].size(); cameras > 0)
            remark(m_file, fmt::format("The file has {}; --camera 0 takes its first.",
                                       plural(std::int64_t(cameras), "camera")));
        if (const std::size_t lights = top["extensions"]["KHR_lights_punctual"]["lights"].size(); lights > 0)
            remark(m_file, fmt::format("The file has {}; --lights file takes {}.",
                                       plural(std::int64_t(lights), "light"), lights == 1 ? "it" : "them"));
    }

    void readPrimitive(const GltfInstance& instance, const GltfValue& primitive, bool hasTwins) {
        if (++m_primitives > kMaxPrimitives)
            return primitive.fail(fmt::format("the nodes have more than {} primitives", groupedDigits(kMaxPrimitives)));
        const auto mode = primitive["mode"].isThere() ? primitive["mode"].whole(0, 6) : std::optional<std::uint64_t>(4);
        if (!mode) return;
        if (*mode < kTriangles) return remark(m_file, "Points and lines are not read.", "primitive");
        if (primitive["targets"].isThere())
            remark(m_file, "Morph targets are not read; the mesh stays as it is written.", "primitive");
        const GltfValue attributes = primitive["attributes"];
        if (attributes["TEXCOORD_0"].isThere())
            remark(m_file, "Picture coordinates of vertices are not read.", "attribute");
        const GltfValue positionIndex = attributes["POSITION"];
        // Without positions the specification has nothing drawn.
        if (!positionIndex.isThere()) return remark(m_file, "A primitive without positions is left out.", "primitive");
        const auto position = accessorAt(positionIndex, "VEC3", m_buffers);
        if (!position || !hasRoomFor(primitive, position->count) || !isVectorType(positionIndex, *position, false))
            return;
        const auto corners = readCorners(primitive["indices"], position->count);
        if (!corners) return;
        const std::size_t count =
            *mode == kTriangles ? corners->size() / 3 : corners->size() - std::min<std::size_t>(2, corners->size());
        if (count == 0 || (*mode == kTriangles && corners->size() % 3 != 0))
            remark(m_file, "A primitive ends within a triangle; that one is left out.", "primitive");
        if (count == 0) return;
        auto positions = readVectors(m_file, *position);
        auto normals = readNormals(attributes["NORMAL"], position->count);
        const auto colors = readColors(attributes["COLOR_0"], position->count);
        if (!positions || !place(instance, *positions, normals)) return;
        addObject(instance, primitive, hasTwins, [&](Mesh& mesh) {
            const bool mirrored = glm::determinant(glm::dmat3(instance.toWorld)) < 0;
            // Without normals a primitive is flat (section 3.7.2.1), also beside others that have some.
            const bool isFlat = !attributes["NORMAL"].isThere() && m_someNormals;
            WeldedVertices welded(mesh, isFlat || !normals.empty(), !colors.empty());
            welded.reserve(positions->size());
            for (std::size_t i = 0; i < count; ++i) {
                if (m_file.check.stopped(3) || !m_meter->goesOn(m_told + kShares * i / count, m_file.errors)) return;
                std::array<std::size_t, 3> triangle = cornersOf(*mode, i);
                if (mirrored) std::swap(triangle[1], triangle[2]);
                const auto cornerOf = [&](std::size_t k) { return (*corners)[triangle[k]]; };
                const auto placeOf = [&](std::size_t k) -> const Vec3d& { return (*positions)[cornerOf(k)]; };
                Vec3d ofAll(0.0);
                if (isFlat)  // without area any will do
                    ofAll = unitVector(glm::cross(placeOf(1) - placeOf(0), placeOf(2) - placeOf(0)))
                                .value_or(Vec3d(0, 0, 1));
                std::array<std::uint32_t, 3> polygon{};
                for (std::size_t k = 0; k < 3; ++k)
                    polygon[k] = welded.at(placeOf(k), normals.empty() ? ofAll : normals[cornerOf(k)],
                                           colors.empty() ? Vec3d(0.0) : colors[cornerOf(k)]);
                // A strip may repeat a corner to go on elsewhere.
                if (!addPolygon(mesh, polygon) && *mode == kTriangles) ++m_leftOut;
            }
            dropUnusedVertices(mesh);
        });
    }

    // Puts them where the node and its parents do, +y up. Without normals where one has no length.
    bool place(const GltfInstance& instance, std::vector<Vec3d>& positions, std::vector<Vec3d>& normals) {
        for (Vec3d& p : positions) {
            if (m_file.check.stopped()) return false;
            p = Vec3d(instance.toWorld * glm::dvec4(p, 1));
            if (isCoordinate(p.x) && isCoordinate(p.y) && isCoordinate(p.z)) continue;
            const auto text = [](double x) { return textBeyond(x, std::copysign(kFarthestVertex, x)); };
            instance.node.fail(fmt::format("{} moves a vertex to ({}, {}, {})", instance.node.pointer(), text(p.x),
                                           text(p.y), text(p.z)),
                               numberFrom(-kFarthestVertex, kFarthestVertex));
            return false;
        }
        // The cofactors are the inverse transpose but for a factor, and exist for a flat node as well.
        const glm::dmat3 m(instance.toWorld);
        const double side = glm::determinant(m) < 0 ? -1 : 1;
        const glm::dmat3 cofactors(side * glm::cross(m[1], m[2]), side * glm::cross(m[2], m[0]),
                                   side * glm::cross(m[0], m[1]));
        for (Vec3d& n : normals) {
            if (m_file.check.stopped()) return false;
            const auto unit = unitVector(cofactors * n);
            if (!unit) {
                remark(m_file, "Some normals have no length; the normals of their object are not used.", "object");
                normals.clear();
                break;
            }
            n = *unit;
        }
        return true;
    }

    void addObject(const GltfInstance& instance, const GltfValue& primitive, bool hasTwins, auto fill) {
        Mesh mesh;
        fill(mesh);
        if (mesh.polygonCount() == 0) return;
        if (m_objects.size() == kMaxObjects)
            return primitive.fail(fmt::format("more than {} objects", groupedDigits(kMaxObjects)));
        mesh.file = m_file.meshFile;
        Object& object = m_objects.emplace_back();
        object.material = defaultMaterial(mesh);
        object.mesh = makeMesh(std::move(mesh), m_progress.stop);
        object.transform.up = UpAxis::Y;
        const GltfValue materialIndex = primitive["material"];
        const std::size_t errors = m_file.errors.size();
        const auto material = materialIndex.element("materials");
        dropErrors(m_file, errors, "the object has the default material", "object");
        if (material) object.material = readGltfMaterial(*material);
        const std::size_t before = m_file.errors.size();
        const std::string otherwise = shownName(instance.mesh["name"].text().value_or(""), stemOf(m_file.name));
        object.name = shownName(instance.node["name"].text().value_or(""), otherwise);
        if (hasTwins)
            object.name += ", " + shownName(material ? (*material)["name"].text().value_or("") : "", "no material");
        dropErrors(m_file, before, "the name is not read", "object");
    }

    // Primitives may name the same vertices again and again; what they amount to is limited.
    bool hasRoomFor(const GltfValue& primitive, std::size_t count) {
        m_elements += count;
        const std::size_t most = std::min(kMaxVertices, ReadBudget::mostVertices(m_bytes + m_buffers.bytesRead()));
        if (m_elements <= most) return true;
        primitive.fail(
            fmt::format("up to {} the file has {} vertices and corners", primitive.pointer(),
                        groupedDigits(m_elements)),
            fmt::format("at most {}{}", groupedDigits(most), most < kMaxVertices ? " in a file of this size" : ""));
        return false;
    }

    // Sections 3.7.2.1 and, for integers, KHR_mesh_quantization.
    bool isVectorType(const GltfValue& attribute, const GltfAccessor& accessor, bool isNormal) const {
        const bool whole = accessor.componentType >= 5120 && accessor.componentType <= 5123;
        const bool isSigned = accessor.componentType == 5120 || accessor.componentType == 5122;
        if (accessor.componentType == 5126) return true;
        if (m_quantized && whole && (!isNormal || (isSigned && accessor.normalized))) return true;
        attribute.fail(fmt::format("{}/componentType is {}", accessor.pointer, accessor.componentType),
                       fmt::format("5126 for {}", attribute.pointer()));
        return false;
    }

    // The corners as vertices; without indices every vertex is one.
    std::optional<std::vector<std::uint32_t>> readCorners(const GltfValue& index, std::size_t vertexCount) {
        if (index.isThere()) {
            const auto accessor = accessorAt(index, "SCALAR", m_buffers);
            if (!accessor || !hasRoomFor(index, accessor->count)) return {};
            return readIndices(m_file, *accessor, vertexCount);
        }
        std::vector<std::uint32_t> corners(vertexCount);
        for (std::size_t i = 0; i < vertexCount; ++i) corners[i] = static_cast<std::uint32_t>(i);
        return corners;
    }

    // Empty where the primitive has none that can be used.
    std::vector<Vec3d> readNormals(const GltfValue& index, std::size_t vertexCount) {
        if (!index.isThere()) return {};
        const std::size_t errors = m_file.errors.size();
        const auto accessor = accessorAt(index, "VEC3", m_buffers);
        std::optional<std::vector<Vec3d>> normals;
        if (accessor && isVectorType(index, *accessor, true)) {
            if (accessor->count == vertexCount)
                normals = readVectors(m_file, *accessor);
            else
                index.fail(fmt::format("{}/count is {}", accessor->pointer, groupedDigits(accessor->count)),
                           fmt::format("{}, as many as positions", groupedDigits(vertexCount)));
        }
        dropErrors(m_file, errors, "the normals are not used", "primitive");
        return normals.value_or(std::vector<Vec3d>());
    }

    // Section 3.7.2.1: three or four components, the fourth of which is opacity; floats or normalised whole numbers. They
    // multiply the base colour. Empty where the primitive has none that can be used, or white alone.
    std::vector<Vec3d> readColors(const GltfValue& index, std::size_t vertexCount) {
        if (!index.isThere()) return {};
        const std::size_t errors = m_file.errors.size();
        const auto named = index.element("accessors");
        const bool hasFour = named && (*named)["type"].text() == "VEC4";
        const auto accessor = accessorAt(index, hasFour ? "VEC4" : "VEC3", m_buffers);
        std::vector<Vec3d> colors;
        bool isWhite = true;
        if (accessor && accessor->count != vertexCount)
            index.fail(fmt::format("{}/count is {}", accessor->pointer, groupedDigits(accessor->count)),
                       fmt::format("{}, as many as positions", groupedDigits(vertexCount)));
        for (std::size_t i = 0; accessor && accessor->count == vertexCount && i < vertexCount; ++i) {
            if (m_file.check.stopped(3)) return {};
            Vec3d color(1.0);
            for (std::size_t c = 0; c < 3; ++c) {
                const double value = accessor->component(i, c);
                color[glm::length_t(c)] = isColor(value) ? std::min(value, 1.0) : 1.0;
            }
            isWhite = isWhite && color == Vec3d(1.0);
            colors.push_back(color);
        }
        dropErrors(m_file, errors, "the colours are not used", "primitive");
        return isWhite ? std::vector<Vec3d>() : colors;
    }

    GltfFile& m_file;
    GltfBuffers m_buffers;
    const ReadProgress& m_progress;
    ReadMeter* m_meter = nullptr;
    std::size_t m_told = 0;  // of kShares for each instance
    bool m_quantized = false, m_someNormals = false;
    std::size_t m_bytes = 0;                       // of the file, without its buffers' files
    std::size_t m_elements = 0, m_primitives = 0;  // read so far
    std::size_t m_leftOut = 0;                     // triangles without an area
    std::vector<Object> m_objects;
};

}  // namespace

Result<LoadedModel> readGltf(const SourceText& source, const FileLoader& load) {
    if (source.tail) {
        const Result<std::string> text = wholeText(source);
        if (!text) {
            Error error = text.errors().front();
            error.where.file = source.name;
            return error;
        }
        return readGltf({*text, source.name, source.progress, nullptr, source.called}, load);
    }
    Result<GltfFile> parsed = parseGltf(source);
    if (!parsed) return parsed.errors();
    GltfFile file = std::move(parsed).value();
    LoadedModel model = GltfReader(file, load, source.progress, source.text.size()).read();
    if (!file.errors.empty()) return file.errors;
    return model;
}

}  // namespace pipeline
