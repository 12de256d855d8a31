#include "pipeline/study/ray_scene.h"

#include <utility>

#include "pipeline/scene/opacity.h"

namespace pipeline::rays {
namespace {

template <class Real>
Vec3<Real> leastAligned(Vec3<Real> v) {
    const Vec3<Real> a = glm::abs(v);
    if (a.x <= a.y && a.x <= a.z) return {1, 0, 0};
    return a.y <= a.z ? Vec3<Real>(0, 1, 0) : Vec3<Real>(0, 0, 1);
}

// Columns are what the axes become.
template <class Real>
Mat3<Real> turnAbout(int axis, double degrees) {
    const auto [s, c] = sinCos<Real>(degrees);
    const int next = (axis + 1) % 3, last = (axis + 2) % 3;
    Mat3<Real> m(1);
    m[next][next] = c, m[next][last] = s;
    m[last][next] = -s, m[last][last] = c;
    return m;
}

// B. O. Rodrigues' formula, column by column: v cos + (a × v) sin + a (a·v)(1 − cos).
template <class Real>
Mat3<Real> turnAbout(const AxisTurn& turn) {
    const auto [s, c] = sinCos<Real>(turn.angle);
    const Vec3<Real> a = unit(Vec3<Real>(turn.axis));
    Mat3<Real> m(1);
    for (int i = 0; i < 3; ++i) {
        Vec3<Real> v(0);
        v[i] = 1;
        m[i] = v * c + glm::cross(a, v) * s + a * (a[i] * (1 - c));
    }
    return m;
}

template <class Real>
Mat3<Real> linearPart(const ObjectTransform& transform) {
    const Vec3<Real> scale(transform.scale);
    Mat3<Real> m(1);
    // Each axis of the mesh once it is upright, and scaled.
    for (int i = 0; i < 3; ++i) m[i] = scale * Vec3<Real>(upright(transform.up, Vec3d(i == 0, i == 1, i == 2)));
    if (transform.turns.empty()) {
        for (int axis = 0; axis < 3; ++axis) m = turnAbout<Real>(axis, transform.rotation[axis]) * m;
        return m;
    }
    for (auto turn = transform.turns.rbegin(); turn != transform.turns.rend(); ++turn) m = turnAbout<Real>(*turn) * m;
    return m;
}

template <class Real>
Mat3<Real> cofactors(const Mat3<Real>& m) {
    return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

template <class Real>
void place(const Object& object, bool polygons, RayObject<Real>& out) {
    const Mat3<Real> m = out.toWorld = linearPart<Real>(object.transform);
    out.translation = Vec3<Real>(object.transform.translation);
    const Mat3<Real> cofactor = cofactors(m);
    const Real determinant = glm::dot(m[0], cofactor[0]);
    const Vec3d scale = object.transform.scale;
    const bool mirrors = (scale.x < 0) != ((scale.y < 0) != (scale.z < 0));
    out.normals = mirrors ? -cofactor : cofactor;
    out.mirrors = mirrors;
    out.isShape = object.shape && !polygons;
    if (out.isShape) {
        out.kind = object.shape->kind;
        out.isConvex = isConvex(out.kind);
        out.toObject = glm::transpose(cofactor) / determinant;
        out.middle = out.translation;
        const Vec3<Real> own(halfExtent(out.kind));
        for (int i = 0; i < 3; ++i) out.half += own[i] * glm::abs(m[i]);
        return;
    }
    const Mesh& mesh = *object.mesh;
    out.isConvex = mesh.facts.convex;
    for (const Vec3d& p : mesh.positions) out.positions.push_back(m * Vec3<Real>(p) + out.translation);
    for (std::size_t i = 0; i < mesh.polygonCount(); ++i) {
        const auto corners = mesh.polygon(i);
        Vec3<Real> sum(0);
        for (std::size_t j = 2; j < corners.size(); ++j) {
            const Vec3<Real> first = out.positions[corners[0]];
            sum += glm::cross(out.positions[corners[j - 1]] - first, out.positions[corners[j]] - first);
        }
        out.polygonNormals.push_back(unit(mirrors ? -sum : sum));
    }
}

template <class Real>
void addTriangles(const Mesh& mesh, std::uint32_t object, const RayObject<Real>& placed,
                  std::vector<RayTriangle<Real>>& triangles) {
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        RayTriangle<Real> t{{}, object, mesh.polygonOf(i), i};
        for (std::size_t c = 0; c < 3; ++c) t.corners[c] = placed.positions[mesh.triangles[i].vertices[c]];
        triangles.push_back(t);
    }
}

template <class Real>
Ray<Real> inObject(const RayObject<Real>& object, const Ray<Real>& ray) {
    return {object.toObject * (ray.origin - object.translation), object.toObject * ray.direction};
}

// A triangle can block a ray that leaves the point, for all that its object says, and whether it is the point's own.
template <class Real>
bool mayBlock(const RayScene<Real>& scene, const SurfacePoint<Real>& from, std::uint32_t i) {
    const RayTriangle<Real>& triangle = scene.triangles[i];
    if (int(triangle.object) != from.object) return true;
    if (scene.objects[triangle.object].isConvex) return false;
    return i != from.triangle;
}

template <class Real>
bool shapeBlocks(const RayScene<Real>& scene, const SurfacePoint<Real>& from, std::size_t i, const Ray<Real>& ray,
                 Real begin, Real end) {
    const RayObject<Real>& object = scene.objects[i];
    if (!object.isShape || !object.isThere) return false;
    const bool isOwn = int(i) == from.object;
    if (isOwn && object.isConvex) return false;
    const Ray<Real> local = inObject(object, ray);
    if (isOwn && object.kind == ShapeKind::Torus) return torusMeetsItself(local, end);
    const Crossings<Real> met = crossings(object.kind, local);
    return std::any_of(met.at.begin(), met.at.begin() + met.count,
                       [&](const Crossing<Real>& crossing) { return crossing.t >= begin && crossing.t <= end; });
}

// Calls visit(triangle's index, t, weights, end) for triangles that are met with begin <= t <= end; visit may bring `end`
// nearer. Stops when visit gives true, which is then the result.
template <class Real, class Visit>
bool forEachMet(const RayScene<Real>& scene, const Ray<Real>& ray, Real begin, Real end, Visit visit) {
    const TriangleRay<Real> line(ray);
    return forEachNear(scene.tree, line, begin, end, [&](std::uint32_t i, Real& nearest) {
        Real t;
        Vec3<Real> weights;
        return line.meets(scene.triangles[i].corners, t, weights) && t >= begin && t <= nearest &&
               visit(i, t, weights, nearest);
    });
}

}  // namespace

template <class Real>
RayCamera<Real> makeCamera(const Scene& scene) {
    const Camera& c = scene.camera;
    RayCamera<Real> camera;
    camera.perspective = c.projection == ProjectionKind::Perspective;
    camera.centre = Vec2<Real>(scene.settings.width, scene.settings.height) / Real(2);
    if (c.kind == CameraKind::Spherical) {
        const auto theta = sinCos<Real>(c.theta), phi = sinCos<Real>(c.phi);
        const Vec3<Real> outwards{phi.sin * theta.cos, phi.sin * theta.sin, phi.cos};
        camera.eye = Real(c.rho) * outwards;
        camera.forward = -outwards;
        camera.right = {-theta.sin, theta.cos, 0};
        camera.up = {-phi.cos * theta.cos, -phi.cos * theta.sin, phi.sin};
        camera.scale = Real(c.pixelsPerUnit) * Real(c.screenDistance);
        // Orthographic: as large as the perspective picture shows the origin.
        if (!camera.perspective && c.rho != 0) camera.scale /= Real(c.rho);
    } else {
        camera.eye = Vec3<Real>(c.eye);
        const Vec3<Real> up = unit(Vec3<Real>(c.up));
        camera.forward = unit(Vec3<Real>(c.target) - camera.eye);
        if (camera.forward == Vec3<Real>(0)) camera.forward = leastAligned(up);
        camera.right = unit(glm::cross(camera.forward, up));
        if (camera.right == Vec3<Real>(0))
            camera.right = unit(glm::cross(camera.forward, leastAligned(camera.forward)));
        camera.up = glm::cross(camera.right, camera.forward);
        const auto half = sinCos<Real>(c.fovY / 2);
        camera.scale =
            camera.perspective ? camera.centre.y * half.cos / half.sin : Real(scene.settings.height) / Real(c.height);
    }
    camera.near = c.near != 0 ? Real(c.near) : camera.perspective ? std::numeric_limits<Real>::min() : -kInfinity<Real>;
    if (c.far != 0) camera.far = Real(c.far);
    return camera;
}

template <class Real>
Ray<Real> RayCamera<Real>::through(Vec2<Real> pixel) const {
    const Vec3<Real> across = (pixel.x - centre.x) / scale * right + (centre.y - pixel.y) / scale * up;
    return perspective ? Ray<Real>{eye, forward + across} : Ray<Real>{eye + across, forward};
}

template <class Real>
Vec2<Real> RayCamera<Real>::placeOf(Vec3<Real> position) const {
    const Vec3<Real> from = position - eye;
    const Real size = perspective ? scale / glm::dot(from, forward) : scale;
    return {centre.x + size * glm::dot(from, right), centre.y - size * glm::dot(from, up)};
}

template <class Real>
Vec3<Real> RayCamera<Real>::fromSurface(Vec3<Real> position) const {
    return perspective ? unit(eye - position) : -forward;
}

bool isInvertible(const ObjectTransform& transform) {
    const Mat3<double> m = linearPart<double>(transform);
    const double determinant = glm::dot(m[0], glm::cross(m[1], m[2]));
    return std::isnormal(determinant) && std::isnormal(1 / determinant);
}

template <class Real>
RayScene<Real> makeRayScene(const Scene& scene, RaySurfaces surfaces) {
    RayScene<Real> out;
    out.camera = makeCamera<Real>(scene);
    out.cullsBack = scene.settings.cull == CullMode::Back;
    std::vector<RayTriangle<Real>> triangles;  // in the order of the scene
    for (std::uint32_t i = 0; i < scene.objects.size(); ++i) {
        const Object& object = scene.objects[i];
        RayObject<Real>& placed = out.objects.emplace_back();
        placed.isThere = !isTransparent(object, scene.settings);
        place(object, surfaces == RaySurfaces::Polygons, placed);
        if (placed.isThere && !placed.isShape) addTriangles(*object.mesh, i, placed, triangles);
    }
    out.tree = makeTree<Real>(std::uint32_t(triangles.size()), [&](std::uint32_t i) { return triangles[i].corners; });
    for (const std::uint32_t i : std::exchange(out.tree.order, {})) out.triangles.push_back(triangles[i]);
    return out;
}

template <class Real>
SurfacePoint<Real> firstSeen(const RayScene<Real>& scene, const Ray<Real>& ray) {
    const RayCamera<Real>& camera = scene.camera;
    SurfacePoint<Real> seen;
    forEachMet(scene, ray, camera.near, camera.far, [&](std::uint32_t i, Real t, Vec3<Real> weights, Real& end) {
        const RayTriangle<Real>& triangle = scene.triangles[i];
        const Vec3<Real> normal = scene.objects[triangle.object].polygonNormals[triangle.polygon];
        const Real facing = glm::dot(normal, ray.direction);
        if (normal == Vec3<Real>(0) || (scene.cullsBack && !(facing < 0))) return false;
        const bool isEarlier = seen.object < 0 || t < seen.t || int(triangle.object) < seen.object;
        if (isEarlier) seen = {int(triangle.object), t, {}, normal, facing > 0, i, weights, 0};
        end = seen.t;
        return false;
    });
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const RayObject<Real>& object = scene.objects[i];
        if (!object.isShape || !object.isThere) continue;
        const Crossings<Real> met = crossings(object.kind, inObject(object, ray));
        for (int j = 0; j < met.count; ++j) {
            const auto [t, direction] = met.at[std::size_t(j)];
            if (!(t >= camera.near && t <= camera.far)) continue;
            const Vec3<Real> normal = unit(object.normals * direction);
            const Real facing = glm::dot(normal, ray.direction);
            if (normal == Vec3<Real>(0) || (scene.cullsBack && !(facing < 0))) continue;
            if (t < seen.t || (t == seen.t && int(i) < seen.object))
                seen = {int(i), t, {}, normal, facing > 0, ~0u, {}, 0};
            break;
        }
    }
    if (seen.object < 0) return seen;
    seen.plane = seen.normal;
    if (seen.triangle != ~0u) {
        const auto& corners = scene.triangles[seen.triangle].corners;
        const Vec3<Real> across = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
        const RayObject<Real>& object = scene.objects[std::size_t(seen.object)];
        if (across != Vec3<Real>(0)) seen.plane = unit(object.mirrors ? -across : across);
    }
    seen.position = ray.at(seen.t);
    // The coordinates that go into t and the position are at most this large; some ten roundings each.
    const Real size = std::max({largest(ray.origin), largest(seen.t * ray.direction), largest(seen.position)});
    seen.rounding = 64 * std::numeric_limits<Real>::epsilon() * size;
    return seen;
}

