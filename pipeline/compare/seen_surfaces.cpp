#include "pipeline/compare/seen_surfaces.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "pipeline/core/triangle_tree.h"
#include "pipeline/run/frame_data.h"

namespace pipeline::foreign {

namespace {

constexpr std::size_t kAsked = 4000;              // pixels: each is asked for all polygons that it meets
constexpr double kMost = 0.9, kNearlyAll = 0.98;  // of them

// All polygons of a scene that a pixel's sample meets, culled or not.
class Surfaces {
public:
    struct Hit {
        std::size_t polygon;
        double z;
    };
    explicit Surfaces(const Reference& reference)
        : m_view(reference.context.view), m_data(*dataOf<double>(*reference.frame)) {
        const Topology& topology = *m_data.transform->topology;
        const auto count = std::uint32_t(topology.firstTriangleOf(topology.polygonCount() - 1) +
                                         topology.triangleCountOf(topology.polygonCount() - 1));
        m_tree = rays::makeTree<double>(count, [&](std::uint32_t t) { return corners(t); });
    }
    std::vector<Hit> at(std::size_t x, std::size_t y) const {
        const glm::dvec2 p = (glm::dvec2(double(x) + 0.5, double(y) + 0.5) - m_view.centre) / m_view.scale;
        const rays::Ray<double> ray = m_view.perspective ? rays::Ray<double>{Vec3d(0), {p.x, -p.y, 1}}
                                                         : rays::Ray<double>{{p.x, -p.y, 0}, {0, 0, 1}};
        const rays::TriangleRay<double> line(ray);
        std::vector<Hit> hits;
        const Topology& topology = *m_data.transform->topology;
        forEachNear(m_tree, line, m_view.near, HUGE_VAL, [&](std::uint32_t place, double&) {
            const std::uint32_t triangle = m_tree.order[place];
            double z = 0;
            Vec3d weights;
            if (line.meets(corners(triangle), z, weights) && z >= m_view.near)
                hits.push_back({topology.polygonOf(triangle), z});
            return false;
        });
        return hits;
    }
    // The least and the largest depth of a polygon's vertices.
    std::pair<double, double> range(std::size_t polygon) const {
        double low = HUGE_VAL, high = -HUGE_VAL;
        const auto vertices = m_data.transform->topology->corners(polygon);
        for (std::size_t n = 0; n < vertices.size(); ++n) {
            const double z = toView<double>(m_view, m_data.transform->world[vertices[n]]).z;
            low = std::min(low, z), high = std::max(high, z);
        }
        return {low, high};
    }

private:
    rays::Corners<double> corners(std::uint32_t triangle) const {
        const Topology& topology = *m_data.transform->topology;
        const std::size_t object = topology.objectOfPolygon(topology.polygonOf(triangle));
        const Triangle& of = topology.meshes[object]->triangles[triangle - topology.firstTriangle[object]];
        rays::Corners<double> out;
        for (std::size_t c = 0; c < 3; ++c)
            out[c] = toView<double>(m_view, m_data.transform->world[of.vertices[c] + topology.firstVertex[object]]);
        return out;
    }

