// Contracts of stages 1 to 3, with their mistakes.
#include <algorithm>
#include <numbers>

#include "pipeline/core/angles.h"
#include "pipeline/defects/own_rows.h"

namespace pipeline {
namespace own {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

// Turned about z, degrees.
Vec3d turned(Vec3d p, double alpha) {
    const double c = cosDegrees(alpha), s = sinDegrees(alpha);
    return {p.x * c - p.y * s, p.x * s + p.y * c, p.z};
}

// Angles in degrees; rho at the origin.
Vec3d cameraOf(Vec3d w, double rho, double theta, double phi) {
    const double st = sinDegrees(theta), ct = cosDegrees(theta), sp = sinDegrees(phi), cp = cosDegrees(phi);
    return {-w.x * st + w.y * ct, -w.x * cp * ct - w.y * cp * st + w.z * sp,
            rho - w.x * sp * ct - w.y * sp * st - w.z * cp};
}

Vec3d along(Vec3d from, Vec3d to, double t) { return from + t * (to - from); }

// Σ x_i y_i+1 − x_i+1 y_i over all edges, or all but the last.
double edgeSum(A a, bool closed) {
    double sum = 0;
    for (std::size_t i = 0, n = a.count(0); i + (closed ? 0 : 1) < n; ++i) {
        const glm::dvec2 p = a.p(0, i), q = a.p(0, (i + 1) % n);
        sum += p.x * q.y - q.x * p.y;
    }
    return sum;
}
double turn(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }
double firstTurn(A a) { return turn(a.p(0, 1) - a.p(0, 0), a.p(0, 2) - a.p(0, 0)); }

Vec3d crossAt(A a, std::size_t i) { return glm::cross(a.v(0, i) - a.v(0, 0), a.v(0, i + 1) - a.v(0, 0)); }

template <class Term>
Vec3d sumOver(std::size_t first, std::size_t end, Term term) {
    Vec3d sum(0);
    for (std::size_t i = first; i < end; ++i) sum += term(i);
    return sum;
}
Vec3d meanSum(A a) {
    return sumOver(0, a.count(0), [&](std::size_t i) { return a.v(0, i); });
}

constexpr std::array kGeometry{
    OwnContract{OwnFunction::Place,
                "place",
                StageId::Transform,
                {{{"v", Vector, "vertex of the file"},
                  {"s", Vector, "scale along x, y and z"},
                  {"alpha", Number, "angle about z, degrees"},
                  {"t", Vector, "how far it is moved, world units"}}},
                Vector,
                "the vertex in world space",
                OwnMeasure::Distance,
                1e-4,
                true,
                "pyramid",
                "Where one vertex goes",
                "for every vertex of objects that are scaled, turned about z and moved",
                "The file says: scale, then turn about z, then move. cos and sin take radians.",
                [](A a) -> R { return turned(a.v(0) * a.v(1), a.n(2)) + a.v(3); },
                {{{"trs-order", "transformations in the wrong order",
                   [](A a) -> R { return turned((a.v(0) + a.v(3)) * a.v(1), a.n(2)); }},
                  {"radians", "degrees taken for radians",
                   [](A a) -> R { return turned(a.v(0) * a.v(1), a.n(2) * kDegrees) + a.v(3); }},
                  {"x-overwritten", "x is changed before y is computed",
                   [](A a) -> R {
                       const Vec3d p = a.v(0) * a.v(1);
                       const double c = cosDegrees(a.n(2)), s = sinDegrees(a.n(2)), x = p.x * c - p.y * s;
                       return Vec3d(x, x * s + p.y * c, p.z) + a.v(3);
                   }}}}},
    OwnContract{OwnFunction::Camera,
                "camera",
                StageId::Transform,
                {{{"w", Vector, "point in world space"},
                  {"rho", Number, "distance of the eye from the origin, world units"},
                  {"theta", Number, "degrees from +x about z"},
                  {"phi", Number, "degrees from +z"}}},
                Vector,
                "x right, y up, z away from the viewer",
                OwnMeasure::Distance,
                1e-4,
                true,
                "camera",
                "Which way is right?",
                "for every vertex of a scene with a spherical camera",
                "θ and φ are degrees. z_v is ρ at the origin, and less for what is nearer.",
                [](A a) -> R { return cameraOf(a.v(0), a.n(1), a.n(2), a.n(3)); },
                {{{"radians", "degrees taken for radians",
                   [](A a) -> R { return cameraOf(a.v(0), a.n(1), a.n(2) * kDegrees, a.n(3) * kDegrees); }},
                  {"elevation", "φ is measured from the ground",
                   [](A a) -> R { return cameraOf(a.v(0), a.n(1), a.n(2), 90 - a.n(3)); }},
                  {"z-towards", "z towards the viewer",
                   [](A a) -> R { return cameraOf(a.v(0), a.n(1), a.n(2), a.n(3)) * Vec3d(1, 1, -1); }}}}},
    OwnContract{OwnFunction::Project,
                "project",
                StageId::Transform,
                {{{"v", Vector, "point in view space"},
                  {"d", Number, "distance of the screen, pixels"},
                  {"W", Number, "width of the picture, pixels"},
                  {"H", Number, "height of the picture, pixels"}}},
                Point,
                "column and row in pixels, row 0 on top",
                OwnMeasure::Distance,
                0.01,
                true,
                "camera",
                "Divide by z",
                "for every vertex in front of the eye of a perspective camera",
                "The middle of the picture is (W/2, H/2). Rows are counted downwards, y_v upwards.",
                [](A a) -> R {
                    const Vec3d v = a.v(0);
                    return glm::dvec2(a.n(2) / 2 + a.n(1) * v.x / v.z, a.n(3) / 2 - a.n(1) * v.y / v.z);
                },
                {{{"y-down", "y counted downwards",
                   [](A a) -> R {
                       const Vec3d v = a.v(0);
                       return glm::dvec2(a.n(2) / 2 + a.n(1) * v.x / v.z, a.n(3) / 2 + a.n(1) * v.y / v.z);
                   }},
                  {"no-divide", "not divided by z",
                   [](A a) -> R { return glm::dvec2(a.n(2) / 2 + a.n(1) * a.v(0).x, a.n(3) / 2 - a.n(1) * a.v(0).y); }},
                  {"half-pixel", "pixels sampled at their corners",
                   [](A a) -> R {
                       const Vec3d v = a.v(0);
                       return glm::dvec2(a.n(2) / 2 + a.n(1) * v.x / v.z, a.n(3) / 2 - a.n(1) * v.y / v.z) - 0.5;
                   }}}}},
    OwnContract{OwnFunction::Cut,
                "cut",
                StageId::Transform,
                {{{"a", Vector, "one end of an edge, view space"},
                  {"b", Vector, "the other end, view space"},
                  {"near", Number, "z_v of the near plane"}}},
                Vector,
                "the point of the edge at z_v = near",
                OwnMeasure::Distance,
                1e-4,
                false,
                "near-plane",
                "Where is the cut?",
                "for every edge through the near plane",
                "How far along the way from a to b is z_v equal to near?",
                [](A a) -> R { return along(a.v(0), a.v(1), (a.n(2) - a.v(0).z) / (a.v(1).z - a.v(0).z)); },
                {{{"wrong-end", "interpolated from the wrong end",
                   [](A a) -> R { return along(a.v(1), a.v(0), (a.n(2) - a.v(0).z) / (a.v(1).z - a.v(0).z)); }},
                  {"at-the-eye", "cut at the eye instead of the near plane",
                   [](A a) -> R { return along(a.v(0), a.v(1), -a.v(0).z / (a.v(1).z - a.v(0).z)); }},
                  {"z-alone", "z is set, x and y stay", [](A a) -> R { return Vec3d(a.v(0).x, a.v(0).y, a.n(2)); }}}}},
    OwnContract{
        OwnFunction::SignedArea,
        "signedArea",
        StageId::Cull,
        {{{"p", Points, "vertices of a polygon, pixels, rows run down"}}},
        Number,
        "px²; above 0 for a front face",
        OwnMeasure::Relative,
        0.001,
        false,
        "back-faces",
        "The sign of an area",
        "for every polygon in front of the near plane",
        "Half of the sum over the edges. Rows run down: the sum of x_i y_i+1 − x_i+1 y_i is below 0 for a front "
        "face.",
        [](A a) -> R { return -edgeSum(a, true) / 2; },
        {{{"y-down-sign", "the sign of a drawing with y upwards", [](A a) -> R { return edgeSum(a, true) / 2; }},
          {"not-closed", "the last edge is left out", [](A a) -> R { return -edgeSum(a, false) / 2; }},
          {"twice", "twice as much", [](A a) -> R { return -edgeSum(a, true); }}}}},
    OwnContract{
        OwnFunction::IsVisible,
        "isVisible",
        StageId::Cull,
        {{{"p", Points, "vertices of a polygon, pixels, rows run down"}}},
        Truth,
        "true: the polygon is kept",
        OwnMeasure::Same,
        0,
        true,
        "back-faces",
        "Five polygons",
        "for every polygon in front of the near plane that may be seen",
        "Three vertices are enough: the sign of a cross product of two edges on the screen.",
        [](A a) -> R { return firstTurn(a) < 0; },
        {{{"cull-sign", "kept and dropped exchanged", [](A a) -> R { return firstTurn(a) > 0; }},
          {"no-cull", "back faces are drawn", [](A) -> R { return true; }},
          {"from-origin", "vertices taken for edges", [](A a) -> R { return turn(a.p(0, 1), a.p(0, 2)) < 0; }}}}},
    OwnContract{
        OwnFunction::FacesEye,
        "facesEye",
        StageId::Cull,
        {{{"N", Vector, "unit normal, world space"},
          {"p", Vector, "a vertex of the polygon, world space"},
          {"eye", Vector, "the eye, world space"},
          {"axis", Vector, "the viewing axis, unit; the right answer does not need it"}}},
        Truth,
        "true: the eye is on the outside of the polygon",
        OwnMeasure::Same,
        0,
        true,
        "back-faces",
        "A test that is nearly right",
        "for every polygon that may be seen by a perspective camera",
        "The line of sight runs from the eye to a vertex of the polygon, not along the camera’s axis.",
        [](A a) -> R { return glm::dot(a.v(0), a.v(2) - a.v(1)) > 0; },
        {{{"cull-axis", "viewing axis for the line of sight", [](A a) -> R { return glm::dot(a.v(0), a.v(3)) < 0; }},
          {"cull-sign", "kept and dropped exchanged", [](A a) -> R { return glm::dot(a.v(0), a.v(1) - a.v(2)) > 0; }},
          {"p-forgotten", "the eye’s position instead of the line of sight",
           [](A a) -> R { return glm::dot(a.v(0), a.v(2)) > 0; }}}}},
    OwnContract{OwnFunction::CalcNormal,
                "CalcNormal",
                StageId::Normals,
                {{{"v0", Vector, "first vertex, world space"},
                  {"v1", Vector, "second vertex"},
                  {"v2", Vector, "third vertex; counter-clockwise as seen from outside"}}},
                Vector,
                "unit vector out of the object",
                OwnMeasure::Angle,
                0.5,
                true,
                "normals",
                "The right length",
                "for every polygon",
                "Two edges from v0, their cross product, divided by its length.",
                [](A a) -> R { return unit(glm::cross(a.v(1) - a.v(0), a.v(2) - a.v(0))); },
                {{{"normal-flip", "cross product in the wrong order",
                   [](A a) -> R { return unit(glm::cross(a.v(2) - a.v(0), a.v(1) - a.v(0))); }},
                  {"not-normalised", "not normalised to length 1",
                   [](A a) -> R { return glm::cross(a.v(1) - a.v(0), a.v(2) - a.v(0)); }},
                  {"edge-v1-v2", "the second edge does not begin at v0",
                   [](A a) -> R { return unit(glm::cross(a.v(1) - a.v(0), a.v(2))); }}}}},
    OwnContract{
        OwnFunction::PolygonNormal,
        "polygonNormal",
        StageId::Normals,
        {{{"v", Vectors, "vertices, world space, counter-clockwise as seen from outside"}}},
        Vector,
        "unit vector out of the object",
        OwnMeasure::Angle,
        0.5,
        true,
        "normals",
        "Who counts twice?",
        "for every polygon",
        "Add the cross products of the triangles v0, vi, vi+1. In a hollow polygon some of them point the other way.",
        [](A a) -> R { return unit(sumOver(1, a.count(0) - 1, [&](std::size_t i) { return crossAt(a, i); })); },
        {{{"three-corners", "three vertices for the whole polygon", [](A a) -> R { return unit(crossAt(a, 1)); }},
          {"unit-each", "every triangle counts the same",
           [](A a) -> R {
               return unit(sumOver(1, a.count(0) - 1, [&](std::size_t i) { return unit(crossAt(a, i)); }));
           }},
          {"cross-swapped", "cross product in the wrong order",
           [](A a) -> R { return unit(-sumOver(1, a.count(0) - 1, [&](std::size_t i) { return crossAt(a, i); })); }}}}},
    OwnContract{OwnFunction::VertexNormal,
                "vertexNormal",
                StageId::Normals,
                {{{"normals", Vectors, "unit normals of the polygons around the vertex"}}},
                Vector,
                "unit vector",
                OwnMeasure::Angle,
                0.5,
                true,
                "normals",
                "One normal for a corner",
                "for every vertex where normal_weight = mean and the shading reads vertex normals",
                "The mean of unit vectors is shorter than 1.",
                [](A a) -> R { return unit(meanSum(a)); },
                {{{"not-renormalised", "a mean of unit vectors taken for a unit vector",
                   [](A a) -> R { return meanSum(a) / double(a.count(0)); }},
                  {"sum", "added instead of combined", [](A a) -> R { return meanSum(a); }},
                  {"last-one", "one polygon instead of all", [](A a) -> R { return unit(a.v(0, a.count(0) - 1)); }}}}},
    OwnContract{OwnFunction::ScaledNormal,
                "scaledNormal",
                StageId::Normals,
                {{{"N", Vector, "unit normal of the file"}, {"s", Vector, "scale along x, y and z"}}},
                Vector,
                "unit vector",
                OwnMeasure::Angle,
                0.5,
                false,
                "normals",
                "Pressed flat",
                "for every vertex with a normal of its own, of objects that are scaled and not turned",
                "A sphere that is pressed flat has steeper normals on its top: divide by the scale.",
                [](A a) -> R { return unit(a.v(0) / a.v(1)); },
                {{{"normal-matrix", "normals transformed like points", [](A a) -> R { return unit(a.v(0) * a.v(1)); }},
                  {"not-renormalised", "not normalised to length 1", [](A a) -> R { return a.v(0) / a.v(1); }},
                  {"same", "nothing changes", [](A a) -> R { return a.v(0); }}}}},
    OwnContract{OwnFunction::NormalColor,
                "normalColor",
                StageId::Normals,
                {{{"N", Vector, "unit normal"}}},
                Vector,
                "red, green and blue, 0 to 1",
                OwnMeasure::Largest,
                1.0 / 512,
                false,
                "normals",
                "Directions as colours",
                "for every pixel that shows a polygon",
                "Shift −1 … 1 to 0 … 1.",
                [](A a) -> R { return (a.v(0) + 1.0) / 2.0; },
                {{{"abs", "the sign is lost", [](A a) -> R { return glm::abs(a.v(0)); }},
                  {"no-half", "shifted, not halved", [](A a) -> R { return a.v(0) + 1.0; }},
                  {"no-shift", "halved, not shifted", [](A a) -> R { return a.v(0) / 2.0; }}}}},
};
static_assert(std::tuple_size_v<decltype(kGeometry)> == index(OwnFunction::NormalColor) + 1);

}  // namespace
}  // namespace own

std::span<const OwnContract> ownOfGeometry() { return own::kGeometry; }

}  // namespace pipeline