template <class Real>
Blockers blockersBefore(const RayScene<Real>& scene, const SurfacePoint<Real>& from,
                        const std::array<Vec3<Real>, 4>& corners) {
    // Planes through the point that have the area on their positive side; and the surface's own.
    std::array<Vec3<Real>, 5> inside{};
    inside[4] = from.plane;
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec3<Real> normal = unit(glm::cross(corners[i] - from.position, corners[(i + 1) % 4] - from.position));
        inside[i] = glm::dot(normal, corners[(i + 2) % 4] - from.position) < 0 ? -normal : normal;
    }
    const auto reaches = [&](Vec3<Real> middle, Vec3<Real> half) {
        for (const Vec3<Real>& normal : inside)
            if (glm::dot(normal, middle - from.position) + glm::dot(glm::abs(normal), half) < -from.rounding)
                return false;
        return true;
    };
    Blockers out;
    if (!scene.tree.nodes.empty()) {
        std::vector<std::uint32_t> waiting{0};
        while (!waiting.empty()) {
            const auto& node = scene.tree.nodes[waiting.back()];
            waiting.pop_back();
            if (!reaches((node.low + node.high) / Real(2), (node.high - node.low) / Real(2))) continue;
            if (node.count == 0) {
                waiting.push_back(node.first);
                waiting.push_back(node.first + 1);
            }
            for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
                const auto& c = scene.triangles[i].corners;
                const Vec3<Real> low = glm::min(glm::min(c[0], c[1]), c[2]),
                                 high = glm::max(glm::max(c[0], c[1]), c[2]);
                if (reaches((low + high) / Real(2), (high - low) / Real(2)) && mayBlock(scene, from, i))
                    out.triangles.push_back(i);
            }
        }
    }
    for (std::uint32_t i = 0; i < scene.objects.size(); ++i) {
        const RayObject<Real>& object = scene.objects[i];
        const bool isOwn = int(i) == from.object && object.isConvex;
        if (object.isShape && object.isThere && !isOwn && reaches(object.middle, object.half)) out.shapes.push_back(i);
    }
    return out;
}

