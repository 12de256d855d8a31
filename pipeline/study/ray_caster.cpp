#include "pipeline/study/ray_caster.h"

#include <fmt/format.h>

#include "pipeline/run/parallel.h"
#include "pipeline/scene/opacity.h"
#include "pipeline/study/errors.h"
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

    void cast(glm::ivec2 pixel, Pixel& out) const { cast(Vec2<Real>(pixel) + Real(0.5), out); }
    void cast(Vec2<Real> place, Pixel& out) const {  // pixels
        out.at = firstSeen(m_rays, m_rays.camera.through(place));
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
        Material material = m_lighting.material(out.at.object, out.at.back);
        if (out.at.triangle != ~0u)
            material = facetMaterial(*m_scene.objects[std::size_t(out.at.object)].mesh,
                                     m_rays.triangles[out.at.triangle].triangle, Vec3d(out.at.weights), material);
        out.shaded.intensity = shade<Real>(m_lighting, material, {out.at.position, out.shaded.normal}, out.shadow);
    }

private:
    const Scene& m_scene;
    RayScene<Real> m_rays;
    RayLighting<Real> m_lighting;
    PolygonShading<Real> m_polygons;
    bool m_byPolygons;
    int m_cells;
};

Picture emptyPicture(glm::ivec2 size, std::size_t lights) {
    Picture picture;
    picture.size = size;
    picture.object = {size, -1};
    picture.zView = {size, kInfinity<double>};
    picture.position = picture.normal = picture.intensity = {size, Vec3d(0)};
    picture.shadow.assign(lights, {size, 1.0});
    return picture;
}

template <class Pixel>
void put(const Pixel& pixel, std::size_t i, Picture& picture) {
    if (pixel.at.object < 0) return;
    picture.object.pixels[i] = pixel.at.object;
    picture.zView.pixels[i] = double(pixel.at.t);
    picture.position.pixels[i] = Vec3d(pixel.at.position);
    picture.normal.pixels[i] = Vec3d(pixel.shaded.normal);
    picture.intensity.pixels[i] = Vec3d(pixel.shaded.intensity);
    for (std::size_t k = 0; k < pixel.shadow.size(); ++k) picture.shadow[k].pixels[i] = double(pixel.shadow[k]);
}

std::string nameOf(const Scene& scene, RaySurfaces surfaces) {
    if (surfaces == RaySurfaces::Polygons) return "the scene's polygons by rays, double";
    const auto isShape = [&](const Object& o) { return o.shape || isTransparent(o, scene.settings); };
    if (std::ranges::all_of(scene.objects, isShape)) return "true surfaces by rays, double";
    return std::ranges::any_of(scene.objects, [](const Object& o) { return o.shape.has_value(); })
               ? "true surfaces by rays, double; those of a mesh are its facets"
               : "the mesh's facets, taken as its true surface, by rays, double";
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
    if (std::string why = whyNoRayModel(scene.settings.model); !why.empty()) return why;
    for (const Object& object : scene.objects)
        if (surfaces == RaySurfaces::Exact && !isTransparent(object, scene.settings))
            if (std::string why = whyNoSurface(object); !why.empty()) return why;
    return {};
}

std::optional<Reference> rayCast(const Scene& scene, RaySurfaces surfaces, int threads, Stop stop) {
    const glm::ivec2 size{scene.settings.width, scene.settings.height};
    const std::size_t lights = scene.lights.size(), width = std::size_t(size.x);
    Reference reference;
    Picture& picture = reference.picture = emptyPicture(size, lights);
    const Caster<double> caster(scene, surfaces, kCells);
    Threads(threads, stop).forRange(std::size_t(size.y), 1, [&](std::size_t y, std::size_t) {
        Caster<double>::Pixel pixel;
        for (std::size_t x = 0; x < width; ++x) {
            caster.cast(glm::ivec2(int(x), int(y)), pixel);
            put(pixel, y * width + x, picture);
        }
    });

    const std::size_t count = width * std::size_t(size.y), step = std::max<std::size_t>(1, count / kChecked);
    const Caster<long double> longer(scene, surfaces, 2 * kCells);
    const std::size_t samples = (count + step - 1) / step;
    Picture some = emptyPicture({int(samples), 1}, lights), better = some;
    Threads(threads, stop).forRange(samples, 1, [&](std::size_t i, std::size_t) {
        const std::size_t at = i * step;
        const glm::ivec2 place(int(at % width), int(at / width));
        Caster<double>::Pixel ours;
        Caster<long double>::Pixel theirs;
        caster.cast(place, ours), longer.cast(place, theirs);
        put(ours, i, some), put(theirs, i, better);
    });
    if (stop.stop_requested()) return std::nullopt;
    reference.name = nameOf(scene, surfaces);
    reference.errorBars = comparePictures(scene, some, better);
    reference.errorWhy = fmt::format("against the same rays in long double, at {} pixels", samples);
    return reference;
}

