#include "pipeline/formats/toml/toml_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <set>

#include "pipeline/core/text.h"
#include "pipeline/formats/lecture/lecture_formats.h"
#include "pipeline/formats/lecture/lecture_values.h"
#include "pipeline/formats/model_reader.h"
#include "pipeline/formats/object_names.h"
#include "pipeline/formats/text/read_budget.h"
#include "pipeline/formats/toml/toml_mesh.h"
#include "pipeline/formats/toml/toml_text.h"
#include "pipeline/formats/toml/toml_values.h"
#include "pipeline/formats/toml/toml_vectors.h"
#include "pipeline/scene/key_places.h"
#include "pipeline/scene/mesh/make_mesh.h"

namespace pipeline {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxObjects = 65536, kMaxLights = 4096;
constexpr double kMaxFactor = 1e9;  // of attenuation, as other intensities

constexpr std::array<std::string_view, 4> kTopKeys{"title", "look", "light", "object"};
constexpr std::array<std::string_view, 1> kTomlLightKeys{"attenuation"};
constexpr std::array<std::string_view, 11> kObjectKeys{"name",     "shape",    "mesh",         "model",
                                                       "vertices", "polygons", "normals",      "colors",
                                                       "turns",    "material", "back_material"};

// Stands for a component that the file has not given.
constexpr double kNotGiven = std::numeric_limits<double>::quiet_NaN();
void fillIn(Vec3d& value, Vec3d with) {
    for (int k = 0; k < 3; ++k)
        if (std::isnan(value[k])) value[k] = with[k];
}

class TomlSceneReader {
public:
    TomlSceneReader(const SourceText& source, const FileLoader& load)
        : m_source(source), m_load(load), m_values(source.name), m_check(source.progress.stop) {
        m_budget.addRead(source.text.size());
    }

    Result<Scene> read(const toml::table& top) {
        readTable(top, "", 0, kTopKeys);
        if (const toml::node* node = top.get("title")) m_scene.name = m_values.name(*node, "title").value_or("");
        if (const toml::node* node = top.get("look")) m_scene.look = m_values.text(*node, "look").value_or("");
        if (const toml::node* node = top.get("light"))
            for (const toml::table* light : m_values.tables(*node, "light", kMaxLights)) readLight(*light);
        if (const toml::node* node = top.get("object"))
            if (const auto objects = m_values.tables(*node, "object", kMaxObjects); haveRoomForShapes(objects))
                for (const toml::table* object : objects)
                    if (m_values.full() || m_check.stopped() || !readObject(*object)) break;
        if (Errors errors = m_values.errors(); !errors.empty()) return errors;
        m_values.add(m_places.placed(checkScene(m_scene)));
        if (Errors errors = m_values.errors(); !errors.empty()) return errors;
        tellApart(m_scene.objects);
        return std::move(m_scene);
    }

private:
    // The settings and vectors of one table; `others` are read by the caller. `named`: the prefix in messages.
    void readTable(const toml::table& table, const std::string& prefix, std::size_t index,
                   std::span<const std::string_view> others, std::string named = {}) {
        if (named.empty()) named = prefix;
        if (!prefix.empty())
            m_places.add(shown(named.substr(0, named.size() - 1), index), m_values.place(table.source()));
        for (const auto& [keyAt, nodeAt] : inFileOrder(table)) {
            if (m_values.full() || m_check.stopped()) return;
            const toml::key& key = *keyAt;
            const toml::node& node = *nodeAt;
            const std::string_view name = key.str();
            if (std::ranges::find(others, name) != others.end()) continue;
            const std::string wanted = prefix + std::string(name);
            const std::string path = shown(named + std::string(name), index);
            const auto rows = settingsTable();
            const auto vector =
                std::ranges::find_if(kVectors, [&](const VectorKey& v) { return v.prefix == prefix && v.key == name; });
            const auto row = std::ranges::find(rows, std::string_view(wanted), &Setting::key);
            m_places.add(vector == kVectors.end() ? path : shown(std::string(vector->first), index),
                         m_values.place(node.source()));
            if (vector != kVectors.end())
                readVector(node, path, *vector, index);
            else if (row != rows.end())
                readSetting(node, path, *row, index);
            else if (prefix.empty() && isGroup(wanted)) {
                if (const toml::table* group = m_values.table(node, path)) readTable(*group, wanted + '.', 0, {});
            } else
                m_values.unknown(key, path, knownKeys(prefix, others));
        }
    }

