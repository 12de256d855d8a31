#include "pipeline/study/ray_caster.h"

#include <fmt/format.h>
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include "pipeline/scene/opacity.h"
#include "pipeline/study/ray_polygons.h"

namespace pipeline {
namespace {

using namespace rays;

// Squares along each side of an area light.
constexpr int kCells = 16;
// Pixels that are cast in long double as well.
constexpr std::size_t kChecked = 1024;

template <class Real>
class Caster {
public:
    Caster(const Scene& scene, RaySurfaces surfaces, int cells)
        : m_scene(scene),
          m_rays(makeRayScene<Real>(scene, surfaces)),
          m_lighting(makeLighting<Real>(scene)),
          m_byPolygons(surfaces == RaySurfaces::Polygons),
          m_cells(cells) {
        if (m_byPolygons) m_polygons = makePolygonShading(scene, m_rays, m_lighting);
    }

    struct Pixel {
        SurfacePoint<Real> at;
        ShadedPoint<Real> shaded;
        std::vector<Real> shadow;  // per light
    };

    void cast(glm::ivec2 pixel, Pixel& out) const {
        out.at = firstSeen(m_rays, m_rays.camera.through(Vec2<Real>(pixel) + Real(0.5)));
        out.shadow.assign(m_lighting.lights.size(), Real(1));
        out.shaded = {};
        if (out.at.object < 0) return;
        for (std::size_t k = 0; k < out.shadow.size(); ++k)
            out.shadow[k] = lightSeen(m_rays, m_lighting, k, out.at, m_cells);
        if (m_byPolygons && out.at.triangle != ~0u) {
            out.shaded = shadePolygon<Real>(m_scene, m_rays, m_lighting, m_polygons, out.at, out.shadow);
            return;
        }
        const bool turned = out.at.back && m_lighting.twoSided;
        out.shaded.normal = turned ? -out.at.normal : out.at.normal;
        out.shaded.intensity = shade<Real>(m_lighting, m_lighting.material(out.at.object, out.at.back),
                                           {out.at.position, out.shaded.normal}, out.shadow);
    }

private:
    const Scene& m_scene;
    RayScene<Real> m_rays;
    RayLighting<Real> m_lighting;
    PolygonShading<Real> m_polygons;
    bool m_byPolygons;
    int m_cells;
};

// body(i) for i in [0, count), each once; those not begun when it is stopped are dropped.
template <class Body>
void inParallel(int threads, std::size_t count, const std::stop_token& stop, Body body) {
    oneapi::tbb::task_arena arena(threads > 0 ? threads : oneapi::tbb::task_arena::automatic);
    arena.execute([&] {
        oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<std::size_t>(0, count, 1),
                                  [&](const oneapi::tbb::blocked_range<std::size_t>& range) {
                                      for (std::size_t i = range.begin(); i < range.end(); ++i)
                                          if (!stop.stop_requested()) body(i);
                                  });
    });
}

Picture emptyPicture(glm::ivec2 size, std::size_t lights) {
    Picture picture;
    picture.size = size;
    picture.object = {size, -1};
    picture.zView = {size, kInfinity<double>};
    picture.position = picture.normal = picture.intensity = {size, Vec3d(0)};
    picture.shadow.assign(lights, {size, 1.0});
    return picture;
}

// A mesh whose vertices have normals other than its polygons' stands for a curved surface that nobody has written down.
bool hasSmoothNormals(const Mesh& mesh) {
    if (mesh.normals.empty()) return false;
    for (const Triangle& triangle : mesh.triangles) {
        const auto& v = triangle.vertices;
        const Vec3d across =
            glm::cross(mesh.positions[v[1]] - mesh.positions[v[0]], mesh.positions[v[2]] - mesh.positions[v[0]]);
        for (const std::uint32_t vertex : v) {
            const Vec3d given = unit(mesh.normals[vertex]);
            // Text files carry about six digits.
            if (glm::length(glm::cross(unit(across), given)) > 1e-4) return true;
        }
    }
    return false;
}

std::string whyNoSurface(const Object& object) {
    if (object.shape) {
        if (!hasClosedForm(object.shape->kind)) return "a teapot's patches have no closed form";
        if (!isInvertible(object.transform))
            return fmt::format("\"{}\" is scaled flat, which cannot be undone", object.name);
        return {};
    }
    if (object.mesh->facts.nonPlanar > 0)
        return fmt::format("\"{}\" has polygons that are not planar: of which surface is not said", object.name);
    if (hasSmoothNormals(*object.mesh))
        return fmt::format("\"{}\" stands for a curved surface that only its polygons tell of", object.name);
    return {};
}

}  // namespace

