#include "app/drawing3d/point_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "app/drawing3d/lobe_drawing.h"
#include "app/look/numbers.h"
#include "pipeline/core/numerics.h"

namespace app {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kArrowRadius = 2.2;  // pixels of the design
constexpr int kAround = 72;           // pieces of a circle

const VectorArrow* find(const ViewContent& content, VectorCode code) {
    for (const VectorArrow& v : content.vectors)
        if (v.main && v.code == code) return &v;
    return nullptr;
}

Vec3d onSphere(double degreesFromN, double azimuth) {
    const double t = glm::radians(degreesFromN);
    return {std::sin(t) * std::cos(azimuth), std::sin(t) * std::sin(azimuth), std::cos(t)};
}

// The disc in the polygon's own colour, the mean of its corners' where they differ.
ViewMesh discMesh(const ViewContent& content) {
    glm::vec3 color(0.7f);
    for (const Face& face : content.mesh->faces)
        if (face.polygon == content.pickedPolygon) {
            color = glm::vec3(0);
            for (std::size_t i = 0; i < 3; ++i) color += content.mesh->colorOf(face, i) / 3.0f;
        }
    ViewMesh mesh;
    mesh.polygonColors = {color};
    mesh.positions.push_back(Vec3d(0.0));
    for (unsigned i = 0; i < kAround; ++i) {
        mesh.positions.push_back(onSphere(90, 2 * kPi * i / kAround));
        mesh.faces.push_back({{0, i + 1, (i + 1) % kAround + 1}});
    }
    return mesh;
}

class PointPainter {
public:
    PointPainter(const ViewContent& content, const ViewOptions& options, const ViewFrame& view)
        : m_content(content), m_options(options), m_view(view) {}

    Drawing take() {
        circle(90, Ink::Outline, 1);
        circle(60, Ink::Grid, 1);
        circle(30, Ink::Grid, 1);
        for (int i = 0; i < 6; ++i) meridian(i * kPi / 6);
        silhouette();
        vectors();
        const VectorArrow *N = shown(VectorCode::N), *L = shown(VectorCode::L), *V = shown(VectorCode::V),
                          *R = shown(VectorCode::R), *H = shown(VectorCode::H);
        if (N && L) angle(N->direction, L->direction, "NL", 0.52);
        const bool isOfH = std::ranges::any_of(
            m_content.lobes, [](const SpecularLobe& lobe) { return lobe.main && lobe.code == VectorCode::H; });
        if (isOfH && N && H) angle(N->direction, H->direction, "NH", 0.82);
        if (!isOfH && R && V) angle(R->direction, V->direction, "RV", 0.82);
        if (R && L) {
            dotted(L->direction, R->direction, Ink::R);
        } else if (H && L && V) {
            dotted(L->direction, L->direction + V->direction, Ink::H);
            dotted(V->direction, L->direction + V->direction, Ink::H);
        }
        const VectorArrow *anyL = find(m_content, VectorCode::L), *anyN = find(m_content, VectorCode::N);
        if (m_options.projection && anyL && anyN) projection(anyN->direction, anyL->direction);
        if (m_options.reflection && anyL && anyN) reflection(anyN->direction, anyL->direction, R != nullptr);
        if (m_options.lobe)
            for (const SpecularLobe& lobe : m_content.lobes) addLobe(lobe, 1, m_drawing);
        m_drawing.foot = Drawing::Marker{Vec3d(0.0), false};
        return std::move(m_drawing);
    }

private:
    const VectorArrow* shown(VectorCode code) const { return m_options.shows(code) ? find(m_content, code) : nullptr; }

    void vectors() {
        const OrbitCamera& camera = m_view.camera;
        const double unit = m_view.unitsPerMarkPixel();
        for (const VectorArrow& v : m_content.vectors) {
            if (!m_options.shows(v.code)) continue;
            const ShapePlacement placement{Vec3d(0.0), v.direction, -camera.forward, unit};
            m_drawing.vectors.push_back({inkOf(v.code), arrow(v.code, 1 / unit, kArrowRadius, placement), unit});
            m_drawing.labels.push_back({.kind = Label::Kind::Letter,
                                        .at = v.direction,
                                        .foot = Vec3d(0.0),
                                        .text = v.letter,
                                        .distance = {},
                                        .ink = inkOf(v.code)});
        }
    }

    void line(Vec3d a, Vec3d b, Ink ink, float strength = 1) {
        m_drawing.lines.push_back({a, b, ink, strength, strength});
    }

    void circle(double degreesFromN, Ink ink, float strength) {
        for (int i = 0; i < kAround; ++i)
            line(onSphere(degreesFromN, 2 * kPi * i / kAround), onSphere(degreesFromN, 2 * kPi * (i + 1) / kAround),
                 ink, strength);
    }

    void meridian(double azimuth) {
        constexpr int kPieces = 36;
        for (int i = 0; i < kPieces; ++i)
            line(onSphere(-90 + 180.0 * i / kPieces, azimuth), onSphere(-90 + 180.0 * (i + 1) / kPieces, azimuth),
                 Ink::Grid, 0.7f);
    }

