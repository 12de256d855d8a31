#include "pipeline/scene/vertex_settings.h"

#include <array>
#include <charconv>
#include <optional>

#include <fmt/format.h>

#include "pipeline/core/index_words.h"
#include "pipeline/core/text.h"
#include "pipeline/scene/settings_choices.h"
#include "pipeline/scene/settings_rows.h"

namespace pipeline {

namespace {

using namespace settings_choices;

// One number holds object and vertex.
constexpr std::size_t kVertexBits = 20, kMostVertices = std::size_t(1) << kVertexBits;
VertexOfObject parted(std::size_t index) { return {index >> kVertexBits, index % kMostVertices}; }

template <int axis>
constexpr Setting vertexRow(std::string_view key, std::string_view label) {
    Setting setting = settings_rows::component<settings_rows::OfObject, &ObjectTransform::translation, axis>(
        {key, label, "object units", "Position of a vertex, before the object is scaled, rotated and moved."}, kPlace);
    setting.count = [](const Scene& scene) { return scene.objects.size() << kVertexBits; };
    setting.get = [](const Scene& scene, std::size_t index) {
        const auto [object, vertex] = parted(index);
        return scene.objects[object].mesh->positions[vertex][axis];
    };
    setting.set = [](Scene& scene, std::size_t index, double value) {
        const auto [object, vertex] = parted(index);
        Object& of = scene.objects[object];
        Vec3d position = of.mesh->positions[vertex];
        if (position[axis] == value) return;
        position[axis] = value;
        Mesh mesh = *of.mesh;
        mesh.positions.set(vertex, position);
        mesh.file.clear(), mesh.polygonPlaces.clear();
        of.mesh = makeMesh(std::move(mesh)), of.shape.reset();
    };
    return setting;
}
constexpr auto kRows =
    std::to_array<Setting>({vertexRow<0>("vertex.#.x", "Vertex x"), vertexRow<1>("vertex.#.y", "Vertex y"),
                            vertexRow<2>("vertex.#.z", "Vertex z")});

// A number with a dot after it, which is dropped then.
bool takeNumber(std::string_view& text, std::size_t& number) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end == text.data() + text.size() || *end != '.') return false;
    text.remove_prefix(std::size_t(end - text.data()) + 1);
    return true;
}

}  // namespace

Result<SettingRef> findVertexSetting(const Scene& scene, std::string_view key) {
    std::string_view rest = key.substr(kVertexPrefix.size());
    VertexOfObject of;
    const std::string found = "no setting " + inQuotes(key);
    const bool isKey = takeNumber(rest, of.object) && takeNumber(rest, of.vertex) && rest.size() == 1;
    if (!isKey || rest[0] < 'x' || rest[0] > 'z') return Error{{}, found, "vertex.OBJECT.NUMBER.x, y or z"};
    const std::size_t objects = scene.objects.size();
    if (of.object >= objects) return Error{{}, found, "object " + indexWords(objects, "")};
    const std::size_t vertices = std::min(scene.objects[of.object].mesh->positions.size(), kMostVertices);
    if (vertices == 0) return Error{{}, fmt::format("{}: object {} has no vertices", found, of.object), {}};
    if (of.vertex >= vertices)
        return Error{{}, found, fmt::format("vertex {} of object {}", indexWords(vertices, ""), of.object)};
    return SettingRef{&kRows[std::size_t(rest[0] - 'x')], of.object << kVertexBits | of.vertex};
}

std::optional<VertexOfObject> vertexOf(const SettingRef& ref) {
    const bool isOne = ref.setting >= kRows.data() && ref.setting < kRows.data() + kRows.size();
    return isOne ? std::optional(parted(ref.index)) : std::nullopt;
}

}  // namespace pipeline
