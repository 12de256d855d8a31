#include "app/drawing3d/world_drawing.h"

#include "app/drawing3d/aids_drawing.h"
#include "app/drawing3d/lobe_drawing.h"
#include "app/drawing3d/obstacles.h"
#include "app/drawing3d/space_drawing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace app {

namespace {

constexpr double kShaftRadius = 2, kDiscRadius = 5;  // pixels of the design
constexpr double kGridReach = 3.2;                   // of the scene's radius

// Grid lines are cut into pieces so that they can fade away from the scene.
float gridStrength(double distance, double radius) {
    const double t = std::clamp((distance / radius - 0.8) / (kGridReach - 0.8), 0.0, 1.0);
    return float(1 - t * t * (3 - 2 * t));
}

// Height of the ground: the plane z = 0 when it is at the scene's foot or below within reach.
double groundHeight(const ViewContent& content) {
    const Bounds& b = content.bounds;
    return b.min.z >= 0 && b.min.z <= b.radius() ? 0.0 : b.min.z;
}

// The axes start at the space's origin, or where that is far off, at the foot of the scene's bounds.
Vec3d axesOrigin(const ViewContent& content) {
    const Bounds& b = content.bounds;
    if (content.map.space == ViewSpace::Clip) return Vec3d(0.0);
    if (content.map.space == ViewSpace::Screen) return {b.min.x, b.min.y, b.max.z};  // the top left corner
    return glm::length(b.centre()) <= kGridReach * b.radius() ? Vec3d(0.0)
                                                              : Vec3d(b.min.x, b.min.y, groundHeight(content));
}

double axisLength(const ViewContent& content) {
    if (content.map.space == ViewSpace::Screen) return 1.12 * (content.bounds.max.z - content.bounds.min.z);
    return content.bounds.radius() * 0.8;
}

// Where the middle ray of a light at infinity begins, and the way to its neighbours.
struct RayPlace {
    Vec3d disc, aside;
    double length;
};
RayPlace raysOf(const LightMark& light, const ViewContent& content) {
    const double r = content.bounds.radius();
    Vec3d aside = glm::cross(light.direction, Vec3d(0, 0, 1));
    if (!(glm::length(aside) > 1e-6)) aside = {1, 0, 0};
    // A little beyond where the ray from the middle leaves the bounds.
    const Vec3d half = (content.bounds.max - content.bounds.min) / 2.0, d = glm::abs(light.direction);
    double leaves = r;
    for (int i = 0; i < 3; ++i)
        if (d[i] > 0) leaves = std::min(leaves, half[i] / d[i]);
    return {content.bounds.centre() + (leaves + 0.7 * r) * light.direction, 0.2 * r * glm::normalize(aside), 0.42 * r};
}

std::string unitsAway(double distance) { return ", " + threeDigits(distance) + " units away"; }

// Whether a face stands clearly before a point; the face that it lies on is as far as the point.
bool isHidden(const ViewContent& content, const OrbitCamera& camera, Vec3d point) {
    const Vec3d origin =
        camera.orthographic
            ? point -
                  (camera.distance + glm::length(point - camera.target) + 2 * content.bounds.radius()) * camera.forward
            : camera.position();
    const Vec3d d = point - origin;
    if (!(glm::length(d) > 0)) return false;
    const auto hit = firstHit(content, {origin, glm::normalize(d)});
    return hit && hit->distance < glm::length(d) - 1e-3 * content.bounds.radius();
}

class WorldPainter {
public:
    WorldPainter(const ViewContent& content, const ViewOptions& options, const ViewFrame& view)
        : m_content(content), m_options(options), m_view(view) {
        m_unit = view.unitsPerMarkPixel();
    }