    // The sphere's outline as seen, its upper half: the circle where the line of sight touches it.
    void silhouette() {
        const OrbitCamera& camera = m_view.camera;
        const Vec3d d = camera.position();
        const double distance = glm::length(d);
        const Vec3d axis = camera.orthographic || !(distance > 1) ? -camera.forward : d / distance;
        const double height = camera.orthographic || !(distance > 1) ? 0 : 1 / distance;
        const double radius = std::sqrt(1 - height * height);
        const Vec3d across = pipeline::normalized(glm::cross(Vec3d(0, 0, 1), axis));
        if (across == Vec3d(0.0)) return;  // from straight above it is the disc's edge
        const Vec3d upwards = glm::cross(axis, across);
        const auto at = [&](int i) {
            const double a = 2 * kPi * i / kAround;
            return height * axis + radius * (std::cos(a) * across + std::sin(a) * upwards);
        };
        for (int i = 0; i < kAround; ++i)
            if (at(i).z >= 0 && at(i + 1).z >= 0) line(at(i), at(i + 1), Ink::Outline);
    }

    void angle(Vec3d from, Vec3d to, const char* between, double radius) {
        const double whole = pipeline::angleBetween(from, to);
        const Vec3d aside = pipeline::normalized(to - glm::dot(from, to) * from);
        if (aside == Vec3d(0.0)) return;
        const auto at = [&](double a) { return radius * (std::cos(a) * from + std::sin(a) * aside); };
        constexpr int kPieces = 32;
        for (int i = 0; i < kPieces; ++i) line(at(whole * i / kPieces), at(whole * (i + 1) / kPieces), Ink::Text);
        constexpr int kChords = 4;  // long enough each to be in the way of words
        for (int i = 0; i < kChords; ++i)
            m_drawing.obstacles.push_back({at(whole * i / kChords), at(whole * (i + 1) / kChords)});
        m_drawing.labels.push_back(
            {.kind = Label::Kind::Angle,
             .at = (1 + 0.09 / radius) * at(whole / 2),
             .foot = Vec3d(0.0),
             .text = fmt::format("{} {}", between, app::angle(glm::degrees(whole)).toStdString()),
             .distance = {},
             .ink = Ink::Text});
    }

    void note(Vec3d at, std::string text, Ink ink, Vec3d foot) {
        m_drawing.labels.push_back(
            {.kind = Label::Kind::Plane, .at = at, .foot = foot, .text = std::move(text), .distance = {}, .ink = ink});
    }
    // What a construction says, line by line under the point, where no vector stands.
    void caption(std::string text) {
        constexpr double kFirst = 20, kNext = 17;
        const Vec3d at = -(kFirst + kNext * m_captions++) * m_view.unitsPerMarkPixel() * m_view.camera.up;
        m_drawing.labels.push_back({.kind = Label::Kind::Note,
                                    .at = at,
                                    .foot = {},
                                    .text = std::move(text),
                                    .distance = {},
                                    .ink = Ink::Text});
    }

    // The part of L along N, and the rest of it at a right angle.
    void projection(Vec3d N, Vec3d L) {
        const double nDotL = glm::dot(N, L);
        const Vec3d along = nDotL * N, across = L - along;
        strong(Vec3d(0.0), along, Ink::L);
        dashed(L, along, Ink::Text);
        caption("(N·L)N = " + dotProduct(nDotL).toStdString() + " N");
        caption("L − (N·L)N, across N");
        const Vec3d side = pipeline::normalized(across);
        if (side == Vec3d(0.0)) return;
        const double corner = std::min(0.07, glm::length(across) / 2);
        const Vec3d down = (nDotL > 0 ? -corner : corner) * N;
        line(along + corner * side, along + corner * side + down, Ink::Text);
        line(along + down, along + corner * side + down, Ink::Text);
    }

    // Twice that part, less L: the rhombus of L and R.
    void reflection(Vec3d N, Vec3d L, bool hasR) {
        const double nDotL = glm::dot(N, L);
        if (!(nDotL > 0)) return caption("N·L is not above 0: nothing is mirrored");
        const Vec3d twice = 2 * nDotL * N, R = twice - L;
        dashed(Vec3d(0.0), twice, Ink::N);
        dashed(L, twice, Ink::R);
        dashed(twice, R, Ink::L);
        if (!hasR) dashed(Vec3d(0.0), R, Ink::R);
        note(twice, "2(N·L)N = " + dotProduct(2 * nDotL).toStdString() + " N", Ink::Text, twice - N);
        const Vec3d middle = (twice + R) / 2.0;
        note(middle, "−L", Ink::L, middle - (R - L));
        caption("R = 2(N·L)N − L");
    }

    void dashed(Vec3d from, Vec3d to, Ink ink) {
        const double unit = m_view.unitsPerMarkPixel(), length = glm::length(to - from);
        const double step = 10 * unit;
        if (!(length > 0) || !(step > length / 2000)) return;
        const Vec3d along = (to - from) / length;
        m_drawing.obstacles.push_back({from, to});
        for (double s = 0; s < length; s += step)
            m_drawing.solids.push_back(
                {ink, tube(from + s * along, from + std::min(s + 0.6 * step, length) * along, 0.9 * unit, 8), unit});
    }

