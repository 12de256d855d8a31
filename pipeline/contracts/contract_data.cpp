#include "pipeline/contracts/contract_data.h"

#include <algorithm>

#include "pipeline/illumination/illumination.h"
#include "pipeline/scene/opacity.h"

namespace pipeline {

ContractData::ContractData(const ContractInput& input, int light)
    : m_input(input),
      m_light(light),
      m_view(makeView(input.scene)),
      m_depthCode(m_view, input.scene.settings.depthFormat),
      m_iMax(maximumIntensity(input.scene)),
      m_translucent(!translucentSides(input.scene).empty()) {
    for (const ContractBuffer& buffer : input.buffers) {
        auto& lights = m_found[index(buffer.numbers.name.id)];
        const auto at = std::size_t(std::max(buffer.numbers.name.light, 0));
        lights.resize(std::max(lights.size(), at + 1), nullptr);
        lights[at] = &buffer.numbers;
    }
}

bool ContractData::hasArea(const Topology::Corners& corners) const {
    const Vec3d origin = vector(BufferId::VerticesWorld, corners[0]);
    Vec3d sum(0);
    for (std::size_t i = 2; i < corners.size(); ++i)
        sum += glm::cross(vector(BufferId::VerticesWorld, corners[i - 1]) - origin,
                          vector(BufferId::VerticesWorld, corners[i]) - origin);
    return sum != Vec3d(0);
}

std::vector<bool> ContractData::verticesWithArea() const {
    const bool byNormals = has(BufferId::PolygonsNormal);
    if (!byNormals && !has(BufferId::VerticesWorld)) return {};
    std::vector<bool> found(topology().vertexCount());
    for (std::size_t polygon = 0; polygon < topology().polygonCount(); ++polygon) {
        const Topology::Corners corners = topology().corners(polygon);
        if (!(byNormals ? vector(BufferId::PolygonsNormal, polygon) != Vec3d(0) : hasArea(corners))) continue;
        for (std::size_t i = 0; i < corners.size(); ++i) found[corners[i]] = true;
    }
    return found;
}

bool ContractData::drawn(std::size_t pixel) const {
    if (pixel < m_input.drawn.size()) return m_input.drawn[pixel];
    for (const BufferId id : {BufferId::PolygonId, BufferId::ObjectId})
        if (has(id)) return number(id, pixel) >= 0;
    return !has(BufferId::ZView) || std::isfinite(number(BufferId::ZView, pixel));
}

double ContractData::rounding(const Contract& contract) const {
    double most = 0;
    for (const ContractBuffer& buffer : m_input.buffers)
        if (std::ranges::find(contract.reads, buffer.numbers.name.id) != contract.reads.end())
            most = std::max(most, buffer.rounding);
    return most;
}

double roundingOf(const AnyBuffer& buffer) {
    if (std::holds_alternative<std::span<const float>>(buffer.data)) return 0x1p-24;
    return std::holds_alternative<std::span<const double>>(buffer.data) ? 0x1p-53 : 0;
}

std::string whyNotLit(const Scene& scene, std::size_t) {
    return scene.settings.visibility == Visibility::None ? "Outlines are not lit." : "";
}
std::string whyNotAtOnePoint(const Scene& scene, std::size_t k) {
    if (scene.settings.shading == Shading::Gouraud) return "Gouraud shading interpolates what vertices get.";
    return whyNotLit(scene, k);
}

std::span<const Contract> contractTable() {
    static const std::vector<Contract> all = [] {
        std::vector<Contract> rows;
        for (const auto& part : {geometryContracts(), drawingContracts(), vectorContracts(), termContracts()})
            rows.insert(rows.end(), part.begin(), part.end());
        return rows;
    }();
    return all;
}

const Contract* findContract(std::string_view id) {
    for (const Contract& contract : contractTable())
        if (contract.id == id) return &contract;
    return nullptr;
}

}  // namespace pipeline
