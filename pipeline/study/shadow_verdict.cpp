#include "pipeline/study/shadow_verdict.h"

#include <fmt/format.h>

#include <atomic>
#include <numeric>

#include "pipeline/run/parallel.h"
#include "pipeline/study/ray_caster.h"
#include "pipeline/study/ray_light.h"

namespace pipeline {
namespace {

// Squares along each side of an area light: half of the light or more is what counts.
constexpr int kCells = 4;

}  // namespace

std::span<const ShadowVerdictInfo, kShadowVerdictCount> shadowVerdictTable() {
    static const std::array<ShadowVerdictInfo, kShadowVerdictCount> kTable{{
        {"lit", "rays reach the light, and the frame has light"},
        {"shadowed", "rays are blocked, and the frame has a shadow"},
        {"acne", "false shadow: rays reach the light, the frame has a shadow"},
        {"leak", "false light: rays are blocked, the frame has light"},
    }};
    return kTable;
}

std::string whyNoShadowVerdicts(const Scene& scene, std::size_t light) {
    if (const Fact& shadows = modelFacts(scene.settings.model).shadows; !shadows) return std::string(shadows.whyNot);
    if (light >= scene.lights.size()) return fmt::format("The scene has no light {}.", light);
    if (!scene.lights[light].castsShadow) return fmt::format("Light {} casts no shadow.", light);
    const std::string why = whyNoRays(scene, RaySurfaces::Polygons);
    return why.empty() ? why : fmt::format("There are no exact rays here: {}.", why);
}

std::optional<ExactShadows> exactShadows(const Scene& scene, std::size_t light, int threads, Stop stop,
                                         const RayProgress& progress) {
    using namespace rays;
    const RayScene<double> world = makeRayScene<double>(scene, RaySurfaces::Polygons);
    const RayLighting<double> lighting = makeLighting<double>(scene);
    const glm::ivec2 size{scene.settings.width, scene.settings.height};
    ExactShadows exact{light, {size, -1}, {size, 0.0f}};
    std::atomic<int> done{0};
    Threads(threads, stop).forRange(std::size_t(size.y), 1, [&](std::size_t row, std::size_t) {
        const int y = int(row);
        for (int x = 0; x < size.x; ++x) {
            const SurfacePoint<double> at = firstSeen(world, world.camera.through(Vec2<double>(x + 0.5, y + 0.5)));
            if (at.object < 0) continue;
            const std::size_t i = exact.seen.offset({x, y});
            exact.object.pixels[i] = at.object;
            exact.seen.pixels[i] = float(lightSeen(world, lighting, light, at, kCells));
        }
        if (progress) progress(double(++done) / size.y);
    });
    if (stop.stop_requested()) return std::nullopt;
    return exact;
}

bool haveSameRays(const Scene& a, const Scene& b) {
    Scene other = b;
    other.settings.shadowSize = a.settings.shadowSize;
    other.settings.shadowCull = a.settings.shadowCull;
    other.settings.shadowBias = a.settings.shadowBias;
    other.settings.shadowBiasValue = a.settings.shadowBiasValue;
    other.settings.shadowFilter = a.settings.shadowFilter;
    return a == other;
}

std::size_t ShadowVerdicts::judged() const { return std::accumulate(counts.begin(), counts.end(), std::size_t(0)); }

double ShadowVerdicts::percent(ShadowVerdict v) const {
    return judged() > 0 ? 100.0 * double(counts[std::size_t(v)]) / double(judged()) : 0;
}

std::optional<ShadowVerdicts> judgeShadows(const Frame& frame, const ExactShadows& exact) {
    const auto shadow = frame.buffer({BufferId::Shadow, int(exact.light)});
    const auto objects = frame.buffer({BufferId::ObjectId});
    const glm::ivec2 size = exact.seen.size;
    if (!shadow || !objects || objects->columns() != std::size_t(size.x) || objects->rows() != std::size_t(size.y))
        return std::nullopt;
    ShadowVerdicts found{exact.light, {size, -1}};
    const auto ids = std::get<std::span<const std::int32_t>>(objects->data);
    std::visit(
        [&](const auto& factors) {
            for (std::size_t i = 0; i < ids.size(); ++i) {
                if (ids[i] < 0) continue;
                if (exact.object.pixels[i] != ids[i]) {
                    ++found.elsewhere;
                    continue;
                }
                const bool lit = double(factors[i]) >= 0.5, seen = exact.seen.pixels[i] >= 0.5f;
                const ShadowVerdict verdict = seen ? (lit ? ShadowVerdict::Lit : ShadowVerdict::Acne)
                                                   : (lit ? ShadowVerdict::Leak : ShadowVerdict::Shadowed);
                found.verdicts.pixels[i] = std::int32_t(verdict);
                ++found.counts[std::size_t(verdict)];
            }
        },
        shadow->data);
    return found;
}

AnyBuffer bufferOf(const ShadowVerdicts& verdicts) {
    const auto owner =
        std::make_shared<std::vector<std::int32_t>>(verdicts.verdicts.pixels.begin(), verdicts.verdicts.pixels.end());
    const glm::ivec2 size = verdicts.verdicts.size;
    return {{BufferId::ShadowVerdict, int(verdicts.light)},
            &bufferInfo(BufferId::ShadowVerdict),
            {std::size_t(size.y), std::size_t(size.x)},
            std::span<const std::int32_t>(*owner),
            owner};
}

}  // namespace pipeline