template <class Real>
bool isBlocked(const RayScene<Real>& scene, const SurfacePoint<Real>& from, const Ray<Real>& ray, Real end,
               const Blockers* among) {
    // So far along the ray the point may lie behind its own surface.
    const Real begin = from.rounding / glm::dot(from.plane, ray.direction);
    // One by one up to as many triangles as the tree would look at.
    constexpr std::size_t kFew = 24;
    if (!among || among->triangles.size() > kFew) {
        const bool byTriangle = forEachMet(
            scene, ray, begin, end, [&](std::uint32_t i, Real, Vec3<Real>, Real&) { return mayBlock(scene, from, i); });
        if (byTriangle) return true;
        for (std::size_t i = 0; i < scene.objects.size(); ++i)
            if (shapeBlocks(scene, from, i, ray, begin, end)) return true;
        return false;
    }
    const TriangleRay<Real> line(ray);
    for (const std::uint32_t i : among->triangles) {
        Real t;
        Vec3<Real> weights;
        if (line.meets(scene.triangles[i].corners, t, weights) && t >= begin && t <= end) return true;
    }
    return std::ranges::any_of(among->shapes,
                               [&](std::uint32_t i) { return shapeBlocks(scene, from, i, ray, begin, end); });
}

#define SHADESCOPE_INSTANTIATE(Real)                                                   \
    template RayCamera<Real> makeCamera(const Scene&);                                 \
    template struct RayCamera<Real>;                                                   \
    template RayScene<Real> makeRayScene(const Scene&, RaySurfaces);                   \
    template SurfacePoint<Real> firstSeen(const RayScene<Real>&, const Ray<Real>&);    \
    template Blockers blockersBefore(const RayScene<Real>&, const SurfacePoint<Real>&, \
                                     const std::array<Vec3<Real>, 4>&);                \
    template bool isBlocked(const RayScene<Real>&, const SurfacePoint<Real>&, const Ray<Real>&, Real, const Blockers*);
SHADESCOPE_INSTANTIATE(double)
SHADESCOPE_INSTANTIATE(long double)
#undef SHADESCOPE_INSTANTIATE

}  // namespace pipeline::rays
