#include "pipeline/study/ray_polygons.h"

#include <algorithm>
#include <array>

namespace pipeline::rays {
namespace {

// How much a polygon counts in the normal of its i-th corner.
template <class Real>
Real weightOf(NormalWeight weight, const std::vector<Vec3<Real>>& positions, std::span<const std::uint32_t> corners,
              std::size_t i) {
    if (weight == NormalWeight::Area) {
        Vec3<Real> sum(0);
        for (std::size_t j = 2; j < corners.size(); ++j)
            sum += glm::cross(positions[corners[j - 1]] - positions[corners[0]],
                              positions[corners[j]] - positions[corners[0]]);
        return glm::length(sum);
    }
    if (weight != NormalWeight::Angle) return 1;
    const std::size_t n = corners.size();
    const Vec3<Real> a = positions[corners[(i + 1) % n]] - positions[corners[i]];
    const Vec3<Real> b = positions[corners[(i + n - 1) % n]] - positions[corners[i]];
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

template <class Real>
std::vector<Vec3<Real>> vertexNormals(const Mesh& mesh, NormalWeight weight, const RayObject<Real>& object) {
    std::vector<Vec3<Real>> sums(mesh.positions.size(), Vec3<Real>(0)), first = sums;
    for (std::size_t p = 0; p < mesh.polygonCount(); ++p) {
        const auto corners = mesh.polygon(p);
        const Vec3<Real> normal = object.polygonNormals[p];
        for (std::size_t i = 0; i < corners.size(); ++i) {
            sums[corners[i]] += weightOf(weight, object.positions, corners, i) * normal;
            if (first[corners[i]] == Vec3<Real>(0)) first[corners[i]] = normal;
        }
    }
    for (std::size_t i = 0; i < sums.size(); ++i) {
        sums[i] = unit(sums[i]);
        if (sums[i] == Vec3<Real>(0)) sums[i] = first[i];  // those around it cancel
        if (weight != NormalWeight::Given || mesh.normals.empty()) continue;
        const Vec3<Real> given = unit(object.normals * unit(Vec3<Real>(mesh.normals[i])));
        if (given != Vec3<Real>(0)) sums[i] = given;
    }
    return sums;
}

// Where flat shading evaluates a polygon: at the mean of its vertices, or at the first of them.
template <class Real>
Vec3<Real> placeOf(Model model, const std::vector<Vec3<Real>>& positions, std::span<const std::uint32_t> corners) {
    const Vec3<Real> first = positions[corners[0]];
    if (modelFacts(model).firstVertex) return first;
    Vec3<Real> sum(0);
    for (const std::uint32_t corner : corners) sum += positions[corner] - first;
    return first + sum / Real(corners.size());
}

template <class Real>
void evaluate(const RayLighting<Real>& lighting, const Material& material, const LitPoint<Real>& at,
              RayElements<Real>& out) {
    Vec3<Real> base = unshadowed(lighting, material, at);
    const std::size_t begin = out.brackets.size();
    for (std::size_t k = 0; k < lighting.lights.size(); ++k) out.brackets.push_back(bracket(lighting, k, material, at));
    if (modelFacts(lighting.model).clamps) {
        // Colours of vertices are clamped. There are no shadows, so the sum is all that is ever needed.
        for (std::size_t i = begin; i < out.brackets.size(); ++i) {
            base += out.brackets[i];
            out.brackets[i] = Vec3<Real>(0);
        }
        base = glm::clamp(base, Vec3<Real>(0), Vec3<Real>(1));
    }
    out.unshadowed.push_back(base);
}

// Linear in the picture instead of in space: P. Heckbert and H. Moreton, "Interpolation for polygon texture mapping and
// shading", 1991.
template <class Real>
Vec3<Real> inThePicture(const RayCamera<Real>& camera, const RayTriangle<Real>& triangle, Vec3<Real> weights) {
    if (!camera.perspective) return weights;
    for (int i = 0; i < 3; ++i) weights[i] *= glm::dot(camera.forward, triangle.corners[std::size_t(i)] - camera.eye);
    return weights / (weights.x + weights.y + weights.z);
}

// How much of each vertex of a mesh goes into a point; they sum to 1.
template <class Real>
struct Mixture {
    std::array<std::uint32_t, 4> vertices{};
    std::array<Real, 4> weights{};
    std::size_t count = 0;
    void add(std::uint32_t vertex, Real weight) {
        vertices[count] = vertex;
        weights[count++] = weight;
    }
};

// Lecture 1's double interpolation: along the two edges that the point's row crosses on either side of it, then from one
// crossing to the other. Empty where a corner is not in front of the eye, or no span holds the point.
template <class Real>
Mixture<Real> alongScanline(const RayCamera<Real>& camera, const std::vector<Vec3<Real>>& positions,
                            std::span<const std::uint32_t> corners, Vec2<Real> point) {
    struct Crossing {
        Real x, along;
        std::uint32_t from, to;
    };
    std::vector<Crossing> crossings;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::uint32_t from = corners[i], to = corners[(i + 1) % corners.size()];
        if (camera.perspective && !(glm::dot(camera.forward, positions[from] - camera.eye) > 0)) return {};
        const Vec2<Real> a = camera.placeOf(positions[from]), b = camera.placeOf(positions[to]);
        if ((a.y <= point.y) == (b.y <= point.y)) continue;
        const Real along = (point.y - a.y) / (b.y - a.y);
        crossings.push_back({a.x + along * (b.x - a.x), along, from, to});
    }
    std::ranges::sort(crossings, {}, &Crossing::x);
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
        const Crossing &left = crossings[i], &right = crossings[i + 1];
        // The span's own end, or beyond it by rounding: the point lies in the polygon.
        const bool isLast = i + 3 >= crossings.size();
        if (point.x > right.x && !isLast && point.x >= crossings[i + 2].x) continue;
        const Real u =
            right.x > left.x ? std::clamp((point.x - left.x) / (right.x - left.x), Real(0), Real(1)) : Real(0);
        Mixture<Real> mixture;
        mixture.add(left.from, (1 - u) * (1 - left.along));
        mixture.add(left.to, (1 - u) * left.along);
        mixture.add(right.from, u * (1 - right.along));
        mixture.add(right.to, u * right.along);
        return mixture;
    }
    return {};
}

template <class Real>
Mixture<Real> mixtureAt(const Mesh& mesh, const RayScene<Real>& rays, Interpolation interpolation,
                        const SurfacePoint<Real>& at) {
    const RayTriangle<Real>& triangle = rays.triangles[at.triangle];
    Mixture<Real> mixture;
    if (interpolation == Interpolation::Scanline)
        mixture = alongScanline(rays.camera, rays.objects[triangle.object].positions, mesh.polygon(triangle.polygon),
                                rays.camera.placeOf(at.position));
    if (mixture.count > 0) return mixture;
    const Vec3<Real> weights =
        interpolation == Interpolation::Perspective ? at.weights : inThePicture(rays.camera, triangle, at.weights);
    for (int i = 0; i < 3; ++i) mixture.add(mesh.triangles[triangle.triangle].vertices[i], weights[i]);
    return mixture;
}

}  // namespace

