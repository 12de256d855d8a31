#include "pipeline/formats/toml/toml_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "pipeline/core/text.h"
#include "pipeline/formats/text/text_scanner.h"
#include "pipeline/formats/toml/toml_scene.h"
#include "pipeline/formats/toml/toml_values.h"
#include "pipeline/formats/toml/toml_vectors.h"

namespace pipeline {
namespace {

class TomlWriter {
public:
    // Every object has its own up axis, and what is written is no model by itself.
    explicit TomlWriter(const Scene& scene) : m_scene(scene) { m_scene.framed = false; }

    Result<std::string> write() {
        if (!m_scene.name.empty()) line("title", tomlString(m_scene.name));
        if (!m_scene.look.empty()) line("look", tomlString(m_scene.look));
        m_known.lights.assign(m_scene.lights.size(), Light());
        for (const Object& object : m_scene.objects) {
            Object& known = m_known.objects.emplace_back();
            known.mesh = object.mesh;
            if (object.shape) known.shape = Shape{object.shape->kind};
        }
        settings("", 0);
        table("[camera]", "camera.", 0);
        // One that is given stays given, also where it is what the model has by itself.
        if (m_scene.ambient.intensity) m_known.ambient.intensity = std::numeric_limits<double>::quiet_NaN();
        table("[ambient]", "ambient.", 0);
        for (std::size_t k = 0; k < m_scene.lights.size(); ++k) table("[[light]]", "light.#.", k, true);
        for (std::size_t i = 0; i < m_scene.objects.size() && m_text.size() <= kMaxTomlBytes; ++i) object(i);
        if (m_text.size() > kMaxTomlBytes)
            return Error{{},
                         "the scene is too large to be written as text",
                         fmt::format("at most {} bytes of vertices and polygons", groupedDigits(kMaxTomlBytes))};
        return std::move(m_text);
    }

private:
    void line(std::string_view key, const std::string& value) { m_text += fmt::format("{} = {}\n", key, value); }

    static std::string vectorText(Vec3d v) {
        return fmt::format("[{}, {}, {}]", tomlNumber(v.x), tomlNumber(v.y), tomlNumber(v.z));
    }
    static bool same(Vec3d a, Vec3d b) {
        for (int i = 0; i < 3; ++i)
            if (a[i] != b[i] || std::signbit(a[i]) != std::signbit(b[i])) return false;
        return true;
    }

    // What the reader would not know by itself of one table; m_known is what it knows so far.
    void settings(const std::string& prefix, std::size_t index) {
        for (const VectorKey& vector : kVectors) {
            if (vector.prefix != prefix) continue;
            const Vec3d value = vector.parts(m_scene, index);
            Vec3d& known = vector.parts(m_known, index);
            if (same(value, known)) continue;
            line(vector.key, vectorText(value));
            const Vec3d before = known;
            known = value;
            takeAlong(prefix, vector.key, index, before);
        }
        for (const Setting& row : settingsTable()) {
            if (!row.key.starts_with(prefix)) continue;
            const std::string_view key = row.key.substr(prefix.size());
            if (key.find('#') != key.npos || (prefix.empty() && isOfTable(key))) continue;
            if (!row.absent(m_scene, index).empty()) continue;
            const double value = row.get(m_scene, index), known = row.get(m_known, index);
            if (value == known && std::signbit(value) == std::signbit(known)) continue;
            line(key, settingText(row, value));
            row.set(m_known, index, value);
        }
    }

    // Camera and ambient light have tables of their own; "shadow.size" stands at the top as it is.
    static bool isOfTable(std::string_view key) { return key.starts_with("camera.") || key.starts_with("ambient."); }

    // What the reader takes from another value where a file has none of its own.
    void takeAlong(std::string_view prefix, std::string_view key, std::size_t index, Vec3d before) {
        if (prefix == "light.#." && key == "color") m_known.lights[index].gl.specular = m_known.lights[index].color;
        if (prefix != "material.#." || key != "diffuse") return;
        Material& known = m_known.objects[index].material;
        if (known.diffuse != before) known.ambient = known.diffuse;
    }

