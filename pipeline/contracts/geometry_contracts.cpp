// Transform, cull and normals.
#include <algorithm>
#include <array>

#include "pipeline/buffers/screen_position.h"
#include "pipeline/buffers/verdict.h"
#include "pipeline/contracts/contract_data.h"
#include "pipeline/scene/object_matrix.h"
#include "pipeline/stages/clip.h"

namespace pipeline {
namespace {

using Found = std::optional<ContractFinding>;
using B = BufferId;

Found viewOfWorld(const ContractData& data, std::size_t vertex) {
    const View& view = data.view();
    const Vec3d p = data.vector(B::VerticesWorld, vertex), v = data.vector(B::VerticesView, vertex), e = p - view.eye;
    const Vec3d expected{glm::dot(view.right, e), glm::dot(view.up, e), glm::dot(view.forward, e)};
    const double distance = glm::length(v - expected);
    return equals(distance, 0, 16 * data.u() * (glm::length(p) + glm::length(view.eye)));
}

Found screenOfView(const ContractData& data, std::size_t vertex) {
    const View& view = data.view();
    const Vec3d v = data.vector(B::VerticesView, vertex), screen = data.vector(B::VerticesScreen, vertex);
    // Before the eye there is no agreed place, and close to it none that rounding leaves.
    if (!hasScreenPosition(screen) || (view.perspective && !(v.z > 0))) return {};
    const double spread = view.perspective ? v.z : 1;
    const glm::dvec2 off{view.scale.x * v.x / spread, -view.scale.y * v.y / spread};
    const glm::dvec2 expected = view.centre + off, is{screen.x, screen.y};
    const glm::dvec2 size = 4.0 * glm::abs(off) + glm::abs(is) + glm::abs(view.centre);
    return equals(glm::length(is - expected), 0, data.u() * (size.x + size.y));
}

// Twice the area, and what moving every vertex by h in x and in y makes of it at most.
struct ScreenArea2 {
    double twice = 0, bound = 0;
};
std::optional<ScreenArea2> screenArea(const ContractData& data, const Topology::Corners& corners) {
    std::vector<glm::dvec2> p;
    double largest = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3d screen = data.vector(B::VerticesScreen, corners[i]);
        if (!hasScreenPosition(screen)) return {};
        p.push_back({screen.x, -screen.y});
        largest = std::max({largest, std::abs(screen.x), std::abs(screen.y)});
    }
    if (!(largest < kGuardBand)) return {};
    const double h = std::ldexp(1.0, -1 - data.scene().settings.subPixelBits) + 8 * data.u() * largest;
    ScreenArea2 out;
    for (std::size_t i = 0, n = p.size(); i < n; ++i) {
        const glm::dvec2 next = p[(i + 1) % n] - p[0], here = p[i] - p[0];
        const glm::dvec2 across = glm::abs(p[(i + 1) % n] - p[(i + n - 1) % n]);
        out.twice += here.x * next.y - next.x * here.y;
        out.bound += h * (across.x + across.y) + 2 * h * h;
    }
    return out;
}

Found windingOfVerdict(const ContractData& data, std::size_t polygon) {
    const auto verdict = Verdict(int(data.number(B::PolygonsVerdict, polygon)));
    if (verdict != Verdict::Kept && verdict != Verdict::BackFacing) return {};
    const auto area = screenArea(data, data.topology().corners(polygon));
    if (!area) return {};
    const ObjectTransform& place = data.scene().objects[data.topology().objectOfPolygon(polygon)].transform;
    const double seen = (makeObjectMatrix(place).mirrors ? -1 : 1) * area->twice / 2;
    const double wrong = verdict == Verdict::Kept ? -seen : seen;
    return ContractFinding{seen, wrong > 0 ? wrong : wrong <= 0 ? 0 : wrong, area->bound / 2};
}

std::string notCulled(const Scene& scene, std::size_t) {
    return scene.settings.cull == CullMode::None ? "Both sides are kept: cull = none." : "";
}

Found outsideOfPlane(const ContractData& data, std::size_t polygon) {
    const auto verdict = Verdict(int(data.number(B::PolygonsVerdict, polygon)));
    if (verdict < Verdict::OutsideNear || verdict > Verdict::OutsideBottom) return {};
    const View& view = data.view();
    const Topology::Corners corners = data.topology().corners(polygon);
    double inside = -std::numeric_limits<double>::infinity(), size = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3d v = data.vector(B::VerticesView, corners[i]);
        const double spread = view.perspective ? v.z : 1, x = view.scale.x * v.x, y = view.scale.y * v.y;
        const double side = view.size.x / 2.0 * spread, top = view.size.y / 2.0 * spread;
        const std::array<double, 6> distances{v.z - view.near, view.far - v.z, side + x, side - x, top - y, top + y};
        const std::size_t plane = std::size_t(verdict) - std::size_t(Verdict::OutsideNear);
        inside = std::max(inside, distances[plane]);
        size = std::max(
            {size, std::abs(v.z), std::abs(view.near), std::abs(side) + std::abs(x), std::abs(top) + std::abs(y)});
    }
    return ContractFinding{inside, std::max(inside, 0.0), 4 * data.u() * size};
}

