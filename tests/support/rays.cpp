#include "tests/support/rays.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "pipeline/study/errors.h"
#include "pipeline/study/ray_caster.h"

namespace test {
namespace {

double largest(Vec3d v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

// What the reference takes on in the nine pixels around one.
struct Around {
    bool isOneObject = true;
    double depths = 0, intensities = 0;  // largest minus least
};
Around around(const Picture& picture, glm::ivec2 p) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    Around out;
    double near = kInfinity, far = -kInfinity;
    Vec3d low(kInfinity), high(-kInfinity);
    for (int y = std::max(0, p.y - 1); y <= std::min(picture.size.y - 1, p.y + 1); ++y)
        for (int x = std::max(0, p.x - 1); x <= std::min(picture.size.x - 1, p.x + 1); ++x) {
            const std::size_t i = picture.object.offset({x, y});
            out.isOneObject = out.isOneObject && picture.object.pixels[i] == picture.object.at(p);
            near = std::min(near, picture.zView.pixels[i]), far = std::max(far, picture.zView.pixels[i]);
            low = glm::min(low, picture.intensity.pixels[i]), high = glm::max(high, picture.intensity.pixels[i]);
        }
    out.depths = far - near, out.intensities = largest(high - low);
    return out;
}

// Whether the pixel shows a facet that by rays only a neighbour shows: its centre lies on the edge between two, within what
// snapping moves.
bool isBesideItsFacet(const Picture& ours, const Picture& rays, glm::ivec2 p) {
    const Vec3d normal = ours.normal.at(p);
    const auto shows = [&](glm::ivec2 q) { return largest(normal - rays.normal.at(q)) < 1e-6; };
    if (shows(p)) return false;
    for (int y = std::max(0, p.y - 1); y <= std::min(rays.size.y - 1, p.y + 1); ++y)
        for (int x = std::max(0, p.x - 1); x <= std::min(rays.size.x - 1, p.x + 1); ++x)
            if (shows({x, y})) return true;
    return false;
}

}  // namespace

RayComparison compareWithRays(const Frame& frame, double snapped) {
    const Scene& scene = frame.scene();
    const Picture ours = pictureOf(frame), rays = rayCast(scene, RaySurfaces::Polygons, 0)->picture;
    const double white = whiteOf(scene);
    RayComparison found;
    for (std::size_t i = 0; i < rays.object.pixels.size(); ++i) {
        const glm::ivec2 p{int(i) % rays.size.x, int(i) / rays.size.x};
        const auto differ = [&](std::string_view what, double a, double b) {
            if (found.different.empty())
                found.different = fmt::format("pixel {}, {}: {} {} by stages, {} by rays", p.x, p.y, what, a, b);
        };
        const Around near = around(rays, p);
        if (!near.isOneObject) continue;
        if (ours.object.pixels[i] != rays.object.pixels[i])
            differ("object", ours.object.pixels[i], rays.object.pixels[i]);
        if (rays.object.pixels[i] < 0 || ours.object.pixels[i] < 0) continue;
        ++found.seen;
        if (isBesideItsFacet(ours, rays, p)) {
            ++found.otherFacets;
            continue;
        }
        const double z = ours.zView.pixels[i], right = rays.zView.pixels[i];
        if (!(std::abs(z - right) <= snapped * near.depths + 1e-12 * std::abs(right))) differ("z_view", z, right);
        bool sameShadows = true;
        for (std::size_t k = 0; k < scene.lights.size(); ++k)
            sameShadows =
                sameShadows && (scene.lights[k].intensity == 0 || ours.shadow[k].pixels[i] == rays.shadow[k].pixels[i]);
        found.otherShadows += !sameShadows;
        const Vec3d a = ours.intensity.pixels[i], b = rays.intensity.pixels[i];
        const double rounding = 1e-9 * white + 1e-12 * largest(b);
        if (sameShadows && !(largest(a - b) <= snapped * near.intensities + rounding))
            differ("brightest intensity", largest(a), largest(b));
    }
    return found;
}

}  // namespace test
