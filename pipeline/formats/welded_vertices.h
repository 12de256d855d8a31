#pragma once
#include <bit>
#include <cstdint>

#include <tsl/robin_set.h>

#include "pipeline/scene/mesh/mesh.h"

namespace pipeline {

// The vertices of a mesh while it is read, of which no two are equal: where a file gives every polygon its own corners, a
// closed surface becomes a closed mesh. -0 becomes 0. A set of the vertices' numbers beside the mesh, 10 to 20
// bytes each: to hold what makes them equal as well would take more memory than the mesh.
class WeldedVertices {
public:
    // byNormal, byColor: whether normals and colours tell vertices apart, which then have one.
    WeldedVertices(Mesh& mesh, bool byNormal, bool byColor = false)
        : m_of(setOf(Hash{{&mesh, byNormal, byColor}}, Equal{{&mesh, byNormal, byColor}})), m_mesh(mesh) {}

    void reserve(std::size_t vertices) {
        m_mesh.positions.reserve(vertices);
        if (m_of.hash_function().byNormal) m_mesh.normals.reserve(vertices);
        if (m_of.hash_function().byColor) m_mesh.colors.reserve(vertices);
        m_of.reserve(vertices);
    }
    // The number of the vertex that is there already, or is added. normal, color: of vertices that have one.
    std::uint32_t at(const Vec3d& position, const Vec3d& normal = Vec3d(0.0), const Vec3d& color = Vec3d(0.0)) {
        const Vertex vertex{position + 0.0, normal + 0.0, color + 0.0};
        const std::size_t hash = m_of.hash_function()(vertex);
        if (const auto found = m_of.find(vertex, hash); found != m_of.end()) return *found;
        const auto next = static_cast<std::uint32_t>(m_mesh.positions.size());
        m_mesh.positions.push_back(vertex.position);
        if (m_of.hash_function().byNormal) m_mesh.normals.push_back(vertex.normal);
        if (m_of.hash_function().byColor) m_mesh.colors.push_back(vertex.color);
        m_of.insert(next);
        return next;
    }
    // When the mesh is another one. A new set: to clear a large one takes as long each time as if it were full.
    void clear() { m_of = setOf(m_of.hash_function(), m_of.key_eq()); }

private:
    struct Vertex {
        Vec3d position, normal, color;
    };
    struct Reader {
        const Mesh* mesh;
        bool byNormal, byColor;
        Vertex operator()(std::uint32_t i) const {
            return {mesh->positions[i], byNormal ? mesh->normals[i] : Vec3d(0.0),
                    byColor ? mesh->colors[i] : Vec3d(0.0)};
        }
    };
    struct Hash : Reader {
        std::size_t operator()(const Vertex& vertex) const {
            std::uint64_t hash = 0;
            const auto mix = [&](double x) {
                hash = (std::rotl(hash, 23) ^ std::bit_cast<std::uint64_t>(x)) * 0x9E3779B97F4A7C15U;
            };
            for (int axis = 0; axis < 3; ++axis) mix(vertex.position[axis]);
            for (int axis = 0; byNormal && axis < 3; ++axis) mix(vertex.normal[axis]);
            for (int axis = 0; byColor && axis < 3; ++axis) mix(vertex.color[axis]);
            return hash ^ hash >> 32;
        }
        std::size_t operator()(std::uint32_t i) const { return (*this)(Reader::operator()(i)); }
    };
    struct Equal : Reader {
        using is_transparent = void;
        bool operator()(const Vertex& a, const Vertex& b) const {
            return a.position == b.position && a.normal == b.normal && a.color == b.color;
        }
        bool operator()(std::uint32_t a, std::uint32_t b) const { return a == b; }
        bool operator()(std::uint32_t a, const Vertex& b) const { return (*this)(Reader::operator()(a), b); }
        bool operator()(const Vertex& a, std::uint32_t b) const { return (*this)(a, Reader::operator()(b)); }
    };
    using Set = tsl::robin_set<std::uint32_t, Hash, Equal>;
    static Set setOf(const Hash& hash, const Equal& equal) {
        Set set(0, hash, equal);
        set.max_load_factor(0.8F);
        return set;
    }
    Set m_of;
    Mesh& m_mesh;
};

}  // namespace pipeline
