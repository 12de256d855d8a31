// Shadow buffer and z-buffer.
#include <algorithm>

#include "pipeline/buffers/verdict.h"
#include "pipeline/contracts/contract_data.h"
#include "pipeline/scene/area_light.h"

namespace pipeline {
namespace {

using Found = std::optional<ContractFinding>;
using B = BufferId;

Found shadowDepth(const ContractData& data, std::size_t texel) {
    const double z = data.number(B::ShadowBuffer, texel);
    return ContractFinding{z, z > 0 ? 0 : std::abs(z - 0), 0};
}
std::string notOfPoint(const Scene& scene, std::size_t k) {
    return scene.lights[k].kind == LightKind::AtInfinity ? "A light at infinity has its origin anywhere." : "";
}

std::string notDrawnByDepth(const Scene& scene, std::size_t) {
    return scene.settings.visibility == Visibility::None ? "Outlines have no depth." : "";
}

// What a depth errs by: 1/z over the triangle's plane by 11 u, its reciprocal and its storage by u each.
double depthBound(const ContractData& data, double z) { return 13 * data.u() * std::abs(z); }

Found depthInRange(const ContractData& data, std::size_t pixel) {
    if (!data.drawn(pixel)) return {};
    const double z = data.number(B::ZView, pixel);
    return within(z, data.view().near, data.view().far, depthBound(data, z));
}

// Of what a pixel shows, if the polygon is one of the scene's.
std::optional<std::size_t> polygonAt(const ContractData& data, std::size_t pixel) {
    const double id = data.number(B::PolygonId, pixel);
    if (!(id >= 0) || !(id < double(data.topology().polygonCount()))) return {};
    return std::size_t(id);
}

// In the range of the polygon's vertices, whose places in view space differ from what is drawn by rounding.
Found depthOfPolygon(const ContractData& data, std::size_t pixel) {
    const auto polygon = polygonAt(data, pixel);
    if (!polygon) return {};
    const Topology::Corners corners = data.topology().corners(*polygon);
    double low = std::numeric_limits<double>::infinity(), high = -low, reach = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3d v = data.vector(B::VerticesView, corners[i]);
        low = std::min(low, v.z), high = std::max(high, v.z), reach = std::max(reach, glm::length(v));
    }
    const double z = data.number(B::ZView, pixel);
    return within(z, low, high, depthBound(data, z) + 16 * data.u() * (reach + 2 * glm::length(data.view().eye)));
}

Found depthAsStored(const ContractData& data, std::size_t pixel) {
    if (!data.drawn(pixel)) return {};
    const DepthCode& code = data.depthCode();
    const double z = data.number(B::ZView, pixel), stored = data.number(B::Depth, pixel);
    const double expected = code.encode(z, 1 / z);
    if (code.format == DepthFormat::Linear) return equals(stored, expected, depthBound(data, z));
    // d is affine in 1/z or in z: what z errs by, times the slope; and half a step of the format, 2^-24 of a float's 1.
    const double slope = std::abs(code.factor) * (code.perspective ? 1 / std::abs(z) : std::abs(z));
    const bool isHalf = code.format == DepthFormat::Half || code.format == DepthFormat::ReversedHalf;
    const double step = code.levels > 0 ? 1 / code.levels : isHalf ? 0x1p-11 : 0x1p-24;
    return equals(stored, expected, 13 * data.u() * slope + step);
}
std::string notStored(const Scene& scene, std::size_t) {
    return scene.settings.visibility != Visibility::ZBuffer ? "Only a z-buffer stores depths." : "";
}

Found sumOfWeights(const ContractData& data, std::size_t pixel) {
    if (!data.drawn(pixel)) return {};
    const Vec3d b = data.vector(B::Barycentric, pixel);
    return equals(b.x + b.y + b.z, 1, 3 * data.u());
}
Found weightsInRange(const ContractData& data, std::size_t pixel) {
    if (!data.drawn(pixel)) return {};
    const Vec3d b = data.vector(B::Barycentric, pixel);
    return within(std::min({b.x, b.y, b.z}), 0, 1, 40 * data.u());
}

// Over triangles alone: of other polygons the weights are those of one of their triangles.
Found depthOfWeights(const ContractData& data, std::size_t pixel) {
    const auto polygon = polygonAt(data, pixel);
    if (!polygon) return {};
    const Topology::Corners corners = data.topology().corners(*polygon);
    if (corners.size() != 3) return {};
    const Vec3d b = data.vector(B::Barycentric, pixel);
    double expected = 0, spread = 0, reach = 0;
    const double first = data.vector(B::VerticesView, corners[0]).z;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3d v = data.vector(B::VerticesView, corners[i]);
        expected += b[int(i)] * v.z, spread += std::abs(v.z - first), reach = std::max(reach, glm::length(v));
    }
    const double z = data.number(B::ZView, pixel), eye = glm::length(data.view().eye);
    return equals(z, expected, depthBound(data, z) + data.u() * (18 * spread + 16 * (reach + 2 * eye)));
}

Found writesOfFragments(const ContractData& data, std::size_t pixel) {
    const double writes = data.number(B::DepthWrites, pixel), arrived = data.number(B::Overdraw, pixel);
    return within(writes, arrived > 0 && data.drawn(pixel) ? 1 : 0, arrived, 0);
}

