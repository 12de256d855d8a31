#pragma once
#include <algorithm>
#include <cmath>

#include "pipeline/contracts/contract.h"
#include "pipeline/scene/mesh/topology.h"
#include "pipeline/scene/view.h"
#include "pipeline/stages/depth.h"

namespace pipeline {

// What a contract's check reads: buffers by element, and what follows from the scene. Made once for a contract and light.
class ContractData {
public:
    ContractData(const ContractInput& input, int light);

    bool has(BufferId id) const { return find(id) != nullptr; }
    bool has(BufferId id, int light) const { return find(id, light) != nullptr; }
    double number(BufferId id, std::size_t i) const { return find(id)->flat(i); }
    Vec3d vector(BufferId id, std::size_t i) const { return at(*find(id), i); }
    Vec3d vector(BufferId id, int light, std::size_t i) const { return at(*find(id, light), i); }
    std::size_t count(BufferId id) const { return find(id)->count() / std::size_t(find(id)->channels()); }
    bool drawn(std::size_t pixel) const;  // as ContractInput::drawn says; true where nobody knows
    bool knowsDrawn() const {
        return !m_input.drawn.empty() || has(BufferId::PolygonId) || has(BufferId::ObjectId) || has(BufferId::ZView);
    }

    const Scene& scene() const { return m_input.scene; }
    const Topology& topology() const { return m_input.topology; }
    const View& view() const { return m_view; }
    const DepthCode& depthCode() const { return m_depthCode; }
    // Whether a polygon around the vertex has an area, by the normals of polygons or the places of vertices, whichever are
    // there; true where nobody knows.
    bool hasAreaAround(std::size_t vertex) const {
        if (!m_hasArea) m_hasArea = verticesWithArea();
        return vertex >= m_hasArea->size() || (*m_hasArea)[vertex];
    }
    bool hasArea(const Topology::Corners& corners) const;  // by the places of vertices, which are there
    double iMax() const { return m_iMax; }
    bool isTranslucent() const { return m_translucent; }  // some object lets through what is behind it
    int light() const { return m_light; }
    double rounding(const Contract& contract) const;  // of the least exact of what it reads
    double u() const { return m_u; }                  // the same, of the contract that is being checked
    void setRounding(double u) { m_u = u; }

private:
    const AnyBuffer* find(BufferId id, int light) const {
        const auto& lights = m_found[pipeline::index(id)];
        const auto at = std::size_t(std::max(light, 0));
        return at < lights.size() ? lights[at] : nullptr;
    }
    const AnyBuffer* find(BufferId id) const { return find(id, bufferInfo(id).perLight ? m_light : -1); }
    static Vec3d at(const AnyBuffer& buffer, std::size_t i) {
        return {buffer.flat(3 * i), buffer.flat(3 * i + 1), buffer.flat(3 * i + 2)};
    }

    std::vector<bool> verticesWithArea() const;

    const ContractInput& m_input;
    mutable std::optional<std::vector<bool>> m_hasArea;  // per vertex; found when the first asks
    int m_light;
    View m_view;
    DepthCode m_depthCode;
    double m_iMax = 0, m_u = 0;
    bool m_translucent = false;
    std::array<std::vector<const AnyBuffer*>, kBufferCount> m_found{};  // by light, at 0 where there is none
};

// Rows by stages; contract_table.cpp puts them in order.
std::span<const Contract> geometryContracts();
std::span<const Contract> drawingContracts();
std::span<const Contract> vectorContracts();
std::span<const Contract> termContracts();

// Why a scene has no light, and none at one point for each pixel; one sentence, or empty.
std::string whyNotLit(const Scene& scene, std::size_t k = 0);
std::string whyNotAtOnePoint(const Scene& scene, std::size_t k = 0);

// Checks that several rows have in common.
inline std::optional<ContractFinding> unitLength(const Vec3d& v, double bound) {
    const double length = glm::length(v);
    return ContractFinding{length, std::abs(length - 1), bound};
}
inline std::optional<ContractFinding> within(double value, double low, double high, double bound) {
    return ContractFinding{value, value < low ? low - value : value > high ? value - high : value - value, bound};
}
// A difference of two unit vectors, which is never above 2: rounding that may turn them by a third of that decides.
inline std::optional<ContractFinding> direction(const Vec3d& difference, double bound) {
    constexpr double kRoom = 2.0 / 3;
    const double length = glm::length(difference);
    return ContractFinding{length, length, bound, kRoom};
}
// value should be `expected`.
inline std::optional<ContractFinding> equals(double value, double expected, double bound) {
    return ContractFinding{value, value == expected ? 0 : std::abs(value - expected), bound};
}

}  // namespace pipeline