    void readSetting(const toml::node& node, const std::string& path, const Setting& row, std::size_t index) {
        if (const std::string_view absent = row.absent(m_scene, index); !absent.empty())
            m_values.fail(node.source(), fmt::format("no key {}: {}", inQuotes(path), absent));
        else
            m_values.setting(node, path, row, m_scene, index);
    }

    void readVector(const toml::node& node, const std::string& path, const VectorKey& vector, std::size_t index) {
        const Setting& range = settingRow(vector.first);
        Vec3d& parts = vector.parts(m_scene, index);
        if (vector.isColor && !node.is_array()) {
            if (const auto grey = m_values.number(node, path, range.min, range.max)) parts = Vec3d(*grey);
        } else if (const auto values = m_values.numbers(node, path, 3, range.min, range.max)) {
            parts = {(*values)[0], (*values)[1], (*values)[2]};
        }
    }

    void readLight(const toml::table& table) {
        const std::size_t index = m_scene.lights.size();
        m_scene.lights.emplace_back().gl.specular = Vec3d(kNotGiven);
        readTable(table, "light.#.", index, kTomlLightKeys);
        Light& light = m_scene.lights[index];
        fillIn(light.gl.specular, light.color);
        const auto path = [&](std::string_view key) { return fmt::format("light.{}.{}", index, key); };
        if (const toml::node* node = table.get("attenuation"))
            if (const auto c = m_values.numbers(*node, path("attenuation"), 3, 0, kMaxFactor))
                light.gl.constant = (*c)[0], light.gl.linear = (*c)[1], light.gl.quadratic = (*c)[2];
    }

    // Counts the shapes before the first of them is built. Equal ones are one mesh, but each counts in the scene.
    bool haveRoomForShapes(const std::vector<const toml::table*>& objects) {
        std::size_t vertices = 0, triangles = 0;
        std::set<std::pair<ShapeKind, int>> built;
        for (const toml::table* object : objects) {
            const std::optional<Shape> shape = tomlShape(*object);
            if (!shape) continue;
            vertices += mostVerticesOf(*shape), triangles += mostTrianglesOf(*shape);
            if (vertices > kMaxVertices || triangles > kMaxTriangles) return refuseTooMany(*object);
            if (!built.emplace(shape->kind, shape->tessellation).second || m_budget.mayBuild(mostVerticesOf(*shape)))
                continue;
            m_values.fail(
                object->source(),
                fmt::format("the different shapes up to this one have {} vertices", groupedDigits(m_budget.built())),
                fmt::format("at most {} in a file of this size: less tessellation", groupedDigits(m_budget.most())));
            return false;
        }
        return true;
    }

    bool refuseTooMany(const toml::table& object) {
        m_values.fail(object.source(), "all objects up to this one have too many vertices or triangles",
                      fmt::format("at most {} of each", groupedDigits(kMaxVertices)));
        return false;
    }

    // Whether there is room for more.
    bool readObject(const toml::table& table) {
        const std::size_t first = m_scene.objects.size();
        const std::string path = fmt::format("object.{}", first);
        addObjects(table, path);
        for (std::size_t i = first; i < m_scene.objects.size(); ++i) {
            readTable(table, "object.#.", i, kObjectKeys);
            m_places.add(fmt::format("material.{}", i), m_values.place(table.source()));  // of a mesh's or model's file
            Object& object = m_scene.objects[i];
            if (object.shape) object.mesh = shapeMesh(*object.shape);
            if (const toml::node* node = table.get("name"))
                object.name = m_values.name(*node, path + ".name").value_or("");
            if (object.name.empty()) object.name = fmt::format("object {}", i);
            if (const toml::node* node = table.get("turns")) readTurns(*node, path + ".turns", object.transform);
            if (const toml::node* node = table.get("material")) readMaterial(*node, path + ".material", i);
            if (const toml::node* node = table.get("back_material")) {
                const Material front = m_scene.objects[i].material;
                readMaterial(*node, path + ".back_material", i, "back_material.#.");
                m_scene.objects[i].backMaterial = std::exchange(m_scene.objects[i].material, front);
            }
            m_vertices += m_scene.objects[i].mesh->positions.size();
            m_triangles += m_scene.objects[i].mesh->triangles.size();
        }
        if (m_scene.objects.size() > kMaxObjects) {
            m_values.fail(table.source(), "too many objects up to this one, those of models counted",
                          fmt::format("at most {}", groupedDigits(kMaxObjects)));
            return false;
        }
        return (m_vertices <= kMaxVertices && m_triangles <= kMaxTriangles) || refuseTooMany(table);
    }