Found unitPolygonNormal(const ContractData& data, std::size_t polygon) {
    const Vec3d normal = data.vector(B::PolygonsNormal, polygon);
    if (normal == Vec3d(0) && data.has(B::VerticesWorld) && !data.hasArea(data.topology().corners(polygon))) return {};
    return unitLength(normal, 4 * data.u());
}

// Of triangles alone: the vertices of other polygons need not lie in a plane.
Found normalByWinding(const ContractData& data, std::size_t polygon) {
    const Topology::Corners corners = data.topology().corners(polygon);
    const Vec3d normal = data.vector(B::PolygonsNormal, polygon);
    if (corners.size() != 3 || normal == Vec3d(0)) return {};
    Vec3d p[3];
    for (std::size_t i = 0; i < 3; ++i) p[i] = data.vector(B::VerticesWorld, corners[i]);
    const Vec3d cross = glm::cross(p[1] - p[0], p[2] - p[0]);
    const double longest = std::max({glm::length(p[1] - p[0]), glm::length(p[2] - p[1]), glm::length(p[0] - p[2])});
    const double length = glm::length(cross), bound = data.u() * (8 * longest * longest / length + 4);
    const ObjectTransform& place = data.scene().objects[data.topology().objectOfPolygon(polygon)].transform;
    const Vec3d expected = (makeObjectMatrix(place).mirrors ? -1.0 : 1.0) / length * cross;
    return direction(normal - expected, bound);
}

Found unitVertexNormal(const ContractData& data, std::size_t vertex) {
    const Vec3d normal = data.vector(B::VerticesNormal, vertex);
    if (normal == Vec3d(0) && !data.hasAreaAround(vertex)) return {};
    return unitLength(normal, 4 * data.u());
}

}  // namespace

std::span<const Contract> geometryContracts() {
    static const Contract kRows[]{
        Contract{"view",
                 StageId::Transform,
                 "View space is world space, moved and turned: no length changes.",
                 "p_v = R (p − E)",
                 {B::VerticesView, B::VerticesWorld},
                 "view",
                 "world units",
                 "0",
                 "16 u (|p| + |E|): the difference rounds by |p| + |E|, each of three scalar products by 4 |p − E|, "
                 "the sum of "
                 "a viewing distance by 2 |E| more",
                 "Lecture 1, viewing transformation",
                 viewOfWorld},
        Contract{"screen",
                 StageId::Transform,
                 "Pixels are view space divided by the depth, y downwards.",
                 "x_s = w/2 + d x_v / z_v, y_s = h/2 − d y_v / z_v",
                 {B::VerticesScreen, B::VerticesView},
                 "screen",
                 "pixels",
                 "0",
                 "u (4 |x_s − w/2| + |x_s| + w/2), in x and y: scale, product and quotient round, and the sum",
                 "Lecture 1, perspective projection",
                 screenOfView},
        Contract{"winding",
                 StageId::Cull,
                 "Kept polygons show their fronts, back-facing ones their backs.",
                 "A ≥ 0 if kept, A ≤ 0 if back-facing; A = ½ Σ (x_i y_i+1 − x_i+1 y_i)",
                 {B::PolygonsVerdict, B::VerticesScreen},
                 "screen",
                 "px²",
                 "−∞ to ∞",
                 "½ h Σ (|Δx| + |Δy|) + n h²: each vertex is snapped by h = 2^-(bits+1) pixels at most, and rounded",
                 "Lecture 2, back-face culling",
                 windingOfVerdict,
                 notCulled},
        Contract{"outside",
                 StageId::Cull,
                 "A polygon outside a plane has all its vertices outside it.",
                 "z_v < n, z_v > f, d |x_v| > z_v w/2, d |y_v| > z_v h/2",
                 {B::PolygonsVerdict, B::VerticesView},
                 "view",
                 "",
                 "below 0",
                 "4 u of the largest term: two products and their sum",
                 "I. Sutherland and G. Hodgman, Reentrant polygon clipping, 1974",
                 outsideOfPlane},
        Contract{"unit-polygon-normals",
                 StageId::Normals,
                 "Polygon normals have length 1.",
                 "|N| = 1",
                 {B::PolygonsNormal},
                 "world",
                 "",
                 "1",
                 "4 u: v / √(v·v) rounds each component by 3.5 u",
                 "Lecture 1, normals",
                 unitPolygonNormal},
        Contract{"normal-by-winding",
                 StageId::Normals,
                 "A triangle's normal points to where its vertices run counter-clockwise.",
                 "N = v01 × v02 / |v01 × v02|",
                 {B::PolygonsNormal, B::VerticesWorld},
                 "world",
                 "",
                 "0",
                 "u (8 l² / |v01 × v02| + 4), l the longest side: what differences and products of sides round, and "
                 "the length",
                 "Lecture 1, normals",
                 normalByWinding},
        Contract{"unit-vertex-normals",
                 StageId::Normals,
                 "Vertex normals have length 1.",
                 "|N| = 1",
                 {B::VerticesNormal},
                 "world",
                 "",
                 "1",
                 "4 u: v / √(v·v) rounds each component by 3.5 u",
                 "Lecture 1, Gouraud shading",
                 unitVertexNormal},
    };
    return kRows;
}

}  // namespace pipeline
