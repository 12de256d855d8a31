#include "app/drawing3d/obstacles.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/drawing3d/normal_arrows.h"
#include "app/drawing3d/space_drawing.h"
#include "app/drawing3d/world_drawing.h"

namespace app {

namespace {

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

// A. M. Andrew, "Another efficient algorithm for convex hulls in two dimensions", Information Processing Letters, 1979.
std::vector<glm::dvec2> convexHull(std::vector<glm::dvec2> points) {
    std::ranges::sort(points, [](glm::dvec2 a, glm::dvec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    std::vector<glm::dvec2> hull;
    const auto add = [&hull](glm::dvec2 p, std::size_t from) {
        while (hull.size() >= from + 2 && cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0)
            hull.pop_back();
        hull.push_back(p);
    };
    for (const glm::dvec2 p : points) add(p, 0);
    const std::size_t lower = hull.size() - 1;
    for (auto p = points.rbegin() + 1; p != points.rend(); ++p) add(*p, lower);
    if (hull.size() > 1) hull.pop_back();
    return hull;
}

QRectF boundsOf(const std::vector<glm::dvec2>& points) {
    const auto [left, right] = std::ranges::minmax(points, {}, &glm::dvec2::x);
    const auto [top, bottom] = std::ranges::minmax(points, {}, &glm::dvec2::y);
    return {QPointF(left.x, top.y), QPointF(right.x, bottom.y)};
}

// Few points of each object say what it covers. Those that have none have been cut away by the near plane.
void addObjects(const ViewContent& content, std::vector<Obstacle>& obstacles) {
    constexpr std::size_t kPoints = 4096, kMost = 128, kMostObjects = 256;
    const ViewMesh& mesh = *content.mesh;
    const std::size_t objects = mesh.objects.size();
    if (objects == 0) return;
    if (objects > kMostObjects || !mesh.topology) {
        const auto corners = content.bounds.corners();
        obstacles.emplace_back(corners.begin(), corners.end());
        return;
    }
    const auto& first = mesh.topology->firstVertex;
    for (std::size_t i = 0; i < objects; ++i) {
        const std::size_t step = 1 + (first[i + 1] - first[i]) / std::min(kMost, kPoints / objects);
        Obstacle points;
        for (std::size_t v = first[i]; v < std::min<std::size_t>(first[i + 1], mesh.positions.size()); v += step)
            points.push_back(mesh.positions[v]);
        obstacles.push_back(std::move(points));
    }
}

// As many as can be told apart; more cover what they stand on.
void addNormals(const ViewContent& content, const ViewOptions& options, const ViewFrame& view,
                std::vector<Obstacle>& obstacles) {
    constexpr std::size_t kMany = 400;
    const std::size_t all = normalCount(*content.mesh, options.normals);
    if (all / options.everyOf(all) > kMany) return;
    const double length = options.normalLength * view.unitsPerMarkPixel();
    for (const NormalArrow& normal : shownNormals(content, options))
        obstacles.push_back({normal.base, normal.base + normal.length * length * normal.direction});
}

}  // namespace

std::vector<Obstacle> obstaclesOf(const ViewContent& content, const ViewOptions& options, const ViewFrame& view) {
    std::vector<Obstacle> obstacles;
    addObjects(content, obstacles);
    addNormals(content, options, view, obstacles);
    if (options.eye && content.map.keepsLengths() && showsWholeEye(content, view)) {
        const auto picture = pictureCorners(content.eye, content.pictureDistance);
        obstacles.emplace_back(picture.begin(), picture.end());
    }
    for (const LightFrustum& frustum : content.frusta) {
        if (!isShown(frustum, content, options)) continue;
        const auto plane = pictureCorners(frustum.view, frustum.plane);
        obstacles.emplace_back(plane.begin(), plane.end());
    }
    return obstacles;
}

std::optional<Outline> outlineOf(const Obstacle& obstacle, const ViewFrame& view) {
    constexpr double kLine = 14;  // pixels of the design
    std::vector<glm::dvec2> points;
    for (const Vec3d& point : obstacle)
        if (const Projected p = project(view.camera, view.size, point);
            p.inFront && std::isfinite(p.at.x) && std::isfinite(p.at.y))
            points.push_back(p.at);
    if (points.size() < 2 || (points.size() == 2 && points[0] == points[1])) return {};
    // As wide as a line is that words lie on, to be weighed like areas.
    if (points.size() == 2) return lineOutline(points[0], points[1], kLine * view.scale);
    Outline outline{convexHull(std::move(points)), {}};
    if (outline.corners.size() < 3) return {};
    outline.bounds = boundsOf(outline.corners);
    return outline;
}

// Y.-D. Liang and B. Barsky, "A new concept and method for line clipping", ACM Transactions on Graphics, 1984.
std::optional<SeenLine> seenPart(Vec3d a, Vec3d b, const ViewFrame& view) {
    Projected from = project(view.camera, view.size, a), to = project(view.camera, view.size, b);
    if (!from.inFront && !to.inFront) return {};
    // Of what begins or ends behind the observer nearly all that is before it.
    const auto before = [&](Vec3d front, double depth, Vec3d behind, double depthBehind) {
        return project(view.camera, view.size, glm::mix(front, behind, 0.99 * depth / (depth - depthBehind)));
    };
    const bool isWhole = to.inFront;
    if (!to.inFront) to = before(a, from.depth, b, to.depth);
    if (!from.inFront) from = before(b, to.depth, a, from.depth);
    const glm::dvec2 d = to.at - from.at;
    if (!std::isfinite(d.x) || !std::isfinite(d.y)) return {};
    double first = 0, last = 1;
    for (int i = 0; i < 2; ++i) {
        if (d[i] == 0 && (from.at[i] < 0 || from.at[i] > view.size[i])) return {};
        if (d[i] == 0) continue;
        const double toLow = -from.at[i] / d[i], toHigh = (view.size[i] - from.at[i]) / d[i];
        first = std::max(first, std::min(toLow, toHigh));
        last = std::min(last, std::max(toLow, toHigh));
    }
    if (!(first <= last)) return {};
    return SeenLine{from.at + first * d, from.at + last * d, isWhole && last == 1};
}

Outline lineOutline(glm::dvec2 a, glm::dvec2 b, double width) {
    const glm::dvec2 d = (b - a) * (width / (2 * glm::length(b - a))), across{-d.y, d.x};
    Outline outline{{a - across, b - across, b + across, a + across}, {}};
    outline.bounds = boundsOf(outline.corners);
    return outline;
}

// I. Sutherland and G. Hodgman, "Reentrant polygon clipping", Communications of the ACM, 1974; the area by the corners.
double covered(const Outline& outline, const QRectF& box) {
    if (!outline.bounds.intersects(box)) return 0;
    std::vector<glm::dvec2> inside = outline.corners;
    for (const auto& [axis, limit, sign] :
         {std::tuple{0, box.left(), 1.0}, {0, box.right(), -1.0}, {1, box.top(), 1.0}, {1, box.bottom(), -1.0}}) {
        std::vector<glm::dvec2> cut;
        for (std::size_t i = 0; i < inside.size(); ++i) {
            const glm::dvec2 a = inside[i], b = inside[(i + 1) % inside.size()];
            const double da = sign * (a[axis] - limit), db = sign * (b[axis] - limit);
            if (da >= 0) cut.push_back(a);
            if ((da >= 0) != (db >= 0)) cut.push_back(a + da / (da - db) * (b - a));
        }
        inside = std::move(cut);
    }
    double area2 = 0;
    for (std::size_t i = 0; i < inside.size(); ++i) area2 += cross(inside[i], inside[(i + 1) % inside.size()]);
    return std::abs(area2) / 2;
}

}  // namespace app