    // One object, or those of a model.
    void addObjects(const toml::table& table, const std::string& path) {
        const toml::node* shape = table.get("shape");
        const toml::node* mesh = table.get("mesh");
        const toml::node* model = table.get("model");
        const bool inPlace = table.contains("vertices") || table.contains("polygons") || table.contains("normals") ||
                             table.contains("colors");
        if ((shape ? 1 : 0) + (mesh ? 1 : 0) + (model ? 1 : 0) + (inPlace ? 1 : 0) != 1)
            m_values.fail(table.source(),
                          fmt::format("{} has none or several of shape, mesh, model and vertices", path),
                          "one of them");
        else if (model)
            addModel(*model, path + ".model");
        if (model) return;
        Object& object = m_scene.objects.emplace_back();
        object.mesh = std::make_shared<const Mesh>();
        if (shape) {
            std::vector<std::string_view> kinds;
            for (std::size_t k = 0; k < kShapeCount; ++k) kinds.push_back(name(static_cast<ShapeKind>(k)));
            // Where there is no such shape, the file is refused; whatever else is said of it is read all the same.
            const std::size_t kind = m_values.choice(*shape, path + ".shape", kinds).value_or(0);
            object.name = kinds[kind];
            object.shape = tomlShape(table).value_or(Shape{static_cast<ShapeKind>(kind)});
        } else if (mesh) {
            readMesh(*mesh, path + ".mesh", object);
        } else if (inPlace) {
            if (auto own = readTomlMesh(table, path, m_values, m_source.progress.stop))
                object.mesh = makeMesh(*std::move(own), m_source.progress.stop);
        }
    }

    // Files that are named again, by whatever way, are read once.
    static std::string normal(const std::string& file) { return fs::path(file).lexically_normal().string(); }

    void readMesh(const toml::node& node, const std::string& path, Object& object) {
        const auto file = m_values.text(node, path);
        if (!file) return;
        const auto [known, isNew] = m_meshes.try_emplace(normal(*file));
        if (isNew) readMeshFile(node, *file, known->second);
        if (!known->second.mesh) return;
        object.name = fs::path(*file).stem().string();
        object.mesh = known->second.mesh;
        object.material = known->second.material;
    }

    void readMeshFile(const toml::node& node, const std::string& file, Object& object) {
        const auto loaded = load(node, file);
        if (!loaded) return;
        const Result<std::string> text = wholeText({loaded->text, loaded->path, m_source.progress, loaded->tail});
        if (!text) return m_values.add(text.errors());
        Errors errors;
        ObjectDescription description = readObjectDescription({*text, loaded->path, m_source.progress}, errors);
        m_values.add(namedAt(m_values.place(node.source()), errors));
        if (!errors.empty()) return;
        description.mesh.file = file;
        object.mesh = makeMesh(std::move(description.mesh), m_source.progress.stop);
        object.material = description.material;
    }

    void addModel(const toml::node& node, const std::string& path) {
        const auto file = m_values.text(node, path);
        if (!file) return;
        const auto [known, isNew] = m_models.try_emplace(normal(*file));
        if (isNew) readModelFile(node, path, *file, known->second);
        std::ranges::copy(known->second, std::back_inserter(m_scene.objects));
    }

    void readModelFile(const toml::node& node, const std::string& path, const std::string& file,
                       std::vector<Object>& objects) {
        const auto loaded = load(node, file);
        if (!loaded) return;
        const std::string extension = fs::path(file).extension().string();
        if (!isModel(extension)) return m_values.refuse(node, path, "a model, such as an .obj file");
        // What a model names stands beside the model.
        const FileLoader beside = [&, folder = fs::path(file).parent_path()](std::string_view name) {
            return m_load((folder / name).string());
        };
        const Result<LoadedModel> model =
            readModel({loaded->text, loaded->path, m_source.progress, loaded->tail, file}, extension, beside);
        if (!model) return m_values.add(namedAt(m_values.place(node.source()), model.errors()));
        objects = model->objects;
        std::ranges::copy(model->remarks, std::back_inserter(m_scene.remarks));
    }

    std::optional<NamedFile> load(const toml::node& node, const std::string& file) {
        Result<NamedFile> loaded = m_load(file);
        if (loaded) return std::move(loaded).value();
        for (const Error& error : loaded.errors()) m_values.fail(node.source(), error.found, error.expected);
        return {};
    }