    void strong(Vec3d from, Vec3d to, Ink ink) {
        const double unit = m_view.unitsPerMarkPixel();
        m_drawing.obstacles.push_back({from, to});
        if (glm::length(to - from) > 0) m_drawing.solids.push_back({ink, tube(from, to, 3.4 * unit, 10), unit});
    }

    void dotted(Vec3d from, Vec3d to, Ink ink) {
        const double step = 5 * m_view.unitsPerMarkPixel(), length = glm::length(to - from);
        if (!(length > 0) || !(step > length / 2000)) return;
        const Vec3d along = (to - from) / length;
        m_drawing.obstacles.push_back({from, to});
        for (double s = 0; s < length; s += step)
            line(from + s * along, from + std::min(s + 0.4 * step, length) * along, ink);
    }

    const ViewContent& m_content;
    const ViewOptions& m_options;
    const ViewFrame& m_view;
    int m_captions = 0;
    Drawing m_drawing;
};

// The side from which L and V stand farthest apart, a little above the disc; unit.
Vec3d towardsReader(const ViewContent& content) {
    const VectorArrow *L = find(content, VectorCode::L), *V = find(content, VectorCode::V);
    Vec3d apart{0.0};
    if (L && V) apart = L->direction - V->direction;
    apart.z = 0;
    if (!(glm::length(apart) > 0.05) && L) apart = {L->direction.x, L->direction.y, 0};
    Vec3d side = pipeline::normalized(glm::cross(Vec3d(0, 0, 1), apart));
    if (side == Vec3d(0.0)) side = {0, -1, 0};
    // Of the two sides the one that the light comes from.
    if (L && glm::dot(L->direction, side) < 0) side = -side;
    const double above = glm::radians(14.0);
    return std::cos(above) * side + Vec3d(0, 0, std::sin(above));
}

}  // namespace

std::shared_ptr<const ViewContent> pointContent(const ViewContent& content) {
    const VectorArrow* N = find(content, VectorCode::N);
    if (!N) return nullptr;
    // Any x across N does; the world's up keeps the picture steady while the picked pixel moves.
    const Vec3d z = N->direction;
    Vec3d x = pipeline::normalized(glm::cross(Vec3d(0, 0, 1), z));
    if (x == Vec3d(0.0)) x = {1, 0, 0};
    const Vec3d y = glm::cross(z, x);
    auto result = std::make_shared<ViewContent>();
    result->mesh = std::make_shared<const ViewMesh>(discMesh(content));
    result->faceStrength = 0.35;
    result->bounds.add({-1, -1, 0});
    result->bounds.add({1, 1, 1});
    result->foot = Vec3d(0.0);
    const auto turned = [&](Vec3d d) { return Vec3d(glm::dot(d, x), glm::dot(d, y), glm::dot(d, z)); };
    for (VectorArrow v : content.vectors) {
        if (!v.main) continue;
        v.base = Vec3d(0.0);
        v.direction = turned(v.direction);
        result->vectors.push_back(v);
    }
    for (SpecularLobe lobe : content.lobes) {
        if (!lobe.main) continue;
        lobe.base = Vec3d(0.0);
        lobe.axis = turned(lobe.axis);
        lobe.probe = turned(lobe.probe);
        result->lobes.push_back(lobe);
    }
    return result;
}

Drawing drawPoint(const ViewContent& content, const ViewOptions& options, const ViewFrame& view) {
    return PointPainter(content, options, view).take();
}

OrbitCamera pointCamera(ViewPreset preset, const ViewContent& content, const ViewOptions& options, glm::dvec2 size,
                        bool orthographic, double foot) {
    OrbitCamera camera;
    camera.orthographic = orthographic;
    const VectorArrow* V = find(content, VectorCode::V);
    switch (preset) {
        case ViewPreset::Front: lookAlong(camera, {0, 1, 0}); break;
        case ViewPreset::Side: lookAlong(camera, {-1, 0, 0}); break;
        case ViewPreset::Top: lookAlong(camera, {0, 0, -1}); break;
        case ViewPreset::Eye: lookAlong(camera, V ? -V->direction : Vec3d(0, 0, -1)); break;
        case ViewPreset::Iso:
        case ViewPreset::Outside:
        case ViewPreset::Everything: lookAlong(camera, -towardsReader(content)); break;
    }
    std::vector<Vec3d> points{{0, 0, 1.12}};
    for (int i = 0; i < kAround; ++i) points.push_back(onSphere(90, 2 * kPi * i / kAround));
    const VectorArrow *L = find(content, VectorCode::L), *N = find(content, VectorCode::N);
    if (L && N && options.reflection) points.push_back(1.06 * 2 * glm::dot(N->direction, L->direction) * N->direction);
    frame(camera, points, size, 0.09, foot);
    return camera;
}

}  // namespace app
