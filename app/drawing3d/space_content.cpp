#include "app/drawing3d/space_content.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace app {

namespace {

// z_view − near, per vertex of the world.
double above(const ViewContent& world, std::uint32_t vertex) {
    return depthOf(world.eye, world.mesh->positions[vertex]) - world.eye.near;
}

// Cuts polygons at z_view = near; a cut edge gets one vertex, shared by all that have the edge.
class NearCut {
public:
    explicit NearCut(const ViewContent& world) : m_world(world) {
        for (std::uint32_t v = 0; v < world.mesh->positions.size(); ++v) m_above.push_back(above(world, v));
    }
    bool needed() const {
        return std::ranges::any_of(m_above, [](double above) { return above < 0; });
    }

    ViewMesh take() {
        m_mesh = *m_world.mesh;
        m_mesh.tree.reset();
        m_mesh.coarse.reset();
        m_mesh.faces.clear();
        m_mesh.edges.clear();
        for (const Face& face : m_world.mesh->faces) cut(face);
        for (const auto& [a, b] : m_world.mesh->edges) {
            if (m_above[a] < 0 && m_above[b] < 0) continue;
            m_mesh.edges.emplace_back(m_above[a] < 0 ? between(a, b) : a, m_above[b] < 0 ? between(a, b) : b);
        }
        return std::move(m_mesh);
    }

private:
    std::uint32_t between(std::uint32_t a, std::uint32_t b) {
        const auto [place, isNew] = m_mesh.cuts.try_emplace(std::minmax(a, b), std::uint32_t(m_mesh.positions.size()));
        if (isNew) {
            const double t = m_above[a] / (m_above[a] - m_above[b]);
            m_mesh.positions.push_back(glm::mix(m_mesh.positions[a], m_mesh.positions[b], t));
            for (std::vector<glm::vec3>* of : {&m_mesh.vertexColors, &m_mesh.vertexNormals})
                if (!of->empty()) of->push_back(glm::mix((*of)[a], (*of)[b], float(t)));
        }
        return place->second;
    }

    // I. E. Sutherland and G. W. Hodgman, "Reentrant polygon clipping", Communications of the ACM, 1974.
    void cut(const Face& face) {
        std::vector<std::uint32_t> kept;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t a = face.vertices[i], b = face.vertices[(i + 1) % 3];
            if (m_above[a] >= 0) kept.push_back(a);
            if ((m_above[a] < 0) != (m_above[b] < 0)) kept.push_back(between(a, b));
        }
        for (std::size_t i = 2; i < kept.size(); ++i)
            m_mesh.faces.push_back({{kept[0], kept[i - 1], kept[i]}, face.polygon, face.shaded, face.alpha});
    }

    const ViewContent& m_world;
    std::vector<double> m_above;  // per vertex of the world
    ViewMesh m_mesh;
};

// A polygon's outline, whose edges `mesh` has cut already.
std::vector<std::uint32_t> cutLoop(const ViewContent& world, const ViewMesh& mesh,
                                   const std::vector<std::uint32_t>& loop) {
    std::vector<std::uint32_t> kept;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const std::uint32_t a = loop[i], b = loop[(i + 1) % loop.size()];
        if (above(world, a) >= 0) kept.push_back(a);
        if (const auto cut = mesh.cuts.find(std::minmax(a, b)); cut != mesh.cuts.end()) kept.push_back(cut->second);
    }
    return kept;
}

double meanEdge(const ViewMesh& mesh) {
    double sum = 0;
    for (const auto& [a, b] : mesh.edges) sum += glm::length(mesh.positions[a] - mesh.positions[b]);
    return mesh.edges.empty() ? 0 : sum / double(mesh.edges.size());
}

Bounds boundsOf(const ViewMesh& mesh) {
    Bounds bounds;
    for (const Vec3d& p : mesh.positions) bounds.add(p);
    bounds.giveExtent();
    return bounds;
}

// Corners made by the cut lie on the near plane but for their rounding.
bool hasPlace(const pipeline::View& eye, const SpaceMap& map, Vec3d p) {
    return map.keepsLengths() || depthOf(eye, p) >= eye.near - 1e-9 * std::abs(eye.near);
}

// Of a mesh that is cut at the near plane where the map asks for it.
ViewMesh moved(ViewMesh mesh, const pipeline::View& eye, const SpaceMap& map) {
    mesh.tree.reset();
    // What was cut off is no polygon's corner any more: any place does.
    for (Vec3d& p : mesh.positions) p = hasPlace(eye, map, p) ? map.toSpace(p) : Vec3d(0.0);
    mesh.hasAngles = map.keepsLengths();
    mesh.meanEdge = meanEdge(mesh);
    return mesh;
}

void moveRigidly(const SpaceMap& map, ViewContent& content) {
    for (LightMark& light : content.lights) {
        light.direction = map.turned(light.direction);
        light.position = map.toSpace(light.position);
    }
    for (LightFrustum& frustum : content.frusta) frustum.view = map.turned(frustum.view);
    content.eye = map.turned(content.eye);
    for (VectorArrow& v : content.vectors) v.base = map.toSpace(v.base), v.direction = map.turned(v.direction);
    for (SpecularLobe& lobe : content.lobes) {
        lobe.base = map.toSpace(lobe.base);
        lobe.axis = map.turned(lobe.axis);
        lobe.probe = map.turned(lobe.probe);
    }
}