    void readTurns(const toml::node& node, const std::string& path, ObjectTransform& transform) {
        const Setting& angles = settingRow("object.#.rx");
        const toml::array* turns = node.as_array();
        if (!turns) return m_values.refuse(node, path, "an array of turns [angle, x, y, z]");
        transform.turns.clear();
        for (const toml::node& turn : *turns) {
            const auto v = m_values.numbers(turn, path, 4, angles.min, angles.max);
            if (!v) continue;
            const Vec3d axis{(*v)[1], (*v)[2], (*v)[3]};
            if (axis == Vec3d(0.0)) m_values.fail(turn.source(), "the axis of a turn is (0, 0, 0)", "a direction");
            transform.turns.push_back({(*v)[0], axis});
        }
    }

    void readMaterial(const toml::node& node, const std::string& path, std::size_t index,
                      const std::string& named = "material.#.") {
        const toml::table* table = m_values.table(node, path);
        if (!table) return;
        const Material before = m_scene.objects[index].material;
        m_scene.objects[index].material.ambient = Vec3d(kNotGiven);
        readTable(*table, "material.#.", index, {}, named);
        Material& material = m_scene.objects[index].material;
        fillIn(material.ambient, material.diffuse == before.diffuse ? before.ambient : material.diffuse);
    }

    std::shared_ptr<const Mesh> shapeMesh(const Shape& shape) {
        auto& mesh = m_shapes[{shape.kind, shape.tessellation}];
        if (!mesh) mesh = makeShape(shape, m_source.progress.stop);
        return mesh;
    }

    static std::string shown(std::string key, std::size_t index) {
        if (const auto hash = key.find('#'); hash != key.npos) key.replace(hash, 1, std::to_string(index));
        return key;
    }

    static bool isGroup(const std::string& name) {
        return std::ranges::any_of(settingsTable(), [&](const Setting& row) {
            return row.key.starts_with(name + '.') && row.key.find('#') == row.key.npos;
        });
    }

    static std::vector<std::string> knownKeys(const std::string& prefix, std::span<const std::string_view> others) {
        std::vector<std::string> keys(others.begin(), others.end());
        for (const VectorKey& vector : kVectors)
            if (vector.prefix == prefix) keys.emplace_back(vector.key);
        for (const Setting& row : settingsTable()) {
            if (!row.key.starts_with(prefix)) continue;
            const std::string rest(row.key.substr(prefix.size()));
            const std::string key = prefix.empty() ? rest.substr(0, rest.find('.')) : rest;
            const bool isNew = std::ranges::find(keys, key) == keys.end();  // a table holds several
            if (isNew && rest.find('#') == rest.npos) keys.push_back(key);
        }
        return keys;
    }

    const SourceText& m_source;
    const FileLoader& m_load;
    TomlValues m_values;
    KeyPlaces m_places;
    Scene m_scene;
    std::size_t m_vertices = 0, m_triangles = 0;
    StopCheck m_check;
    ReadBudget m_budget;
    std::map<std::pair<ShapeKind, int>, std::shared_ptr<const Mesh>> m_shapes;
    std::map<std::string, Object> m_meshes;               // by file; without a mesh where it is no good
    std::map<std::string, std::vector<Object>> m_models;  // by file
};

}  // namespace

Result<Scene> readTomlScene(const SourceText& source, const FileLoader& load) {
    const auto table = parseToml(source);
    if (!table) return table.errors();
    return TomlSceneReader(source, load).read(*table);
}

bool looksLikeTomlScene(std::string_view start) {
    if (start.starts_with("\xef\xbb\xbf")) start.remove_prefix(3);
    while (!start.empty()) {
        const std::size_t end = std::min(start.find('\n'), start.size());
        std::string_view line = start.substr(0, end);
        start.remove_prefix(std::min(end + 1, start.size()));
        const std::size_t first = line.find_first_not_of(" \t\r");
        if (first == line.npos || line[first] == '#') continue;
        line.remove_prefix(first);
        if (line[0] == '[') return true;
        const auto isKey = [](char c) {
            return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' ||
                   c == '.';
        };
        const auto keyEnd = std::ranges::find_if_not(line, isKey);
        const std::size_t length = static_cast<std::size_t>(keyEnd - line.begin());
        const std::size_t next = line.find_first_not_of(" \t", length);
        return length > 0 && next != line.npos && line[next] == '=';
    }
    return false;
}

SceneTitle readTomlTitle(std::string_view text) {
    if (strayCharacter(text) || deepKey(text)) return {};
    const toml::parse_result parsed = toml::parse(text);
    if (!parsed) return {};
    return {parsed.table()["title"].value_or(std::string()), parsed.table()["look"].value_or(std::string())};
}

}  // namespace pipeline
