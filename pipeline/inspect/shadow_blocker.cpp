#include "pipeline/inspect/shadow_blocker.h"

#include <fmt/format.h>

#include "pipeline/inspect/shadow_events.h"

namespace pipeline {
namespace {

// How far along `way` from `from` it meets a triangle, as a factor of it; nothing where it does not.
std::optional<double> meets(Vec3d from, Vec3d way, Vec3d a, Vec3d b, Vec3d c) {
    const Vec3d ab = b - a, ac = c - a, across = glm::cross(way, ac);
    const double volume = glm::dot(ab, across);
    if (volume == 0) return std::nullopt;
    const Vec3d fromA = from - a;
    const double u = glm::dot(fromA, across) / volume;
    const Vec3d other = glm::cross(fromA, ab);
    const double v = glm::dot(way, other) / volume;
    if (!(u >= 0 && v >= 0 && u + v <= 1)) return std::nullopt;
    const double t = glm::dot(ac, other) / volume;
    return t > 0 ? std::optional(t) : std::nullopt;
}

template <class Real>
bool facesLight(const FrameData<Real>& data, std::size_t light, Vec3d position, std::size_t triangle, bool back) {
    const Light& from = data.keys.shading.lights[light];
    const Vec3d front(data.shadingSources().planeNormal(triangle));
    const Vec3d way = from.kind == LightKind::AtInfinity ? from.position : from.position - position;
    return glm::dot(back ? -front : front, way) > 0;
}

}  // namespace

template <class Real>
std::optional<std::uint32_t> blockerOf(const FrameData<Real>& data, std::size_t light, Vec3d position,
                                       std::uint32_t polygon, const Stop& stop) {
    const TransformOutput<Real>& in = *data.transform;
    const Light& from = data.keys.shading.lights[light];
    const bool atInfinity = from.kind == LightKind::AtInfinity;
    const Vec3d way = atInfinity ? from.position : from.position - position;
    const ShadowCull cull = data.keys.shadowBuffer.cull;
    std::optional<std::uint32_t> last;
    double farthest = 0;
    for (std::size_t i = 0; i < in.topology->triangles.size(); ++i) {
        if (stop.stop_requested()) break;
        const std::uint32_t here = in.topology->polygonOf(i);
        if (here == polygon) continue;
        if (!in.transparent.empty() && in.transparent[in.topology->objectOfPolygon(here)]) continue;
        const auto& v = in.topology->triangles[i].vertices;
        const auto t = meets(position, way, Vec3d(in.world[v[0]]), Vec3d(in.world[v[1]]), Vec3d(in.world[v[2]]));
        if (!t || *t <= farthest || !(atInfinity || *t < 1)) continue;
        if (cull != ShadowCull::None &&
            facesLight(data, light, position + *t * way, i, false) != (cull == ShadowCull::Back))
            continue;
        farthest = *t;
        last = here;
    }
    return last;
}

template <class Real>
std::string whyShadowed(const Scene& scene, const FrameData<Real>& data, std::size_t light, Vec3d position,
                        std::uint32_t triangle, bool back, const Stop& stop) {
    const std::uint32_t polygon = data.transform->topology->polygonOf(triangle);
    if (!facesLight(data, light, position, triangle, back))
        return fmt::format("Polygon {} faces away from light {}: only the ambient term counts.", polygon, light);
    const auto compared = shadowComparison(data, light, triangle, Vec3<Real>(position));
    const std::string numbers = compared ? " (" + *compared + ")" : std::string();
    if (const auto blocker = blockerOf(data, light, position, polygon, stop)) {
        const std::string& object = scene.objects[data.transform->topology->objectOfPolygon(*blocker)].name;
        return fmt::format("In the shadow of polygon {} of {}, before light {}: only the ambient term counts{}.",
                           *blocker, object, light, numbers);
    }
    return fmt::format("The shadow buffer of light {} is wrong here: no polygon stands before it{}: acne.", light,
                       numbers);
}

std::vector<int> blockersOf(const Frame& frame, const PixelReport& report) {
    std::vector<int> blockers(report.shadow.size(), -1);
    if (!modelFacts(frame.scene().settings.model).shadows) return blockers;
    readStages(frame, [&](const auto& data) {
        for (std::size_t k = 0; k < blockers.size(); ++k) {
            if (report.shadow[k] != 0 || data.keys.shading.lights[k].kind == LightKind::Area) continue;
            const auto polygon = std::uint32_t(report.polygon);
            if (!facesLight(data, k, report.position, std::size_t(report.triangle), report.back)) continue;
            if (const auto found = blockerOf(data, k, report.position, polygon)) blockers[k] = int(*found);
        }
    });
    return blockers;
}

#define SHADESCOPE_INSTANTIATE(Real)                                                                                \
    template std::optional<std::uint32_t> blockerOf(const FrameData<Real>&, std::size_t, Vec3d, std::uint32_t,      \
                                                    const Stop&);                                                   \
    template std::string whyShadowed(const Scene&, const FrameData<Real>&, std::size_t, Vec3d, std::uint32_t, bool, \
                                     const Stop&);
SHADESCOPE_FOR_EVERY_REAL(SHADESCOPE_INSTANTIATE)
#undef SHADESCOPE_INSTANTIATE

}  // namespace pipeline