    Drawing take() {
        if (m_options.vectors || m_options.lobe) vectors();
        if (m_options.lights)
            for (const LightMark& light : m_content.lights)
                light.atInfinity ? raysAtInfinity(light) : pointLight(light);
        if (m_options.eye) eye();
        aids();
        axes();
        std::ranges::move(obstaclesOf(m_content, m_options, m_view), std::back_inserter(m_drawing.obstacles));
        return std::move(m_drawing);
    }

private:
    Vec3d towardsObserver(Vec3d point) const {
        const OrbitCamera& camera = m_view.camera;
        const Vec3d d = camera.position() - point;
        return camera.orthographic || !(glm::length(d) > 0) ? -camera.forward : glm::normalize(d);
    }
    // World units that a pixel of the design spans at a point: what keeps its size on the screen is scaled by it.
    double unitAt(Vec3d point) const { return m_view.scale * m_view.camera.unitsPerPixelAt(point, m_view.size.y); }
    // Marks far off or near keep their size; arrows share one scale, so that equal lengths look equal.
    void mark(Ink ink, Solid solid, Vec3d at, Vec3d along) {
        m_drawing.solids.push_back(
            {ink, placed(std::move(solid), {at, along, towardsObserver(at), unitAt(at)}), unitAt(at)});
    }

    void axes() {
        const Vec3d origin = axesOrigin(m_content);
        for (const SpaceAxis& axis : axesOf(m_content.map.space)) {
            const Vec3d end = origin + axisLength(m_content) * axis.direction;
            m_drawing.lines.push_back({origin, end, Ink::Outline, 1, 1});
            if (isHidden(m_content, m_view.camera, end)) continue;
            m_drawing.labels.push_back({.kind = Label::Kind::Axis,
                                        .at = end,
                                        .foot = origin,
                                        .text = axis.name,
                                        .distance = {},
                                        .ink = Ink::Hint});
        }
    }

    // In pixels at their base, whose size in the world is `unit`. In a wide view one that points to the observer would
    // else reach so near to it that its head covers everything.
    double vectorLength(Vec3d base, double unit) const {
        constexpr double kMostOfTheWay = 0.4;
        const OrbitCamera& camera = m_view.camera;
        if (camera.orthographic) return m_options.vectorLength;
        return std::min(m_options.vectorLength, kMostOfTheWay * glm::length(base - camera.position()) / unit);
    }

    void vectors() {
        for (const VectorArrow& v : m_content.vectors) {
            if (!m_options.shows(v.code)) continue;
            const double unit = unitAt(v.base), length = vectorLength(v.base, unit) * (v.main ? 1 : 0.6);
            const ShapePlacement placement{v.base, v.direction, towardsObserver(v.base), unit};
            m_drawing.vectors.push_back(
                {inkOf(v.code), arrow(v.code, length, kShaftRadius * (v.main ? 1 : 0.6), placement), unit});
            const Vec3d tip = v.base + length * unit * v.direction;
            if (!v.main) m_drawing.obstacles.push_back({v.base, tip});
            if (!v.main) continue;
            m_drawing.labels.push_back({.kind = Label::Kind::Letter,
                                        .at = tip,
                                        .foot = v.base,
                                        .text = v.letter,
                                        .distance = {},
                                        .ink = inkOf(v.code)});
        }
        for (const SpecularLobe& lobe : m_content.lobes)
            if (m_options.lobe)
                addLobe(lobe, vectorLength(lobe.base, unitAt(lobe.base)) * unitAt(lobe.base) * (lobe.main ? 1 : 0.6),
                        m_drawing);
        const auto marker = [this](const std::optional<Vec3d>& at) -> std::optional<Drawing::Marker> {
            if (!at) return {};
            return Drawing::Marker{*at, isHidden(m_content, m_view.camera, *at)};
        };
        m_drawing.foot = marker(m_content.foot);
        m_drawing.point = marker(m_content.point);
    }