namespace {

// Of a polygon that is lit once, and of a vertex; 1 where the mesh has no colours.
Vec3d colorOfPolygon(const Mesh& mesh, Model model, std::size_t polygon) {
    if (mesh.colors.empty()) return Vec3d(1);
    const auto corners = mesh.polygon(polygon);
    if (modelFacts(model).firstVertex) return mesh.colors[corners[0]];
    Vec3d sum(0);
    for (const std::uint32_t corner : corners) sum += mesh.colors[corner];
    return sum / double(corners.size());
}
Vec3d colorOfVertex(const Mesh& mesh, std::size_t vertex) {
    return mesh.colors.empty() ? Vec3d(1) : mesh.colors[vertex];
}

}  // namespace

Material facetMaterial(const Mesh& mesh, std::size_t triangle, const Vec3d& weights, const Material& material) {
    if (mesh.colors.empty()) return material;
    Vec3d color(0);
    for (int i = 0; i < 3; ++i) color += weights[i] * mesh.colors[mesh.triangles[triangle].vertices[i]];
    return colored(material, color);
}

template <class Real>
PolygonShading<Real> makePolygonShading(const Scene& scene, const RayScene<Real>& rays,
                                        const RayLighting<Real>& lighting) {
    PolygonShading<Real> out;
    out.shading = scene.settings.shading;
    out.interpolation = scene.settings.interpolation;
    const std::size_t count = scene.objects.size();
    out.vertexNormals.resize(count), out.front.resize(count), out.back.resize(count);
    for (std::size_t o = 0; o < count; ++o) {
        const Mesh& mesh = *scene.objects[o].mesh;
        const RayObject<Real>& object = rays.objects[o];
        if (!object.isThere) continue;
        const bool ofFirstVertex = modelFacts(lighting.model).firstVertex && !mesh.normals.empty() &&
                                   scene.settings.normalWeight == NormalWeight::Given;
        if (out.shading == Shading::Flat) {
            if (ofFirstVertex) out.vertexNormals[o] = vertexNormals(mesh, scene.settings.normalWeight, object);
            for (std::size_t p = 0; p < mesh.polygonCount(); ++p) {
                const LitPoint<Real> at{
                    placeOf(lighting.model, object.positions, mesh.polygon(p)),
                    ofFirstVertex ? out.vertexNormals[o][mesh.polygon(p)[0]] : object.polygonNormals[p]};
                const Vec3d color = colorOfPolygon(mesh, lighting.model, p);
                evaluate(lighting, colored(lighting.material(int(o), false), color), at, out.front[o]);
                if (lighting.twoSided)
                    evaluate(lighting, colored(lighting.material(int(o), true), color), {at.position, -at.N},
                             out.back[o]);
            }
            continue;
        }
        out.vertexNormals[o] = vertexNormals(mesh, scene.settings.normalWeight, object);
        if (out.shading == Shading::Phong) continue;
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            const LitPoint<Real> at{object.positions[v], out.vertexNormals[o][v]};
            const Vec3d color = colorOfVertex(mesh, v);
            evaluate(lighting, colored(lighting.material(int(o), false), color), at, out.front[o]);
            if (lighting.twoSided)
                evaluate(lighting, colored(lighting.material(int(o), true), color), {at.position, -at.N}, out.back[o]);
        }
    }
    return out;
}