    static std::string settingText(const Setting& row, double value) {
        switch (row.kind) {
            case SettingKind::Choice: return tomlString(row.choices[std::size_t(value)]);
            case SettingKind::Switch: return value != 0 ? "true" : "false";
            case SettingKind::Integer: return fmt::format("{}", std::int64_t(value));
            case SettingKind::Number: break;
        }
        return tomlNumber(value);
    }

    // A table whose head stands there only where something does, or always.
    void table(std::string_view head, const std::string& prefix, std::size_t index, bool always = false) {
        const std::size_t before = m_text.size();
        m_text += fmt::format("\n{}\n", head);
        const std::size_t begin = m_text.size();
        settings(prefix, index);
        if (m_text.size() == begin && !always) m_text.resize(before);
    }

    void object(std::size_t i) {
        const Object& object = m_scene.objects[i];
        m_text += "\n[[object]]\n";
        line("name", tomlString(object.name));
        if (object.shape)
            line("shape", tomlString(name(object.shape->kind)));
        else
            mesh(*object.mesh);
        settings("object.#.", i);
        if (!object.transform.turns.empty()) {
            m_text += "turns = [";
            for (const AxisTurn& turn : object.transform.turns)
                m_text += fmt::format("[{}, {}, {}, {}], ", tomlNumber(turn.angle), tomlNumber(turn.axis.x),
                                      tomlNumber(turn.axis.y), tomlNumber(turn.axis.z));
            m_text += "]\n";
        }
        table("[object.material]", "material.#.", i);
        if (!object.backMaterial) return;
        // The reader lets the back begin as the front is.
        m_known.objects[i].material = object.material;
        m_scene.objects[i].material = *object.backMaterial;
        table("[object.back_material]", "material.#.", i, true);
    }

    void mesh(const Mesh& mesh) {
        const auto vectors = [&](std::string_view key, const VertexVectors& from) {
            m_text += fmt::format("{} = [\n", key);
            for (const Vec3d& v : from) {
                m_text += "  " + vectorText(v) + ",\n";
                if (m_text.size() > kMaxTomlBytes) return;
            }
            m_text += "]\n";
        };
        vectors("vertices", mesh.positions);
        if (!mesh.normals.empty()) vectors("normals", mesh.normals);
        if (!mesh.colors.empty()) vectors("colors", mesh.colors);
        m_text += "polygons = [\n";
        for (std::size_t p = 0; p < mesh.polygonCount() && m_text.size() <= kMaxTomlBytes; ++p)
            m_text += fmt::format("  [{}],\n", fmt::join(mesh.polygon(p), ", "));
        m_text += "]\n";
    }

    Scene m_scene;  // a copy: what the vectors' rows read is not const
    Scene m_known;
    std::string m_text;
};

}  // namespace

// As toml++ writes it.
std::string tomlString(std::string_view text) {
    std::ostringstream out;
    const toml::value<std::string> node(text);
    using enum toml::format_flags;
    out << toml::toml_formatter(
        node, toml::toml_formatter::default_flags & ~allow_literal_strings & ~allow_multi_line_strings);
    return out.str();
}

std::string tomlText(std::string_view text) {
    const auto plain = [](char c) {
        return c == '\n' || c == '\t' || (static_cast<unsigned char>(c) >= 0x20 && c != 0x7f);
    };
    const bool asItIs = text.find('\n') != text.npos && text.find("'''") == text.npos && !text.ends_with('\'') &&
                        std::ranges::all_of(text, plain);
    return asItIs ? fmt::format("'''\n{}'''", text) : tomlString(text);
}

// A whole number is an integer of TOML, which has no -0.
std::string tomlNumber(double value) { return value == 0 && std::signbit(value) ? "-0.0" : shortestText(value); }

Result<std::string> toTomlScene(const Scene& scene) { return TomlWriter(scene).write(); }

}  // namespace pipeline
