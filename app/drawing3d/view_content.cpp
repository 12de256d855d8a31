#include "app/drawing3d/view_content.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "app/drawing3d/face_colors.h"
#include "app/drawing3d/handles.h"
#include "app/drawing3d/view_mesh.h"
#include "pipeline/illumination/illumination.h"
#include "pipeline/scene/mesh/topology.h"

namespace app {

using pipeline::BufferId;
using pipeline::Frame;

namespace {

void addLights(const pipeline::Scene& scene, ViewContent& content) {
    const std::vector<pipeline::Light> lights = pipeline::lightsInWorldSpace(scene, content.eye);
    for (std::size_t k = 0; k < lights.size(); ++k) {
        const pipeline::Light& light = lights[k];
        LightMark mark;
        mark.light = int(k);
        mark.caption = "light " + std::to_string(k);
        mark.atInfinity = light.kind == pipeline::LightKind::AtInfinity;
        if (mark.atInfinity) {
            const double length = glm::length(light.position);
            if (!(length > 0)) continue;
            mark.direction = light.position / length;
            mark.caption += ", at infinity";
        } else {
            mark.position = light.position;
            if (light.kind == pipeline::LightKind::Area) mark.caption += ", centre of an area";
        }
        content.lights.push_back(mark);
    }
}

// Lecture 1's screen stands at its own distance from the eye. Another camera's picture plane has
// no distance of its own; a quarter of the way to the scene shows it well.
double pictureDistance(const pipeline::Scene& scene, const ViewContent& content) {
    if (scene.camera.kind == pipeline::CameraKind::Spherical && scene.camera.screenDistance > 0)
        return scene.camera.screenDistance;
    const double depth = glm::dot(content.bounds.centre() - content.eye.eye, content.eye.forward);
    return depth > 0 ? depth / 4 : std::max(content.eye.near, content.bounds.radius() / 4);
}

void addPicture(const Frame& frame, ViewMesh& mesh) {
    const auto color = frame.buffer({BufferId::Color});
    if (!color) return;
    mesh.picture.size = {int(color->columns()), int(color->rows())};
    const auto bytes = std::get<std::span<const std::uint8_t>>(color->data);
    mesh.picture.pixels.resize(bytes.size() / 3);
    std::memcpy(mesh.picture.pixels.data(), bytes.data(), bytes.size());
}

std::string letterOf(std::string letter, int light, std::size_t lights) {
    static constexpr const char* kDigits[]{"₀", "₁", "₂", "₃", "₄", "₅", "₆", "₇", "₈", "₉"};
    if (lights > 1)
        for (const char digit : std::to_string(light)) letter += kDigits[digit - '0'];
    return letter;
}

void addVectors(const pipeline::PixelReport& report, ViewContent& content) {
    const auto add = [&](VectorCode code, int light, const char* letter, const pipeline::Evaluation& at, Vec3d v,
                         bool main) {
        const double length = glm::length(v);
        if (!finite(v) || !(length > 0)) return;
        const std::size_t lights = light < 0 ? 1 : at.lights.size();
        content.vectors.push_back({code, light, at.position, v / length, main, letterOf(letter, light, lights)});
    };
    const auto heaviest = std::ranges::max_element(report.evaluations, {}, &pipeline::Evaluation::weight);
    for (auto at = report.evaluations.begin(); at != report.evaluations.end(); ++at) {
        const bool main = at == heaviest;
        if (main) content.foot = at->position;
        add(VectorCode::N, -1, "N", *at, at->N, main);
        add(VectorCode::V, -1, "V", *at, at->V, main);
        for (const pipeline::LightReport& light : at->lights) {
            add(VectorCode::L, light.light, "L", *at, light.L, main);
            // From behind nothing is mirrored and nothing lies half way: the bracket does not count.
            if (!(light.nDotL > 0)) continue;
            add(VectorCode::R, light.light, "R", *at, light.R, main);
            add(VectorCode::H, light.light, "H", *at, light.H, main);
        }
    }
}

void addLobes(const pipeline::Scene& scene, const pipeline::PixelReport& report, ViewContent& content) {
    const pipeline::Object& object = scene.objects[std::size_t(report.object)];
    const pipeline::Material& material = pipeline::effectiveMaterial(object, scene.settings, report.back);
    const pipeline::Model model = scene.settings.model;
    if (material.specular == Vec3d(0.0) || pipeline::modelFacts(model).lobe == pipeline::Lobe::None) return;
    const bool halfway = pipeline::usesHalfway(model, material);
    const double exponent = pipeline::effectiveExponent(model, scene.settings.exponentFactor, material);
    for (const pipeline::Evaluation& at : report.evaluations)
        for (const pipeline::LightReport& light : at.lights) {
            const Vec3d axis = halfway ? light.H : light.R, probe = halfway ? at.N : at.V;
            if (!(light.nDotL > 0) || !finite(axis) || !(glm::length(axis) > 0)) continue;
            content.lobes.push_back({halfway ? VectorCode::H : VectorCode::R, light.light, at.position,
                                     glm::normalize(axis), glm::normalize(probe), exponent, light.specularPower,
                                     content.foot == at.position});
        }
}

void addReport(const Frame& frame, const pipeline::PixelReport& report, ViewContent& content) {
    const pipeline::Topology& topology = frame.topology();
    if (content.mesh->positions.empty() || !report.covered || report.polygon < 0 ||
        std::size_t(report.polygon) >= topology.polygonCount())
        return;
    content.point = report.position;
    content.pickedPolygon = report.polygon;
    const auto corners = topology.corners(std::size_t(report.polygon));
    for (std::size_t i = 0; i < corners.size(); ++i) content.pickedLoop.push_back(corners[i]);
    addVectors(report, content);
    addLobes(frame.scene(), report, content);
}

}  // namespace

void Bounds::add(Vec3d point) {
    if (!finite(point)) return;
    min = any ? glm::min(min, point) : point;
    max = any ? glm::max(max, point) : point;
    any = true;
}

void Bounds::giveExtent() {
    if (any && radius() > 0) return;
    const Vec3d middle = any ? centre() : Vec3d(0.0);
    add(middle - 0.5);
    add(middle + 0.5);
}

std::array<Vec3d, 8> Bounds::corners() const {
    std::array<Vec3d, 8> result;
    for (std::size_t i = 0; i < 8; ++i)
        result[i] = {(i & 1 ? max : min).x, (i & 2 ? max : min).y, (i & 4 ? max : min).z};
    return result;
}

ViewContent contentOf(const Frame& frame, std::optional<glm::ivec2> pixel, const ViewContent* before,
                      const std::stop_token& stop, const Frame* placed) {
    ViewContent content;
    const pipeline::Topology& topology = frame.topology();
    auto mesh = std::make_shared<ViewMesh>();
    addPolygons(placed ? *placed : frame, before ? before->mesh.get() : nullptr, stop, *mesh, content.bounds);
    content.bounds.giveExtent();
    colorFaces(frame, topology, *mesh, stop);
    addNormals(frame, stop, *mesh);
    if (!stop.stop_requested()) addPicture(frame, *mesh);
    content.mesh = std::move(mesh);
    content.eye = pipeline::makeView(frame.scene());
    addLights(frame.scene(), content);
    content.pictureDistance = pictureDistance(frame.scene(), content);
    return pixel && !stop.stop_requested() ? withPixel(content, frame, pixel, stop) : content;
}

ViewContent withPixel(const ViewContent& content, const Frame& frame, std::optional<glm::ivec2> pixel,
                      const std::stop_token& stop) {
    const glm::ivec2 size = content.eye.size;
    const bool isInside = pixel && pixel->x >= 0 && pixel->y >= 0 && pixel->x < size.x && pixel->y < size.y;
    if (!isInside || frame.until() < pipeline::StageId::ZBuffer) return withReport(content, frame, nullptr);
    const pipeline::PixelReport report = pipeline::inspectPixel(frame, *pixel, stop);
    return withReport(content, frame, &report);
}

ViewContent withReport(const ViewContent& content, const Frame& frame, const pipeline::PixelReport* report) {
    ViewContent result = content;
    result.point.reset();
    result.foot.reset();
    result.pickedPolygon = -1;
    result.pickedLoop.clear();
    result.vectors.clear();
    result.lobes.clear();
    if (report) addReport(frame, *report, result);
    return result;
}

ViewContent withSelection(const ViewContent& content, const Frame& frame,
                          const std::optional<lessons::Selection>& selection) {
    ViewContent result = content;
    result.markedLoop.clear();
    result.markedBox.reset();
    result.markedVertex.reset();
    const ViewMesh& mesh = *content.mesh;
    if (!selection || mesh.positions.empty() || !isIn(frame.scene(), *selection)) return result;
    switch (selection->kind) {
        case lessons::Selection::Kind::Polygon: {
            const auto corners = frame.topology().corners(selection->index);
            for (std::size_t i = 0; i < corners.size(); ++i) result.markedLoop.push_back(corners[i]);
            break;
        }
        case lessons::Selection::Kind::Object: result.markedBox = mesh.objects[selection->index].box; break;
        case lessons::Selection::Kind::Vertex: result.markedVertex = mesh.positions[selection->index]; break;
        case lessons::Selection::Kind::Light: break;
    }
    return result;
}

pipeline::BufferSet contentBuffers(const pipeline::Scene& scene, bool vertexNormals) {
    using pipeline::Shading;
    const Shading shading = scene.settings.shading;
    pipeline::BufferSet set = pipeline::setOf({BufferId::VerticesWorld, BufferId::PolygonsVerdict,
                                               BufferId::PolygonsNormal, BufferId::PolygonId, BufferId::Color});
    if (shading == Shading::Flat) set |= pipeline::setOf({BufferId::PolygonsIntensity});
    if (shading == Shading::Gouraud) set |= pipeline::setOf({BufferId::VerticesIntensity});
    if (shading == Shading::Phong || vertexNormals) set |= pipeline::setOf({BufferId::VerticesNormal});
    return set;
}

namespace {

struct MetFace {
    double distance;
    std::uint32_t face;
};

// The first one up to `nearest`.
std::optional<MetFace> firstFace(const ViewMesh& mesh, const Ray& ray, double nearest) {
    const pipeline::rays::TriangleRay<double> line(ray);
    std::optional<std::uint32_t> first;
    // Of two at the same distance it is the one that comes first in the mesh.
    const auto meet = [&](std::uint32_t face) {
        double t;
        Vec3d weights;
        if (!line.meets(cornersOf(mesh, face), t, weights) || !(t > 0) || t > nearest) return;
        if (t == nearest && first && face > *first) return;
        nearest = t;
        first = face;
    };
    if (mesh.tree)
        forEachNear(*mesh.tree, line, 0.0, nearest, [&](std::uint32_t place, double& end) {
            meet(mesh.tree->order[place]);
            end = nearest;
            return false;
        });
    else
        for (std::uint32_t i = 0; i < mesh.faces.size(); ++i) meet(i);
    if (!first) return {};
    return MetFace{nearest, *first};
}

// z_view of the farthest corner of a tree's box, and a little more.
double farthestOf(const FaceTree& tree, const pipeline::View& view) {
    const auto& [low, high, first, count] = tree.nodes.front();
    const Bounds box{low, high, true};
    double farthest = 0;
    for (const Vec3d& corner : box.corners()) farthest = std::max(farthest, depthOf(view, corner));
    return farthest * (1 + 1e-9);
}

}  // namespace

// Of many faces that were moved through the tree of the world's: lines stay lines in every space.
std::optional<Hit> firstHit(const ViewContent& content, const Ray& ray) {
    constexpr double kForEver = std::numeric_limits<double>::infinity();
    const bool throughWorld = content.world && content.world->tree && !content.world->tree->nodes.empty();
    if (!throughWorld) {
        const auto met = firstFace(*content.mesh, ray, kForEver);
        if (!met) return {};
        return Hit{ray.at(met->distance), met->distance, content.mesh->faces[met->face].polygon};
    }
    const auto there = content.map.toWorld(ray, farthestOf(*content.world->tree, content.map.view));
    const auto met = there ? firstFace(*content.world, there->ray, there->length) : std::nullopt;
    if (!met) return {};
    const Vec3d at = content.map.toSpace(there->ray.at(met->distance));
    return Hit{at, glm::dot(at - ray.origin, ray.direction), content.world->faces[met->face].polygon};
}

Shown pixelShowing(const Frame& frame, const ViewContent& content, const Hit& hit) {
    const pipeline::View& eye = content.eye;
    const Vec3d d = hit.at - eye.eye;
    const double zView = glm::dot(d, eye.forward);
    if (zView < eye.near || zView > eye.far)
        return {{}, "That point is outside the range between the near and the far plane."};
    const double spread = eye.perspective ? zView : 1;
    const glm::dvec2 at{eye.centre.x + eye.scale.x * glm::dot(d, eye.right) / spread,
                        eye.centre.y - eye.scale.y * glm::dot(d, eye.up) / spread};
    const glm::dvec2 floor = glm::floor(at);
    if (!(floor.x >= 0 && floor.y >= 0 && floor.x < eye.size.x && floor.y < eye.size.y))
        return {{}, "That point lies outside the picture."};
    const auto ids = frame.buffer({BufferId::PolygonId});
    if (!ids) return {{}, "The z-buffer has not run yet, so no pixel shows that point."};
    // The polygon's own pixel, or a neighbour's where the point is near an edge.
    const glm::ivec2 pixel(floor);
    for (const glm::ivec2 step : {glm::ivec2{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
        const glm::ivec2 p = pixel + step;
        if (p.x < 0 || p.y < 0 || p.x >= eye.size.x || p.y >= eye.size.y) continue;
        if (std::int32_t(ids->value(std::size_t(p.x), std::size_t(p.y))) == hit.polygon) return {p, {}};
    }
    return {
        {},
        "The eye does not see that point: polygon " + std::to_string(hit.polygon) + " is turned away or hidden there."};
}

std::optional<Vec3d> pointShownBy(const ViewContent& content, glm::ivec2 pixel) {
    const pipeline::View& eye = content.eye;
    const glm::dvec2 centre = glm::dvec2(pixel) + 0.5;
    const Vec3d start = pipeline::worldPoint(eye, centre, eye.near), end = pipeline::worldPoint(eye, centre, eye.far);
    if (!(glm::length(end - start) > 0)) return {};
    const auto hit = firstHit(content, {start, glm::normalize(end - start)});
    if (!hit) return {};
    return hit->at;
}

std::array<Vec3d, 4> pictureCorners(const pipeline::View& view, double distance) {
    const glm::dvec2 s(view.size);
    return {pipeline::worldPoint(view, {0, 0}, distance), pipeline::worldPoint(view, {s.x, 0}, distance),
            pipeline::worldPoint(view, s, distance), pipeline::worldPoint(view, {0, s.y}, distance)};
}

namespace {

// Where no polygon is tested, or it is seen from its edge, to what the pixel shows.
std::optional<ViewContent::StepRay> rayTo(const ViewContent& content, const pipeline::Steps& steps, glm::ivec2 pixel,
                                          std::optional<std::size_t> polygon) {
    const glm::dvec2 centre = glm::dvec2(pixel) + 0.5;
    const Vec3d from = pipeline::worldPoint(content.eye, centre, content.eye.near);
    const Vec3d along = pipeline::worldPoint(content.eye, centre, content.eye.far) - from;
    if (polygon) {
        const auto& positions = content.mesh->positions;
        const auto corners = steps.frame()->topology().corners(*polygon);
        Vec3d normal(0);  // Newell's
        for (std::size_t i = 0; i < corners.size(); ++i)
            normal += glm::cross(positions[corners[i]] - positions[corners[0]],
                                 positions[corners[(i + 1) % corners.size()]] - positions[corners[0]]);
        const double share = glm::dot(positions[corners[0]] - from, normal) / glm::dot(along, normal);
        if (share >= 0 && share <= 1) return ViewContent::StepRay{pixel, from, from + share * along};
    }
    const auto shown = pointShownBy(content, pixel);
    return shown ? std::optional(ViewContent::StepRay{pixel, from, *shown}) : std::nullopt;
}

}  // namespace

ViewContent withProgress(const ViewContent& content, const pipeline::Steps& steps, pipeline::Moment moment) {
    ViewContent result = content;
    const std::vector<std::uint8_t> done = steps.polygonsDone(moment);
    const auto current = steps.polygonOf(moment);
    auto mesh = std::make_shared<ViewMesh>(*content.mesh);
    for (Face& face : mesh->faces) {
        const auto polygon = std::size_t(face.polygon);
        face.shaded = polygon < done.size() && (done[polygon] || current == polygon);
    }
    result.mesh = std::move(mesh);
    if (current && result.markedLoop.empty() && !result.markedBox && !result.markedVertex) {
        const auto corners = steps.frame()->topology().corners(*current);
        for (std::size_t i = 0; i < corners.size(); ++i) result.markedLoop.push_back(corners[i]);
    }
    if (const auto pixel = steps.pixelOf(moment)) result.stepRay = rayTo(content, steps, *pixel, current);
    return result;
}

}  // namespace app