template <class Real>
ShadedPoint<Real> shadePolygon(const Scene& scene, const RayScene<Real>& rays, const RayLighting<Real>& lighting,
                               const PolygonShading<Real>& polygons, const SurfacePoint<Real>& at,
                               std::span<const Real> shadow) {
    const std::size_t o = std::size_t(at.object);
    const RayTriangle<Real>& triangle = rays.triangles[at.triangle];
    const bool turned = at.back && lighting.twoSided;
    const Mixture<Real> mixture = mixtureAt(*scene.objects[o].mesh, rays, polygons.interpolation, at);
    const auto mean = [&](auto value) {
        Vec3<Real> sum(0);
        for (std::size_t i = 0; i < mixture.count; ++i) sum += mixture.weights[i] * value(mixture.vertices[i]);
        return sum;
    };

    ShadedPoint<Real> out{at.normal, {}};
    if (polygons.shading == Shading::Flat && !polygons.vertexNormals[o].empty())
        out.normal = polygons.vertexNormals[o][scene.objects[o].mesh->polygon(triangle.polygon)[0]];
    else if (polygons.shading != Shading::Flat)
        out.normal = unit(mean([&](std::uint32_t vertex) { return polygons.vertexNormals[o][vertex]; }));
    if (turned) out.normal = -out.normal;
    if (polygons.shading == Shading::Phong) {
        const Mesh& mesh = *scene.objects[o].mesh;
        const Vec3d color(mean([&](std::uint32_t vertex) { return Vec3<Real>(colorOfVertex(mesh, vertex)); }));
        const Material& material = lighting.material(at.object, at.back);
        out.intensity = shade(lighting, mesh.colors.empty() ? material : colored(material, color),
                              {at.position, out.normal}, shadow);
        return out;
    }
    const RayElements<Real>& elements = (turned ? polygons.back : polygons.front)[o];
    const std::size_t lights = lighting.lights.size();
    const auto sum = [&](std::size_t element) {
        Vec3<Real> intensity = elements.unshadowed[element];
        for (std::size_t k = 0; k < lights; ++k) intensity += shadow[k] * elements.brackets[element * lights + k];
        return intensity;
    };
    out.intensity = polygons.shading == Shading::Flat ? sum(triangle.polygon) : mean(sum);
    return out;
}

#define SHADESCOPE_INSTANTIATE(Real)                                                                                 \
    template PolygonShading<Real> makePolygonShading(const Scene&, const RayScene<Real>&, const RayLighting<Real>&); \
    template ShadedPoint<Real> shadePolygon(const Scene&, const RayScene<Real>&, const RayLighting<Real>&,           \
                                            const PolygonShading<Real>&, const SurfacePoint<Real>&,                  \
                                            std::span<const Real>);
SHADESCOPE_INSTANTIATE(double)
SHADESCOPE_INSTANTIATE(long double)
#undef SHADESCOPE_INSTANTIATE

}  // namespace pipeline::rays