    void raysAtInfinity(const LightMark& light) {
        const RayPlace rays = raysOf(light, m_content);
        for (const double k : {-1.0, 0.0, 1.0}) {
            const Vec3d disc = rays.disc + k * rays.aside;
            mark(Ink::L, ball({0, 0, 0}, kDiscRadius), disc, {0, 0, 1});
            dashedLine(disc, disc - rays.length * light.direction);
            m_drawing.obstacles.push_back(
                {disc + kDiscRadius * unitAt(disc) * light.direction, disc - rays.length * light.direction});
        }
        m_drawing.labels.push_back({.kind = Label::Kind::Caption,
                                    .at = rays.disc,
                                    .foot = m_content.bounds.centre(),
                                    .text = light.caption,
                                    .distance = {},
                                    .ink = Ink::L});
    }

    void pointLight(const LightMark& light) {
        Solid sun = ball({0, 0, 0}, 6);
        for (int i = 0; i < 8; ++i) {
            const double a = i * std::numbers::pi / 4;
            const Vec3d d{std::cos(a), std::sin(a), 0};
            append(sun, tube(9.0 * d, 13.0 * d, 0.9));
        }
        mark(Ink::L, sun, light.position, towardsObserver(light.position));
        m_drawing.labels.push_back({.kind = Label::Kind::Caption,
                                    .at = light.position,
                                    .foot = m_content.bounds.centre(),
                                    .text = light.caption,
                                    .distance = unitsAway(glm::length(light.position - reference())),
                                    .ink = Ink::L});
    }

    void aids() {
        auto& lines = m_drawing.lines;
        for (const ObjectBounds& bounds : m_content.mesh->objects) {
            if (m_options.boxes) addWorldBox(m_content, bounds.box, Ink::Text, lines);
            if (m_options.spheres && m_content.map.keepsLengths())
                addSphere({m_content.map.toSpace(bounds.sphere.centre), bounds.sphere.radius}, Ink::Edge, m_view.camera,
                          lines);
        }
        for (const Segment& edge : markedOutline(m_content)) m_drawing.obstacles.push_back({edge.a, edge.b});
        addMarkedPoint(m_content, m_drawing);
        for (const LightFrustum& frustum : m_content.frusta)
            if (isShown(frustum, m_content, m_options)) addLightFrustum(frustum, m_drawing);
        if (!m_content.map.keepsLengths()) return addSpaceBox(m_content.map, m_drawing);
        const bool fromEye = glm::length(m_content.eye.eye - m_view.camera.position()) < 1e-6 * m_view.camera.distance;
        if (m_options.frustum && !fromEye) addFrustum(m_content.eye, m_drawing);
    }

    // What distances are measured from.
    Vec3d reference() const { return m_content.foot.value_or(m_content.bounds.centre()); }

    void eye() {
        const pipeline::View& eye = m_content.eye;
        // Who looks through the eye does not see it.
        if (glm::length(eye.eye - m_view.camera.position()) < 1e-6 * m_view.camera.distance) return;
        // In clip and screen space it is infinitely far: parallel lines lead to the picture.
        if (!m_content.map.keepsLengths()) return pictureFrame();
        Solid solid = ring(7, 1.6);
        append(solid, ball({0, 0, 0}, 2.4));
        mark(Ink::V, solid, eye.eye, towardsObserver(eye.eye));
        m_drawing.labels.push_back({.kind = Label::Kind::Caption,
                                    .at = eye.eye,
                                    .foot = m_content.bounds.centre(),
                                    .text = "eye",
                                    .distance = unitsAway(glm::length(eye.eye - reference())),
                                    .ink = Ink::V});
        if (m_content.foot) dotted(*m_content.foot, eye.perspective ? eye.eye : onEyePlane(*m_content.foot));
        pictureFrame();
    }

    void pictureFrame() {
        const pipeline::View& eye = m_content.eye;
        // Lines from an eye outside the view would cross it without saying where they come from.
        if (!showsWholeEye(m_content, m_view)) return;
        const auto corners = pictureCorners(eye, m_content.pictureDistance);
        // In perspective the eye itself, four times; in clip and screen space the near side.
        const auto foot = pictureCorners(eye, m_content.map.keepsLengths() ? 0 : eye.near);
        for (std::size_t i = 0; i < 4; ++i) {
            m_drawing.lines.push_back({foot[i], corners[i], Ink::V, 1, 1});
            m_drawing.lines.push_back({corners[i], corners[(i + 1) % 4], Ink::V, 1, 1});
        }
        if (!m_content.map.keepsLengths() && m_content.point) dotted(*m_content.point, onEyePlane(*m_content.point));
    }