std::string whyNoRays(const Scene& scene, RaySurfaces surfaces) {
    if (scene.settings.visibility == Visibility::Painter)
        return "the painter's algorithm orders whole polygons: what it shows is not always what is nearest";
    if (scene.settings.visibility == Visibility::None) return "without hidden surfaces there is nothing that is seen";
    if (!translucentSides(scene).empty()) return "rays stop at the first surface, which here is translucent";
    for (const Object& object : scene.objects)
        if (surfaces == RaySurfaces::Exact && !isTransparent(object, scene.settings))
            if (std::string why = whyNoSurface(object); !why.empty()) return why;
    const bool interpolates = scene.settings.shading != Shading::Flat;
    if (surfaces == RaySurfaces::Polygons && interpolates && scene.settings.interpolation == Interpolation::Scanline)
        return "interpolation along scanlines goes by the polygons' outlines in the picture, not by surfaces";
    return {};
}

std::optional<Reference> rayCast(const Scene& scene, RaySurfaces surfaces, int threads, std::stop_token stop) {
    const glm::ivec2 size{scene.settings.width, scene.settings.height};
    const std::size_t lights = scene.lights.size(), width = std::size_t(size.x);
    Reference reference;
    Picture& picture = reference.picture = emptyPicture(size, lights);
    const Caster<double> caster(scene, surfaces, kCells);
    inParallel(threads, std::size_t(size.y), stop, [&](std::size_t y) {
        Caster<double>::Pixel pixel;
        for (std::size_t x = 0; x < width; ++x) {
            caster.cast({int(x), int(y)}, pixel);
            if (pixel.at.object < 0) continue;
            const std::size_t i = y * width + x;
            picture.object.pixels[i] = pixel.at.object;
            picture.zView.pixels[i] = pixel.at.t;
            picture.position.pixels[i] = pixel.at.position;
            picture.normal.pixels[i] = pixel.shaded.normal;
            picture.intensity.pixels[i] = pixel.shaded.intensity;
            for (std::size_t k = 0; k < lights; ++k) picture.shadow[k].pixels[i] = pixel.shadow[k];
        }
    });

    const std::size_t count = width * std::size_t(size.y), step = std::max<std::size_t>(1, count / kChecked);
    const Caster<long double> longer(scene, surfaces, 2 * kCells);
    std::vector<double> differences((count + step - 1) / step, 0.0);
    inParallel(threads, differences.size(), stop, [&](std::size_t i) {
        Caster<long double>::Pixel pixel;
        const std::size_t at = i * step;
        longer.cast({int(at % width), int(at / width)}, pixel);
        if (pixel.at.object < 0 || pixel.at.object != picture.object.pixels[at]) return;
        const Vec3<long double> difference = pixel.shaded.intensity - Vec3<long double>(picture.intensity.pixels[at]);
        differences[i] = double(largest(difference));
    });
    if (stop.stop_requested()) return std::nullopt;
    const bool exact = surfaces == RaySurfaces::Exact;
    reference.name = exact ? "true surfaces by rays, double" : "the scene's polygons by rays, double";
    reference.errorBar = *std::ranges::max_element(differences);
    reference.errorWhy = fmt::format("against the same rays in long double, at {} pixels", differences.size());
    return reference;
}

}  // namespace pipeline
