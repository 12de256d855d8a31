#include <algorithm>
#include <filesystem>
#include <map>
#include <span>

#include "pipeline/formats/lecture/lecture_formats.h"
#include "pipeline/formats/lecture/lecture_values.h"
#include "pipeline/formats/object_names.h"
#include "pipeline/scene/mesh/make_mesh.h"

namespace pipeline {
namespace {

constexpr Countable kObjects{"object", "objects", 0, 65536, 10};
constexpr Countable kLights{"light source", "light sources", 0, 4096, 4};

// In the order of the file.
constexpr std::string_view kCameraKeys[] = {"camera.distance", "camera.rho", "camera.theta", "camera.phi"};
constexpr std::string_view kTransformKeys[] = {"object.#.sx", "object.#.sy", "object.#.sz",
                                               "object.#.rx", "object.#.ry", "object.#.rz",
                                               "object.#.tx", "object.#.ty", "object.#.tz"};
constexpr std::string_view kLightKeys[] = {"light.#.x", "light.#.y", "light.#.z", "light.#.intensity"};
constexpr std::string_view kAmbientKeys[] = {"ambient.intensity"};

// Reads one scene; the object files that it names are read once each.
class LectureSceneReader {
public:
    LectureSceneReader(const SourceText& source, const FileLoader& load)
        : m_source(source), m_load(load), m_scanner(source.text, source.name, m_errors) {}

    Result<Scene> read() {
        readAll();
        if (m_errors.empty()) checkSize();
        if (m_errors.empty()) m_errors = m_places.placed(checkScene(m_scene));
        if (!m_errors.empty()) return m_errors;
        tellApart(m_scene.objects);
        return std::move(m_scene);
    }

private:
    struct KnownObject {
        std::shared_ptr<const Mesh> mesh;  // null when the file is no good
        Material material;
    };

    // Leaves where the rest of the file cannot be made sense of.
    void readAll() {
        readSettings(m_scanner, kCameraKeys, m_scene, 0, &m_places);
        const std::optional<std::size_t> objects = readCount(m_scanner, kObjects);
        for (std::size_t i = 0; objects && i < *objects && m_scanner.good(); ++i)
            if (!readObject()) return;
        if (!objects || !m_scanner.good()) return;
        const std::optional<std::size_t> lights = readCount(m_scanner, kLights);
        for (std::size_t k = 0; lights && k < *lights && m_scanner.good(); ++k) {
            m_scene.lights.emplace_back();
            readSettings(m_scanner, kLightKeys, m_scene, k, &m_places);
        }
        if (!lights || !m_scanner.good()) return;
        readSettings(m_scanner, kAmbientKeys, m_scene, 0, &m_places);
        expectEnd(m_scanner);
    }

    bool readObject() {
        const std::string_view name = m_scanner.next();
        // A number here means that words are missing, or that fewer objects follow than announced.
        if (name.empty() || name.size() > kMaxWord || parseNumber(name)) {
            m_scanner.refuse("the file name of object " + std::to_string(m_scene.objects.size()));
            return false;
        }
        m_places.add("object." + std::to_string(m_scene.objects.size()), m_scanner.where());
        const KnownObject& known = objectFile(std::string(name));
        Object& object = m_scene.objects.emplace_back();
        object.name = std::filesystem::path(name).stem().string();
        object.mesh = known.mesh;
        object.material = known.material;
        readSettings(m_scanner, kTransformKeys, m_scene, m_scene.objects.size() - 1);
        return true;
    }

    const KnownObject& objectFile(const std::string& name) {
        const auto [entry, isNew] = m_known.try_emplace(std::filesystem::path(name).lexically_normal().string());
        if (!isNew) return entry->second;
        Result<NamedFile> file = m_load(name);
        if (!file) {
            for (const Error& error : file.errors()) m_scanner.fail(error.found, error.expected);
            return entry->second;
        }
        const Result<std::string> text = wholeText({file->text, file->path, m_source.progress, file->tail});
        if (!text) {
            for (const Error& error : text.errors()) m_scanner.fail(error.found, error.expected);
            return entry->second;
        }
        const std::size_t before = m_errors.size();
        ObjectDescription description = readObjectDescription({*text, file->path, m_source.progress}, m_errors);
        if (m_errors.size() > before || !m_scanner.good()) return entry->second;
        description.mesh.file = name;
        entry->second = {makeMesh(std::move(description.mesh), m_source.progress.stop), description.material};
        return entry->second;
    }

    // A small file may use a large object many times.
    void checkSize() {
        std::size_t vertices = 0, triangles = 0;
        for (const Object& object : m_scene.objects) {
            vertices += object.mesh->positions.size();
            triangles += object.mesh->triangles.size();
        }
        if (vertices <= kMaxVertices && triangles <= kMaxTriangles) return;
        Error& error = m_errors.emplace_back();
        error.where.file = m_source.name;
        error.found = "all objects together have " + groupedDigits(vertices) + " vertices and " +
                      groupedDigits(triangles) + " triangles";
        error.expected = "at most " + groupedDigits(kMaxVertices) + " of each";
    }

    const SourceText& m_source;
    const FileLoader& m_load;
    Errors m_errors;
    TextScanner m_scanner;
    Scene m_scene;
    KeyPlaces m_places;
    std::map<std::string, KnownObject> m_known;
};

}  // namespace

Result<Scene> readLectureScene(const SourceText& source, const FileLoader& load) {
    return LectureSceneReader(source, load).read();
}

bool looksLikeLectureScene(std::string_view start) {
    const std::vector<std::string_view> words = firstWords(start, 6);
    const auto isNumber = [](std::string_view word) { return parseNumber(word).has_value(); };
    const std::span<const std::string_view> camera = std::span(words).first(std::min(words.size(), std::size_t{4}));
    if (words.empty() || !std::ranges::all_of(camera, isNumber)) return false;
    if (words.size() < 5) return true;  // as far as it goes
    const std::optional<std::uint64_t> objects = parseCount(words[4]);
    // The first object's file follows, or, without objects, the number of lights.
    return objects && (words.size() == 5 || isNumber(words[5]) == (*objects == 0));
}

}  // namespace pipeline