void leaveOutAngles(const SpaceMap& map, ViewContent& content) {
    content.vectors.clear();
    content.lobes.clear();
    content.lights.clear();
    content.frusta.clear();
    content.eye = flatEye(map);
    content.pictureDistance = 0;
    const SpaceBox box = visibleBox(map);
    content.bounds = {box.min, box.max, true};
}

// Of content that is cut likewise; its mesh is in its place already.
ViewContent withMoved(ViewContent content, std::shared_ptr<const ViewMesh> mesh, const SpaceMap& map) {
    for (std::optional<Vec3d>* p : {&content.point, &content.foot, &content.markedVertex})
        if (*p) *p = hasPlace(content.eye, map, **p) ? std::optional(map.toSpace(**p)) : std::nullopt;
    if (auto& ray = content.stepRay; ray && hasPlace(content.eye, map, ray->to))
        ray->from = map.toSpace(ray->from), ray->to = map.toSpace(ray->to);
    else
        ray.reset();
    content.mesh = std::move(mesh);
    content.map = map;
    map.keepsLengths() ? moveRigidly(map, content) : leaveOutAngles(map, content);
    return content;
}

// In world space, with the polygons of `mesh`: `world` cut at the near plane.
ViewContent cutWith(const ViewContent& world, std::shared_ptr<const ViewMesh> mesh) {
    ViewContent result = world;
    result.pickedLoop = cutLoop(world, *mesh, world.pickedLoop);
    result.markedLoop = cutLoop(world, *mesh, world.markedLoop);
    if (world.markedVertex && depthOf(world.eye, *world.markedVertex) < world.eye.near) result.markedVertex.reset();
    result.mesh = std::move(mesh);
    return result;
}

// Where a point stands before a camera, in units of the distance to what it looks at.
Vec3d before(const OrbitCamera& camera, Vec3d p) {
    const Vec3d d = (p - camera.target) / camera.distance;
    return {glm::dot(d, camera.right), glm::dot(d, camera.up), glm::dot(d, camera.forward)};
}

Vec3d placedBefore(const OrbitCamera& camera, Vec3d q) {
    return camera.target + camera.distance * (q.x * camera.right + q.y * camera.up + q.z * camera.forward);
}

}  // namespace

std::optional<SpaceMap> mapOf(const ViewContent& world, SpaceId id) {
    switch (id.space) {
        case ViewSpace::World: return SpaceMap{};
        case ViewSpace::Eye:
        case ViewSpace::Clip:
        case ViewSpace::Screen: return SpaceMap{.space = id.space, .view = world.eye};
        case ViewSpace::Point: return {};
        case ViewSpace::Light: break;
    }
    for (const LightFrustum& frustum : world.frusta)
        if (frustum.light == id.light && (id.face < 0 || frustum.face == id.face))
            return SpaceMap{id.space, frustum.view, frustum.light, frustum.face};
    return {};
}

ViewContent clippedAtNear(const ViewContent& world) {
    NearCut cut(world);
    return cut.needed() ? cutWith(world, std::make_shared<const ViewMesh>(cut.take())) : world;
}

ViewContent inSpace(const ViewContent& world, const SpaceMap& map, const ViewContent* before) {
    if (map.space == ViewSpace::World) return world;
    const bool isSame = before && before->world == world.mesh && before->map == map;
    const bool cuts = !map.keepsLengths();
    ViewContent content = !cuts ? world : isSame ? cutWith(world, before->mesh) : clippedAtNear(world);
    const auto mesh = isSame ? before->mesh : std::make_shared<const ViewMesh>(moved(*content.mesh, world.eye, map));
    content = withMoved(std::move(content), mesh, map);
    if (!cuts) content.bounds = isSame ? before->bounds : boundsOf(*mesh);
    content.world = world.mesh;
    return content;
}

SpaceMorph::SpaceMorph(const ViewContent& world, const SpaceMap& mapFrom, const OrbitCamera& from,
                       const SpaceMap& mapTo, const OrbitCamera& to)
    : m_from(from), m_to(to) {
    const bool cut = !(mapFrom.keepsLengths() && mapTo.keepsLengths());
    const ViewContent both = cut ? clippedAtNear(world) : world;
    const ViewMesh begin = moved(*both.mesh, both.eye, mapFrom);
    ViewMesh mesh = moved(*both.mesh, both.eye, mapTo);
    m_end = mesh.positions;
    for (const Vec3d& p : begin.positions) m_begin.push_back(placedBefore(to, before(from, p)));
    mesh.hasAngles = false;
    mesh.objects.clear();
    mesh.picture = {};
    m_content = withMoved(both, std::make_shared<const ViewMesh>(std::move(mesh)), mapTo);
    if (mapTo.keepsLengths()) m_content.bounds = boundsOf(*m_content.mesh);
    m_content.vectors.clear();
    m_content.lobes.clear();
    m_content.lights.clear();
    m_content.frusta.clear();
    m_content.markedBox.reset();
    m_content.markedVertex.reset();
    m_content.point.reset();
    m_content.foot.reset();
}

ViewContent SpaceMorph::content(double t) const {
    ViewContent result = m_content;
    ViewMesh mesh = *m_content.mesh;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) mesh.positions[i] = glm::mix(m_begin[i], m_end[i], t);
    mesh.meanEdge = meanEdge(mesh);
    result.mesh = std::make_shared<const ViewMesh>(std::move(mesh));
    return result;
}

OrbitCamera SpaceMorph::camera(double t) const {
    OrbitCamera camera = m_to;
    camera.fovY = glm::mix(m_from.fovY, m_to.fovY, t);
    return camera;
}

}  // namespace app
