#include "pipeline/formats/model_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <new>

#include "pipeline/core/text.h"
#include "pipeline/formats/lecture/lecture_values.h"
#include "pipeline/formats/model_formats.h"
#include "pipeline/formats/text/line_scanner.h"
#include "pipeline/formats/text/no_memory.h"
#include "pipeline/scene/mesh/make_mesh.h"

namespace pipeline {
namespace {

struct ModelFormat {
    std::string_view extension;
    Result<LoadedModel> (*read)(const SourceText& source, const FileLoader& load);
};

constexpr ModelFormat kModelFormats[] = {
    {".obj", readObj}, {".ply", readPly}, {".stl", readStl}, {".off", readOff}, {".gltf", readGltf}, {".glb", readGltf},
};

const ModelFormat* findModelFormat(std::string_view extension) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
    for (const ModelFormat& format : kModelFormats)
        if (std::ranges::equal(format.extension, extension, {}, lower, lower)) return &format;
    return nullptr;
}

// The format that a file is of by its first words, whatever its name says; null where they do not tell.
const ModelFormat* formatByContent(const SourceText& source) {
    if (source.text.starts_with("glTF")) return findModelFormat(".glb");
    Errors none;
    LineScanner scanner(source.text, {}, none);
    std::string_view word;
    while (word.empty() && scanner.nextLine()) word = scanner.next();
    if (word.starts_with('{') && source.text.find("\"asset\"") != source.text.npos) return findModelFormat(".gltf");
    if (word == "ply") return findModelFormat(".ply");
    if (word == "OFF" || word == "COFF" || word == "NOFF") return findModelFormat(".off");
    if (sameLetters(word, "solid") && scanner.nextLine() && sameLetters(scanner.next(), "facet"))
        return findModelFormat(".stl");
    constexpr std::string_view kObjStatements[]{"v", "vn", "vt", "o", "g", "s", "mtllib", "usemtl"};
    if (std::ranges::find(kObjStatements, word) != std::end(kObjStatements) && !scanner.peek().empty())
        return findModelFormat(".obj");
    return nullptr;
}

}  // namespace

bool isModel(std::string_view extension) { return findModelFormat(extension) != nullptr; }

Result<LoadedModel> readModel(const SourceText& source, std::string_view extension, const FileLoader& load) {
    const ModelFormat* format = findModelFormat(extension);
    if (!format) return Error{{source.name, 0, 0}, "found no model", {}};
    try {
        Result<LoadedModel> model = format->read(source, load);
        if (source.progress.stop.stop_requested()) return readingStopped(source.name);
        const ModelFormat* const other = model && !model->objects.empty() ? nullptr : formatByContent(source);
        if (other && other->read != format->read)
            return Error{{source.name, 0, 0},
                         fmt::format("found what a {} file holds", other->extension),
                         fmt::format("what a {} file holds: give the file the extension {}", format->extension,
                                     other->extension)};
        if (model && model->objects.empty()) {
            std::string found = "found no polygon";
            for (const Remark& remark : model->remarks) found += "; " + remark.text;
            if (found.ends_with('.')) found.pop_back();
            return Error{{source.name, 0, 0}, std::move(found), "a model with polygons"};
        }
        return model;
    } catch (const std::bad_alloc&) {
        return noMemoryToRead({source.name, 0, 0}, "model");
    }
}

std::optional<Vec3d> unitVector(const Vec3d& vector) {
    // Scaled first: the square of 1e-200 is 0.
    const double largest = std::max({std::abs(vector.x), std::abs(vector.y), std::abs(vector.z)});
    if (!(largest > 0) || !std::isfinite(vector.x + vector.y + vector.z)) return {};
    const Vec3d scaled(vector.x / largest, vector.y / largest, vector.z / largest);
    return scaled / glm::length(scaled);
}

bool addPolygon(Mesh& mesh, std::span<const std::uint32_t> corners, TextPosition place) {
    std::vector<std::uint32_t> distinct;
    const bool repeats =
        std::ranges::adjacent_find(corners) != corners.end() || (!corners.empty() && corners.front() == corners.back());
    if (repeats) {
        std::ranges::unique_copy(corners, std::back_inserter(distinct));
        while (distinct.size() > 1 && distinct.back() == distinct.front()) distinct.pop_back();
        corners = distinct;
    }
    if (corners.size() < 3) return false;
    mesh.addPolygon(corners);
    if (place.line > 0) mesh.polygonPlaces.push_back(place);
    return true;
}

void remarkOnLeftOut(std::size_t polygons, const std::string& about, std::vector<Remark>& remarks) {
    if (polygons == 0) return;
    remarks.push_back(
        {about, polygons == 1
                    ? "1 polygon has fewer than three different corners, and so no area; it is left out."
                    : fmt::format("{} polygons have fewer than three different corners, and so no area; they are "
                                  "left out.",
                                  groupedDigits(polygons))});
}

void dropUnusedVertices(Mesh& mesh) {
    std::vector<std::uint32_t> number(mesh.positions.size(), 0);
    for (std::size_t i = 0; i < mesh.polygonCount(); ++i)
        for (const std::uint32_t corner : mesh.polygon(i)) number[corner] = 1;
    std::uint32_t used = 0;
    for (std::size_t i = 0; i < number.size(); ++i) {
        if (number[i] == 0) continue;
        mesh.positions.set(used, mesh.positions[i]);
        for (VertexVectors* const of : {&mesh.normals, &mesh.colors})
            if (!of->empty()) of->set(used, (*of)[i]);
        number[i] = used++;
    }
    mesh.positions.resize(used);
    for (VertexVectors* const of : {&mesh.normals, &mesh.colors})
        if (!of->empty()) of->resize(used);
    mesh.renumberVertices(number);
}

std::string stemOf(const std::string& path) { return printableText(std::filesystem::path(path).stem().string()); }
std::string fileNameOf(const std::string& path) { return std::filesystem::path(path).filename().string(); }
std::string meshFileOf(const SourceText& source) {
    return source.called.empty() ? fileNameOf(source.name) : source.called;
}

void settleColors(VertexVectors& colors, const std::string& file, std::vector<Remark>& remarks) {
    double largest = 0;
    bool isWhite = true;
    for (const Vec3d& color : colors) {
        largest = std::max({largest, color.x, color.y, color.z});
        isWhite = isWhite && color == Vec3d(1);
    }
    if (isWhite) return colors.clear();
    if (largest > 1) {
        for (std::size_t i = 0; i < colors.size(); ++i) colors.set(i, colors[i] / 255.0);
        remarks.push_back({file, "Colours of vertices are above 1: all are taken as written from 0 to 255."});
    }
}

Material defaultMaterial(const Mesh& mesh) {
    Material material;
    if (!mesh.colors.empty()) material.diffuse = material.ambient = Vec3d(1);
    return material;
}

void addObject(Mesh mesh, const SourceText& source, std::string name, LoadedModel& model) {
    if (mesh.polygonCount() == 0) return;
    dropUnusedVertices(mesh);
    mesh.file = meshFileOf(source);
    Object& object = model.objects.emplace_back();
    object.name = std::move(name);
    settleColors(mesh.colors, source.name, model.remarks);
    object.material = defaultMaterial(mesh);
    object.mesh = makeMesh(std::move(mesh), source.progress.stop);
}

std::string shownName(std::string_view name, const std::string& otherwise) {
    return name.empty() || name.size() > kMaxWord || !isPrintable(name) ? otherwise : std::string(name);
}

}  // namespace pipeline