Found objectOfPolygon(const ContractData& data, std::size_t pixel) {
    const double object = data.number(B::ObjectId, pixel), id = data.number(B::PolygonId, pixel);
    if (!(id >= 0)) return object >= 0 ? equals(object, -1, 0) : Found{};
    const auto polygon = polygonAt(data, pixel);
    return equals(object, polygon ? double(data.topology().objectOfPolygon(*polygon)) : -1, 0);
}

Found seenIsKept(const ContractData& data, std::size_t pixel) {
    const auto polygon = polygonAt(data, pixel);
    if (!polygon) return {};
    const double verdict = data.number(B::PolygonsVerdict, *polygon);
    return ContractFinding{verdict, goesOn(Verdict(int(verdict))) ? 0.0 : 1.0, 0};
}

}  // namespace

std::span<const Contract> drawingContracts() {
    static const Contract kRows[]{
        Contract{"shadow-depths",
                 StageId::ShadowBuffer,
                 "Everything that a light sees is in front of it.",
                 "Z' > 0, or ∞",
                 {B::ShadowBuffer},
                 "light",
                 "world units",
                 "0 to ∞",
                 "0: what is behind the light is cut off",
                 "Lecture 2, shadow buffer",
                 shadowDepth,
                 notOfPoint},
        Contract{"depth-range",
                 StageId::ZBuffer,
                 "Everything drawn is between the near and the far plane: w > 0.",
                 "n ≤ z_view ≤ f",
                 {B::ZView},
                 "view",
                 "world units",
                 "n to f",
                 "13 u z: 1/z over the triangle's plane rounds by 11 u, its reciprocal and its storage by u each",
                 "Lecture 2, clipping",
                 depthInRange,
                 notDrawnByDepth},
        Contract{"depth-of-polygon",
                 StageId::ZBuffer,
                 "A depth is in the range of its polygon's vertices.",
                 "min z_i ≤ z_view ≤ max z_i",
                 {B::ZView, B::PolygonId, B::VerticesView},
                 "view",
                 "world units",
                 "the polygon's",
                 "13 u z + 16 u (|p| + 2 |E|): as a depth, and the vertices' own rounding",
                 "Lecture 2, z-buffer",
                 depthOfPolygon,
                 notDrawnByDepth},
        Contract{"stored-depth",
                 StageId::ZBuffer,
                 "The stored depth is z_view in the chosen format.",
                 "d = f/(f−n) − f n/((f−n) z)",
                 {B::Depth, B::ZView},
                 "screen",
                 "",
                 "0 to 1; z_view if linear",
                 "13 u |f n/((f−n) z)| and a step of the format: what z errs by, times the slope",
                 "Lecture 2, z-buffer",
                 depthAsStored,
                 notStored},
        Contract{"sum-of-weights",
                 StageId::ZBuffer,
                 "The weights of a triangle's vertices sum to 1.",
                 "Σ λ_i = 1",
                 {B::Barycentric},
                 "",
                 "",
                 "1",
                 "3 u: the first is what the other two leave of 1, in two differences",
                 "P. Heckbert and H. Moreton, Interpolation for polygon texture mapping, 1991",
                 sumOfWeights,
                 notDrawnByDepth},
        Contract{"range-of-weights",
                 StageId::ZBuffer,
                 "No weight is below 0: the sample is inside.",
                 "λ_i ≥ 0",
                 {B::Barycentric},
                 "",
                 "",
                 "0 to 1",
                 "40 u: two weights round by 18 u each, and the third by both and its own two differences",
                 "J. Pineda, A parallel algorithm for polygon rasterization, 1988",
                 weightsInRange,
                 notDrawnByDepth},
        Contract{"depth-of-weights",
                 StageId::ZBuffer,
                 "The depth follows from the weights: 1/z is interpolated, not z.",
                 "z_view = Σ λ_i z_i",
                 {B::ZView, B::Barycentric, B::PolygonId, B::VerticesView},
                 "view",
                 "world units",
                 "0 to ∞",
                 "13 u z + 18 u Σ |z_i − z_0| + 16 u (|p| + 2 |E|): the depth, the weights and the vertices",
                 "P. Heckbert and H. Moreton, Interpolation for polygon texture mapping, 1991",
                 depthOfWeights,
                 notDrawnByDepth},
        Contract{"depth-writes",
                 StageId::ZBuffer,
                 "At most as many fragments pass the test as arrive, and at least one where something is visible.",
                 "1 ≤ writes ≤ overdraw",
                 {B::DepthWrites, B::Overdraw},
                 "",
                 "fragments",
                 "0 to overdraw",
                 "0: counts",
                 "Lecture 2, z-buffer",
                 writesOfFragments,
                 notDrawnByDepth},
        Contract{"object-of-polygon",
                 StageId::ZBuffer,
                 "The visible object is the object of the visible polygon.",
                 "object_id = object of polygon_id",
                 {B::ObjectId, B::PolygonId},
                 "",
                 "",
                 "−1 or an object",
                 "0: names",
                 "Lecture 1, arrays",
                 objectOfPolygon},
        Contract{"seen-is-kept",
                 StageId::ZBuffer,
                 "A visible polygon was kept.",
                 "verdict of polygon_id = kept or clipped",
                 {B::PolygonId, B::PolygonsVerdict},
                 "",
                 "",
                 "kept, clipped",
                 "0: names",
                 "Lecture 2, back-face culling",
                 seenIsKept},
    };
    return kRows;
}

}  // namespace pipeline
