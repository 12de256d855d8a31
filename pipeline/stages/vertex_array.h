#pragma once
#include <algorithm>
#include <memory>
#include <span>

#include "pipeline/buffers/buffer2d.h"
#include "pipeline/scene/mesh/mesh.h"

namespace pipeline {

// What a stage leaves of every vertex: its own, or, where the stage would copy them, what the mesh has.
template <class Real>
class VertexArray {
public:
    using value_type = Vec3<Real>;

    std::size_t size() const { return all().size(); }
    bool empty() const { return size() == 0; }
    std::span<const Vec3<Real>> all() const { return m_mesh ? m_given : std::span<const Vec3<Real>>(m_own); }
    const Vec3<Real>& operator[](std::size_t vertex) const { return all()[vertex]; }
    auto begin() const { return all().begin(); }
    auto end() const { return all().end(); }
    bool areGiven() const { return m_mesh != nullptr; }
    bool operator==(const VertexArray& other) const { return std::ranges::equal(all(), other.all()); }  // by value

    // Those of the stage, to write to; none where they are given.
    std::span<Vec3<Real>> own() { return m_own; }
    void makeOwn(std::size_t count) { m_mesh.reset(), m_own.resize(count); }
    // given: of the mesh, which is kept with them.
    void give(std::shared_ptr<const Mesh> mesh, std::span<const Vec3<Real>> given) {
        m_own = {}, m_mesh = std::move(mesh), m_given = given;
    }

private:
    RawVector<Vec3<Real>> m_own;
    std::shared_ptr<const Mesh> m_mesh;
    std::span<const Vec3<Real>> m_given;
};

}  // namespace pipeline