namespace {

// Whether something changes between a pixel and one of its neighbours.
bool changes(const Picture& picture, glm::ivec2 pixel) {
    const std::size_t here = picture.object.offset(pixel);
    const glm::ivec2 low = glm::max(pixel - 1, glm::ivec2(0)), high = glm::min(pixel + 1, picture.size - 1);
    for (int y = low.y; y <= high.y; ++y)
        for (int x = low.x; x <= high.x; ++x) {
            const std::size_t there = picture.object.offset({x, y});
            if (picture.object.pixels[there] != picture.object.pixels[here]) return true;
            constexpr double kTurned = 0.99;  // cosine: 8 degrees
            if (picture.object.pixels[here] >= 0 &&
                glm::dot(picture.normal.pixels[there], picture.normal.pixels[here]) < kTurned)
                return true;
            for (const Buffer2D<double>& shadow : picture.shadow)
                if (shadow.pixels[there] != shadow.pixels[here]) return true;
        }
    return false;
}

// The mean over a pixel by a lattice of two neighbouring Fibonacci numbers, evenly spread whatever way an edge runs.
// H. Niederreiter, "Random number generation and quasi-Monte Carlo methods", SIAM, 1992, chapter 5.
Vec3d meanOver(const Caster<double>& caster, glm::ivec2 pixel, int count, int step) {
    Vec3d sum(0);
    Caster<double>::Pixel one;
    for (int i = 0; i < count; ++i) {
        const glm::dvec2 place{(i + 0.5) / count, (double(i) * step + 0.5) / count};
        caster.cast(glm::dvec2(pixel) + glm::fract(place), one);
        sum += one.shaded.intensity;
    }
    return sum / double(count);
}

}  // namespace

bool castWholePixels(const Scene& scene, RaySurfaces surfaces, int threads, Stop stop, Reference& reference) {
    Picture& picture = reference.picture;
    const Caster<double> caster(scene, surfaces, kCells);
    picture.antialiased = {picture.size, Vec3d(0)};
    constexpr std::size_t kShare = 16;  // of the pixels whose mean is taken twice
    const std::size_t count = picture.antialiased.pixels.size();
    Picture some, better;
    some.size = {int((count + kShare - 1) / kShare), 1};
    some.antialiased = {some.size, Vec3d(0)}, better = some;
    Threads(threads, stop).forRange(std::size_t(picture.size.y), 1, [&](std::size_t y, std::size_t) {
        for (int x = 0; x < picture.size.x; ++x) {
            const glm::ivec2 pixel{x, int(y)};
            const std::size_t i = picture.object.offset(pixel);
            const bool mixed = changes(picture, pixel);
            if (!mixed && picture.object.pixels[i] < 0) continue;  // the background, all around
            picture.antialiased.pixels[i] = mixed ? meanOver(caster, pixel, 987, 610) : meanOver(caster, pixel, 16, 5);
            if (i % kShare != 0) continue;
            some.antialiased.pixels[i / kShare] = picture.antialiased.pixels[i];
            better.antialiased.pixels[i / kShare] =
                mixed ? meanOver(caster, pixel, 610, 377) : picture.antialiased.pixels[i];
        }
    });
    if (stop.stop_requested()) return false;
    for (ErrorRow& row : comparePictures(scene, some, better)) reference.errorBars.push_back(std::move(row));
    reference.errorWhy += "; of whole pixels 987 rays against 610";
    return true;
}

}  // namespace pipeline
