#include "pipeline/formats/toml/toml_mesh.h"

#include <fmt/format.h>

#include "pipeline/core/text.h"
#include "pipeline/formats/lecture/lecture_values.h"

namespace pipeline {
namespace {

class TomlMeshReader {
public:
    TomlMeshReader(const toml::table& object, const std::string& path, TomlValues& values, const Stop& stop)
        : m_object(object), m_path(path), m_values(values), m_check(stop) {}

    std::optional<Mesh> read() {
        const toml::array* vertices = rows("vertices");
        const toml::array* polygons = rows("polygons");
        if (!vertices || !polygons) return {};
        readVectors(*vertices, "vertices", m_mesh.positions);
        const bool hasVertices = !m_wrong;
        for (const auto& [key, of] : {std::pair{"normals", &m_mesh.normals}, {"colors", &m_mesh.colors}}) {
            if (!m_object.contains(key)) continue;
            const toml::array* each = rows(key);
            if (!each) return {};
            readVectors(*each, key, *of);
            if (each->size() != vertices->size())
                fail(*each, fmt::format("{} {} for {} vertices", each->size(), key, vertices->size()), "one a vertex");
        }
        if (hasVertices) readPolygons(*polygons);  // of which those that could not be read are no news
        if (m_wrong) return {};
        return std::move(m_mesh);
    }

private:
    void fail(const toml::node& node, std::string found, std::string expected) {
        m_values.fail(node.source(), std::move(found), std::move(expected));
        m_wrong = true;
    }

    const toml::array* rows(std::string_view key) {
        const toml::node* node = m_object.get(key);
        if (!node) {
            fail(m_object, fmt::format("{} has no {}", m_path, key), "vertices and polygons");
            return nullptr;
        }
        const toml::array* array = node->as_array();
        if (!array) fail(*node, fmt::format("{}.{} is no array", m_path, key), "an array of arrays");
        if (array && array->size() > kMaxVertices)
            fail(*node, fmt::format("{}.{} has {} entries", m_path, key, groupedDigits(array->size())),
                 fmt::format("at most {}", groupedDigits(kMaxVertices)));
        return m_wrong ? nullptr : array;
    }

    void readVectors(const toml::array& from, std::string_view key, VertexVectors& to) {
        const Setting& range = settingRow(key == "colors" ? "material.#.kr" : "object.#.tx");
        const double least = key == "colors" ? 0 : range.min;
        for (const toml::node& node : from) {
            if (m_check.stopped(3)) return;
            const auto v = m_values.numbers(node, fmt::format("{}.{}", m_path, key), 3, least, range.max);
            if (!v) m_wrong = true;
            if (m_wrong) return;
            to.push_back({(*v)[0], (*v)[1], (*v)[2]});
        }
    }

    void readPolygons(const toml::array& from) {
        const auto count = std::int64_t(m_mesh.positions.size());
        std::vector<std::uint32_t> polygon;
        for (const toml::node& node : from) {
            const toml::array* corners = node.as_array();
            if (!corners || corners->size() < 3)
                return fail(node, "a polygon is no array of three numbers or more", "indices of vertices");
            if (m_check.stopped(corners->size())) return;
            polygon.clear();
            for (const toml::node& corner : *corners) {
                const auto* index = corner.as_integer();
                if (!index || index->get() < 0 || index->get() >= count) {
                    m_values.refuse(corner, "a polygon's vertex",
                                    count > 0 ? fmt::format("a whole number from 0 to {}", count - 1) : "a vertex");
                    m_wrong = true;
                    return;
                }
                polygon.push_back(std::uint32_t(index->get()));
            }
            m_mesh.addPolygon(polygon);
            const auto at = node.source().begin;
            m_mesh.polygonPlaces.push_back({int(at.line), int(at.column)});
        }
    }

    const toml::table& m_object;
    const std::string& m_path;
    TomlValues& m_values;
    StopCheck m_check;
    Mesh m_mesh;
    bool m_wrong = false;
};

}  // namespace

std::optional<Shape> tomlShape(const toml::table& object) {
    const auto* named = object["shape"].as_string();
    if (!named) return {};
    for (std::size_t k = 0; k < kShapeCount; ++k) {
        Shape shape{static_cast<ShapeKind>(k)};
        if (name(shape.kind) != named->get()) continue;
        const Setting& row = settingRow("object.#.tessellation");
        if (const auto* pieces = object["tessellation"].as_integer();
            pieces && double(pieces->get()) >= row.min && double(pieces->get()) <= row.max)
            shape.tessellation = static_cast<int>(pieces->get());
        return shape;
    }
    return {};
}

std::optional<Mesh> readTomlMesh(const toml::table& object, const std::string& path, TomlValues& values,
                                 const Stop& stop) {
    return TomlMeshReader(object, path, values, stop).read();
}

}  // namespace pipeline