    const View& m_view;
    const FrameData<double>& m_data;
    rays::TriangleTree<double> m_tree;
};

struct Asked {
    std::size_t pixel;
    std::vector<Surfaces::Hit> hits;
};
// So many of the pixels, spread evenly.
std::vector<Asked> ask(const Surfaces& surfaces, const std::vector<std::size_t>& pixels, std::size_t columns) {
    std::vector<Asked> out;
    const std::size_t step = std::max<std::size_t>(1, (pixels.size() + kAsked - 1) / kAsked);
    for (std::size_t n = 0; n < pixels.size(); n += step)
        out.push_back({pixels[n], surfaces.at(pixels[n] % columns, pixels[n] / columns)});
    return out;
}

// The share of their depths that are those of polygons.
double shareOnSurfaces(const std::vector<Asked>& asked, const Values& theirs, double tolerance) {
    std::size_t drawn = 0, found = 0;
    for (const Asked& one : asked) {
        if (!theirs.there[one.pixel]) continue;
        const double z = theirs.numbers[one.pixel], allowed = theirs.allowed(one.pixel, tolerance);
        ++drawn,
            found += std::ranges::any_of(one.hits, [&](const auto& hit) { return std::abs(hit.z - z) <= allowed; });
    }
    return drawn > 0 ? double(found) / double(drawn) : 0;
}

// Of depths that are those of polygons: where culling is right and the z-buffer wrong, or the other way round.
std::vector<StageId> stagesOfVisibility(const Surfaces& surfaces, const ReadFile& file, const Finding& depths,
                                        const Reference& reference) {
    const Values &theirs = file.mine, &right = reference.values.at("z_view");
    const Values& seen = reference.values.at("polygon_id");
    const Values& verdicts = reference.values.at("polygons.verdict");
    std::vector<std::size_t> wrong;
    std::set<std::size_t> shown;  // polygons that they draw somewhere
    double farthest = 0, lost = HUGE_VAL;
    std::size_t before = 0;  // the near plane
    const double near = reference.context.view.near - depths.tolerance;
    for (std::size_t i = 0; i < right.count(); ++i) {
        if (theirs.there[i]) farthest = std::max(farthest, theirs.numbers[i]);
        if (!isBad(depths.classes[i])) {
            if (right.there[i] && theirs.there[i]) shown.insert(std::size_t(seen.numbers[i]));
            continue;
        }
        wrong.push_back(i);
        before += theirs.there[i] && theirs.numbers[i] < near;
        if (!theirs.there[i]) lost = std::min(lost, right.numbers[i]);
    }
    if (double(before) > (1 - kMost) * double(wrong.size())) return {};
    // Culling knows no depth: what is lost behind all that is there was never nearer than the z-buffer's first value.
    if (std::isfinite(lost) && lost >= farthest - 2 * depths.tolerance) return {StageId::ZBuffer};
    const std::vector<Asked> asked = ask(surfaces, wrong, right.columns);
    std::vector<std::optional<Surfaces::Hit>> their;  // the polygon that has their depth, rather one that is not culled
    for (const Asked& one : asked) {
        std::optional<Surfaces::Hit> found;
        for (const auto& hit : one.hits) {
            const double allowed = theirs.allowed(one.pixel, depths.tolerance);
            if (!theirs.there[one.pixel] || !(std::abs(hit.z - theirs.numbers[one.pixel]) <= allowed)) continue;
            if (!found || verdicts.numbers[hit.polygon] != 0) found = hit;
        }
        if (found) shown.insert(found->polygon);
        their.push_back(found);
    }
    std::size_t cull = 0, zBuffer = 0, dropped = 0, nowhere = 0;
    for (std::size_t n = 0; n < asked.size(); ++n) {
        if (theirs.there[asked[n].pixel] && !their[n]) {
            ++nowhere;
            continue;
        }
        dropped += their[n] && verdicts.numbers[their[n]->polygon] == 0;
        const double from = their[n] ? their[n]->z - depths.tolerance : HUGE_VAL;
        const bool isPassedOver = std::ranges::any_of(asked[n].hits, [&](const auto& hit) {
            return hit.z < from && verdicts.numbers[hit.polygon] != 0 && shown.contains(hit.polygon);
        });
        ++(isPassedOver ? zBuffer : cull);
    }
    if (double(nowhere) > (1 - kMost) * double(asked.size())) return {};  // not all of it is visibility
    const double most = kMost * double(cull + zBuffer);
    // What culling drops is seen nowhere but where culling is wrong, whatever else it leads to. If the rows run upwards, y
    // may be the error: it turns front and back round.
    if (double(cull) >= most || 2 * dropped > cull + zBuffer)
        return file.reading.bottomUp ? std::vector{StageId::Transform, StageId::Cull} : std::vector{StageId::Cull};
    if (double(zBuffer) >= most) return {StageId::ZBuffer};
    return {};
}

}  // namespace

std::vector<StageId> stagesOfDepths(const ReadFile& file, const std::vector<Reading>& readings,
                                    const ReadingContext& context, const Reference& reference) {
    const Values& right = reference.values.at("z_view");
    const Values& seen = reference.values.at("polygon_id");
    const double tolerance = reference.tolerances.at("z_view");
    const Surfaces surfaces(reference);
    std::vector<std::size_t> all(right.count());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    const std::vector<Asked> asked = ask(surfaces, all, right.columns);
    // Depths of other polygons are those of polygons in one reading alone; the files' own goes first.
    ReadFile best = file;
    double most = shareOnSurfaces(asked, file.mine, tolerance);
    for (const Reading& reading : readings) {
        Values mine = read(*file.file, reading, context, right);
        const double share = shareOnSurfaces(asked, mine, tolerance);
        if (share > most + (1 - kNearlyAll)) most = share, best.reading = reading, best.mine = std::move(mine);
    }
    if (most >= kMost) {
        const Finding depths = compareValues(best, right, reference);
        return depths.agrees ? std::vector<StageId>() : stagesOfVisibility(surfaces, best, depths, reference);
    }
    // Of planes of their own the reading leans on the right depths.
    if (context.opensPlanes) return {};
    const Finding depths = compareValues(file, right, reference);
    std::size_t nowhere = 0, inRange = 0, elsewhere = 0;
    std::map<double, std::size_t> counts;
    for (const Asked& one : asked) {
        const std::size_t i = one.pixel;
        if (!isBad(depths.classes[i]) || !file.mine.there[i]) continue;
        const double z = file.mine.numbers[i], allowed = file.mine.allowed(i, tolerance);
        if (std::ranges::any_of(one.hits, [&](const auto& hit) { return std::abs(hit.z - z) <= allowed; })) {
            ++elsewhere;
            continue;
        }
        const auto [low, high] =
            right.there[i] ? surfaces.range(std::size_t(seen.numbers[i])) : std::pair(HUGE_VAL, -HUGE_VAL);
        ++nowhere, inRange += z >= low - tolerance && z <= high + tolerance, ++counts[z];
    }
    if (nowhere == 0 || double(nowhere) < kMost * double(nowhere + elsewhere)) return {};
    // One depth that most of them have is what the z-buffer begins with.
    const auto commonest = std::ranges::max_element(counts, {}, [](const auto& one) { return one.second; });
    double nearest = HUGE_VAL, farthest = 0;
    for (std::size_t i = 0; i < right.count(); ++i)
        if (right.there[i])
            nearest = std::min(nearest, right.numbers[i]), farthest = std::max(farthest, right.numbers[i]);
    if (2 * commonest->second > nowhere)
        return commonest->first > nearest && commonest->first < farthest ? std::vector{StageId::ZBuffer}
                                                                         : std::vector<StageId>();
    return double(inRange) <= kMost * double(nowhere) ? std::vector{StageId::Transform}
                                                      : std::vector{StageId::Transform, StageId::ZBuffer};
}

}  // namespace pipeline::foreign