    // Where an orthographic eye's ray to a point starts.
    Vec3d onEyePlane(Vec3d point) const {
        const pipeline::View& eye = m_content.eye;
        return point - glm::dot(point - eye.eye, eye.forward) * eye.forward;
    }

    void dashedLine(Vec3d a, Vec3d b) {
        const Vec3d along = glm::normalize(b - a);
        const double unit = unitAt(a), length = glm::length(b - a);
        for (const Dash& dash : dashes(VectorCode::L, length / unit, 2.4))
            m_drawing.solids.push_back(
                {Ink::L, tube(a + dash.begin * unit * along, a + dash.end * unit * along, 1.1 * unit, 8), unit});
    }

    // A dot every 6 pixels, as far as dots can be told apart.
    void dotted(Vec3d from, Vec3d to) {
        constexpr int kMost = 1500;
        const double length = glm::length(to - from), step = 6 * m_unit;
        if (!(length > 0)) return;
        const Vec3d along = (to - from) / length;
        m_drawing.obstacles.push_back({from, to});
        for (int i = 0; i < kMost && i * step < length; ++i)
            m_drawing.lines.push_back(
                {from + i * step * along, from + std::min((i + 0.3) * step, length) * along, Ink::V, 1, 1});
    }

    const ViewContent& m_content;
    const ViewOptions& m_options;
    const ViewFrame& m_view;
    double m_unit = 1;
    Drawing m_drawing;
};

}  // namespace

Vec3d lightDisc(const LightMark& light, const ViewContent& content) { return raysOf(light, content).disc; }

double gridStep(const ViewContent& content) {
    const double wanted = content.bounds.radius() / 2.5;
    const double decade = std::pow(10.0, std::floor(std::log10(wanted)));
    for (const double step : {1.0, 2.0, 5.0})
        if (step * decade >= wanted) return step * decade;
    return 10 * decade;
}

std::vector<InkedLine> groundLines(const ViewContent& content) {
    std::vector<InkedLine> lines;
    const double step = gridStep(content), radius = content.bounds.radius();
    const Vec3d centre{content.bounds.centre().x, content.bounds.centre().y, groundHeight(content)};
    const int reach = int(std::ceil(kGridReach * radius / step));
    // Lines stand at multiples of the step; rounding keeps them there far from the origin too.
    const double x0 = std::round(centre.x / step), y0 = std::round(centre.y / step);
    const auto piece = [&](double i, double j, double di, double dj) {
        const Vec3d a{(x0 + i) * step, (y0 + j) * step, centre.z},
            b{(x0 + i + di) * step, (y0 + j + dj) * step, centre.z};
        const float sa = gridStrength(glm::length(a - centre), radius),
                    sb = gridStrength(glm::length(b - centre), radius);
        if (sa > 0 || sb > 0) lines.push_back({a, b, Ink::Grid, sa, sb});
    };
    for (int i = -reach; i <= reach; ++i)
        for (int j = -reach; j < reach; ++j) {
            piece(i, j, 0, 1);
            piece(j, i, 1, 0);
        }
    return lines;
}

Drawing drawWorld(const ViewContent& content, const ViewOptions& options, const ViewFrame& view) {
    return WorldPainter(content, options, view).take();
}

bool showsWholeEye(const ViewContent& content, const ViewFrame& view) {
    const auto inside = [&](Vec3d point) {
        const Projected p = project(view.camera, view.size, point);
        return p.inFront && p.at.x >= 0 && p.at.y >= 0 && p.at.x <= view.size.x && p.at.y <= view.size.y;
    };
    return inside(content.eye.eye) && std::ranges::all_of(pictureCorners(content.eye, content.pictureDistance), inside);
}

