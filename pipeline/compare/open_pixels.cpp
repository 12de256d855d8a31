#include "pipeline/compare/open_pixels.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "pipeline/compare/coverage_verifier.h"
#include "pipeline/run/frame_data.h"

namespace pipeline::foreign {

namespace {

constexpr int kSnappingBits = 4;

}  // namespace

bool OpenPixels::isOpen(std::size_t pixel) const {
    std::atomic<PixelState>& kept = (*m_reference.openPixels)[pixel];
    PixelState state = kept.load(std::memory_order_relaxed);
    if (state == PixelState::NotAsked) {
        state = find(pixel) ? PixelState::Open : PixelState::Closed;
        kept.store(state, std::memory_order_relaxed);  // others find the same
    }
    return state == PixelState::Open;
}

bool OpenPixels::find(std::size_t pixel) const {
    const Values& polygons = m_reference.values.at("polygon_id");
    const auto& data = *dataOf<double>(*m_reference.frame);
    const Topology& topology = *data.transform->topology;
    const View& view = m_reference.context.view;
    const Values& screen = m_reference.values.at("vertices.screen");
    const int x = int(pixel % polygons.columns), y = int(pixel / polygons.columns);
    std::set<int> near;  // the polygons around
    for (int v = std::max(0, y - 1); v <= std::min(int(polygons.rows) - 1, y + 1); ++v)
        for (int u = std::max(0, x - 1); u <= std::min(int(polygons.columns) - 1, x + 1); ++u)
            near.insert(int(polygons.numbers[std::size_t(v) * polygons.columns + std::size_t(u)]));
    const glm::dvec2 sample = (glm::dvec2(x + 0.5, y + 0.5) - view.centre) / view.scale;
    std::vector<double> depths;  // of those that cover the sample for certain
    for (const int polygon : near) {
        if (polygon < 0) continue;
        bool covers = false;
        const std::size_t first = topology.firstTriangleOf(std::size_t(polygon));
        const std::size_t count = topology.triangleCountOf(std::size_t(polygon));
        const std::size_t object = topology.objectOfPolygon(std::size_t(polygon));
        for (std::size_t t = first; t < first + count; ++t) {
            const Mesh& mesh = *topology.meshes[object];
            const Triangle& triangle = mesh.triangles[t - topology.firstTriangle[object]];
            std::array<glm::dvec2, 3> corners;
            for (std::size_t c = 0; c < 3; ++c) {
                const std::size_t vertex = triangle.vertices[c] + topology.firstVertex[object];
                if (!screen.there[vertex])
                    return true;  // it is clipped, and where its pieces end depends on the clipper
                corners[c] = glm::dvec2(screen.at(vertex)[0], screen.at(vertex)[1]) + m_reference.context.sampleShift;
            }
            const auto verifier = CoverageVerifier::make(corners, kSnappingBits, Snapping::Within);
            if (!verifier) return true;
            const Coverage coverage = verifier->at({x, y});
            if (coverage == Coverage::Free) return true;
            covers = covers || coverage == Coverage::Forced;
        }
        if (!covers) continue;
        // The depth of its plane at the sample: along the ray (x, y, 1), or beside the axis in parallel projection.
        const auto corner = topology.corners(std::size_t(polygon));
        const Vec3d a = toView<double>(view, data.transform->world[corner[0]]);
        const Vec3d b = toView<double>(view, data.transform->world[corner[1]]);
        const Vec3d c = toView<double>(view, data.transform->world[corner[2]]);
        const Vec3d n = glm::cross(b - a, c - a), ray(sample.x, -sample.y, 1);
        const double z = view.perspective ? glm::dot(n, a) / glm::dot(n, ray)
                                          : a.z - (n.x * (ray.x - a.x) + n.y * (ray.y - a.y)) / n.z;
        if (std::isfinite(z)) depths.push_back(z);
    }
    std::ranges::sort(depths);
    const double tie = m_reference.tolerances.at("z_view");
    return depths.size() > 1 && depths[1] - depths[0] <= tie;
}

}  // namespace pipeline::foreign