std::vector<Vec3d> sceneExtent(const ViewContent& content, const ViewOptions& options) {
    const auto corners = content.bounds.corners();
    std::vector<Vec3d> points(corners.begin(), corners.end());
    const auto add = [&](const std::array<Vec3d, 4>& more) { points.insert(points.end(), more.begin(), more.end()); };
    if (!content.map.keepsLengths()) add(pictureCorners(content.eye, content.pictureDistance));
    if (content.map.space == ViewSpace::Light)
        for (const LightFrustum& frustum : content.frusta)
            if (isShown(frustum, content, options))
                for (const double z : {frustum.view.perspective ? 0 : frustum.plane, frustum.plane, frustum.end})
                    add(pictureCorners(frustum.view, z));
    if (options.lights)
        for (const LightMark& light : content.lights)
            if (light.atInfinity) {
                const RayPlace rays = raysOf(light, content);
                points.insert(points.end(), {rays.disc - rays.aside, rays.disc + rays.aside});
            }
    return points;
}

std::vector<Vec3d> everythingExtent(const ViewContent& content, const ViewOptions& options) {
    std::vector<Vec3d> points = sceneExtent(content, options);
    points.push_back(content.eye.eye);
    for (const Vec3d& corner : pictureCorners(content.eye, content.pictureDistance)) points.push_back(corner);
    for (const LightMark& light : content.lights)
        if (!light.atInfinity) points.push_back(light.position);
    return points;
}

OrbitCamera presetCamera(ViewPreset preset, const ViewContent& content, const ViewOptions& options, glm::dvec2 size,
                         bool orthographic, double foot) {
    const Vec3d centre = content.bounds.centre();
    if (preset == ViewPreset::Eye) {
        OrbitCamera camera = fromEye(content.eye, centre, size);
        camera.orthographic = orthographic || !content.eye.perspective;
        return camera;
    }
    OrbitCamera camera;
    camera.orthographic = orthographic;
    switch (preset) {
        case ViewPreset::Front: lookAlong(camera, {0, 1, 0}); break;
        case ViewPreset::Side: lookAlong(camera, {-1, 0, 0}); break;
        case ViewPreset::Top: lookAlong(camera, {0, 0, -1}); break;
        case ViewPreset::Outside: {
            // From behind the eye, beside and above it, and as upright as it is.
            const pipeline::View& eye = content.eye;
            camera.forward = glm::normalize(eye.forward - 0.8 * eye.right - 0.4 * eye.up);
            camera.right = glm::normalize(glm::cross(camera.forward, eye.up));
            camera.up = glm::cross(camera.right, camera.forward);
            std::vector<Vec3d> points = everythingExtent(content, options);
            const auto corners = frustumCorners(eye);
            points.insert(points.end(), corners.begin(), corners.end());
            frame(camera, points, size, 0.11, foot);
            return camera;
        }
        default: {
            const Vec3d towardsEye = content.eye.perspective ? content.eye.eye - centre : -content.eye.forward;
            // Far to the side, the eye's frustum and the scene stand next to each other.
            // The eye and its picture belong to the other spaces.
            const bool apart = content.map.space != ViewSpace::World && content.map.space != ViewSpace::Light;
            const double beside = preset == ViewPreset::Everything ? -78 : apart ? -62 : -40, above = 15;  // degrees
            const double azimuth = std::atan2(towardsEye.y, towardsEye.x) + glm::radians(beside);
            const double elevation = glm::radians(above);
            lookAlong(camera, {-std::cos(azimuth) * std::cos(elevation), -std::sin(azimuth) * std::cos(elevation),
                               -std::sin(elevation)});
        }
    }
    // In its own space the eye belongs to what is shown.
    const bool eyeToo = preset == ViewPreset::Everything || content.map.space == ViewSpace::Eye;
    frame(camera, eyeToo ? everythingExtent(content, options) : sceneExtent(content, options), size, 0.11, foot);
    return camera;
}

}  // namespace app
