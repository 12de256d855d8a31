// Contracts of stages 4 and 5, with their mistakes.
#include <algorithm>
#include <limits>

#include "pipeline/defects/own_rows.h"

namespace pipeline {
namespace own {
namespace {

// Where a point falls on a shadow buffer; z the last coordinate. flip: rows counted from the bottom.
Vec3d onBuffer(A a, Vec3d q, double z, double flip = 1) {
    const glm::dvec2 scale = a.p(5);
    const double size = a.n(6);
    return {glm::dot(q, a.v(2)) * scale.x + size / 2, size / 2 - flip * glm::dot(q, a.v(3)) * scale.y, z};
}

double edge(glm::dvec2 u, glm::dvec2 v, glm::dvec2 q) { return (v.x - u.x) * (q.y - u.y) - (v.y - u.y) * (q.x - u.x); }
// Opposite to a, b and c, at p.
Vec3d edges(A a) { return {edge(a.p(1), a.p(2), a.p(3)), edge(a.p(2), a.p(0), a.p(3)), edge(a.p(0), a.p(1), a.p(3))}; }
double area(A a) { return edge(a.p(0), a.p(1), a.p(2)); }

double sum(Vec3d v) { return v.x + v.y + v.z; }
double sumOf(A a, std::size_t list) {
    double all = 0;
    for (std::size_t i = 0; i < a.count(list); ++i) all += a.n(list, i);
    return all;
}
double meanOf(A a, std::size_t list) { return sumOf(a, list) / double(a.count(list)); }

// From I at y1 to that at y2, at the row.
double between(double from, double to, double y1, double y2, double ys) {
    return from + (to - from) * (ys - y1) / (y2 - y1);
}
double first(A a) { return between(a.n(0), a.n(1), a.n(3), a.n(4), a.n(6)); }
double second(A a) { return between(a.n(0), a.n(2), a.n(3), a.n(5), a.n(6)); }

constexpr double kNothingYet = std::numeric_limits<double>::infinity();
// What a pixel holds afterwards: z and c.
R pixel(double z, double c) { return glm::dvec2(z, c); }

constexpr std::array kDrawing{
    OwnContract{OwnFunction::ToLight,
                "toLight",
                StageId::ShadowBuffer,
                {{{"p", Vector, "point, world space"},
                  {"origin", Vector, "place of the light, world space"},
                  {"right", Vector, "axis of the light, unit"},
                  {"up", Vector, "axis of the light, unit"},
                  {"forward", Vector, "axis of the light, unit, away from it"},
                  {"scale", Point, "texels per world unit, along x′ and y′"},
                  {"size", Number, "texels along a side of the buffer"}}},
                Vector,
                "x′ and y′ in texels, row 0 on top; z′ in world units",
                OwnMeasure::Distance,
                0.01,
                true,
                "shadows",
                "What is nearest to the light?",
                "for every pixel that looks up the shadow of a light at infinity",
                "As the camera: a dot product with each axis of the light, then scale and shift x′ and y′ to texels.",
                [](A a) -> R { return onBuffer(a, a.v(0) - a.v(1), glm::dot(a.v(0) - a.v(1), a.v(4))); },
                {{{"shadow-flip", "rows of the shadow buffer counted from the bottom",
                   [](A a) -> R { return onBuffer(a, a.v(0) - a.v(1), glm::dot(a.v(0) - a.v(1), a.v(4)), -1); }},
                  {"no-origin", "the light’s position left out",
                   [](A a) -> R { return onBuffer(a, a.v(0), glm::dot(a.v(0), a.v(4))); }},
                  {"distance", "the distance for the depth",
                   [](A a) -> R { return onBuffer(a, a.v(0) - a.v(1), glm::length(a.v(0) - a.v(1))); }}}}},
    OwnContract{
        OwnFunction::ShadowFactor,
        "shadowFactor",
        StageId::Shading,
        {{{"zp", Number, "z′ of the point, world units"},
          {"Zp", Number, "Z′ that the shadow buffer holds there"},
          {"bias", Number, "world units"}}},
        Number,
        "S: 0 in shadow, 1 lit",
        OwnMeasure::Largest,
        0.05,
        true,
        "shadows",
        "Find the bias",
        "for every look-up in a shadow buffer that holds something there",
        "Something nearer to the light than the point, by more than the bias, hides it.",
        [](A a) -> R { return a.n(0) > a.n(1) + a.n(2) ? 0.0 : 1.0; },
        {{{"no-bias", "no shadow bias", [](A a) -> R { return a.n(0) > a.n(1) ? 0.0 : 1.0; }},
          {"bias-sign", "the bias makes the shadow larger",
           [](A a) -> R { return a.n(0) > a.n(1) - a.n(2) ? 0.0 : 1.0; }},
          {"lit", "lit and shadowed exchanged", [](A a) -> R { return a.n(0) > a.n(1) + a.n(2) ? 1.0 : 0.0; }}}}},
    OwnContract{OwnFunction::Setpixel,
                "setpixel",
                StageId::ZBuffer,
                {{{"x", Number, "column"},
                  {"y", Number, "row"},
                  {"c", Number, "colour: the number of the triangle"},
                  {"z", Number, "z_v of the fragment, world units"},
                  {"zbuffer", Number, "z_v stored at x, y; Infinity where nothing was drawn"},
                  {"color", Number, "colour stored there; -1 where nothing was drawn"}}},
                Point,
                "depth and colour stored at x, y afterwards",
                OwnMeasure::Relative,
                1e-6,
                true,
                "z-buffer",
                "The second card",
                "for every fragment of the z-buffer with linear depth",
                "Lecture 2’s three lines: a test and two assignments.",
                [](A a) -> R { return a.n(3) < a.n(4) ? pixel(a.n(3), a.n(2)) : pixel(a.n(4), a.n(5)); },
                {{{"z-no-write", "depth never written",
                   [](A a) -> R { return a.n(3) < a.n(4) ? pixel(a.n(4), a.n(2)) : pixel(a.n(4), a.n(5)); }},
                  {"z-flip", "the farther one wins",
                   [](A a) -> R {
                       const bool wins = a.n(3) > a.n(4) || a.n(4) == kNothingYet;
                       return wins ? pixel(a.n(3), a.n(2)) : pixel(a.n(4), a.n(5));
                   }},
                  {"no-test", "painted over whatever is there", [](A a) -> R { return pixel(a.n(3), a.n(2)); }}}}},
    OwnContract{
        OwnFunction::IsInside,
        "isInside",
        StageId::ZBuffer,
        {{{"a", Point, "vertex of a front-facing triangle, pixels, rows run down"},
          {"b", Point, "second vertex"},
          {"c", Point, "third vertex"},
          {"p", Point, "centre of a pixel"}}},
        Truth,
        "true: the triangle covers p",
        OwnMeasure::Same,
        0,
        true,
        "smooth",
        "Who has drawn this?",
        "for every pixel of the bounding box of a triangle that is drawn, but those on its edges",
        "p is on the same side of all three edges. A front face has negative edge functions here.",
        [](A a) -> R { return edges(a).x <= 0 && edges(a).y <= 0 && edges(a).z <= 0; },
        {{{"two-edges", "the third edge is left out", [](A a) -> R { return edges(a).z <= 0 && edges(a).x <= 0; }},
          {"edge-sign", "the sign of a drawing with y upwards",
           [](A a) -> R { return edges(a).x >= 0 && edges(a).y >= 0 && edges(a).z >= 0; }},
          {"box-alone", "the bounding box for the triangle",
           [](A a) -> R {
               const auto low = glm::min(a.p(0), glm::min(a.p(1), a.p(2)));
               const auto high = glm::max(a.p(0), glm::max(a.p(1), a.p(2)));
               const glm::dvec2 p = a.p(3);
               return p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y;
           }}}}},
    OwnContract{OwnFunction::Weights,
                "weights",
                StageId::ZBuffer,
                {{{"a", Point, "vertex of a triangle, pixels, rows run down"},
                  {"b", Point, "second vertex"},
                  {"c", Point, "third vertex"},
                  {"p", Point, "centre of a pixel that the triangle covers"}}},
                Vector,
                "λ_0, λ_1 and λ_2, of a, b and c",
                OwnMeasure::Largest,
                0.001,
                true,
                "smooth",
                "Along an edge",
                "for every fragment",
                "λ_0 is the area of p, b, c over that of a, b, c.",
                [](A a) -> R { return edges(a) / area(a); },
                {{{"order", "the weights of the next vertices",
                   [](A a) -> R { return Vec3d(edges(a).z, edges(a).x, edges(a).y) / area(a); }},
                  {"half", "half as much", [](A a) -> R { return edges(a) / 2.0 / area(a); }},
                  {"distances", "distances for areas",
                   [](A a) -> R {
                       const glm::dvec2 p = a.p(3);
                       const Vec3d w =
                           1.0 / Vec3d(glm::length(p - a.p(0)), glm::length(p - a.p(1)), glm::length(p - a.p(2)));
                       return w / sum(w);
                   }}}}},
    OwnContract{
        OwnFunction::DepthAt,
        "depthAt",
        StageId::ZBuffer,
        {{{"lambda", Vector, "weights of the three vertices in the picture"},
          {"z", Vector, "z_v of the three vertices, world units"}}},
        Number,
        "z_v at the pixel, world units",
        OwnMeasure::Relative,
        0.001,
        true,
        "z-buffer",
        "Where two planes cross",
        "for every fragment of a perspective camera",
        "Not z but 1/z is linear in the picture.",
        [](A a) -> R { return 1 / sum(a.v(0) / a.v(1)); },
        {{{"z-affine", "z interpolated linearly in the picture", [](A a) -> R { return glm::dot(a.v(0), a.v(1)); }},
          {"reciprocal", "number instead of its reciprocal", [](A a) -> R { return sum(a.v(0) / a.v(1)); }},
          {"mean-depth", "one depth for the whole triangle", [](A a) -> R { return sum(a.v(1)) / 3; }}}}},
    OwnContract{OwnFunction::PerspectiveWeights,
                "perspectiveWeights",
                StageId::ZBuffer,
                {{{"lambda", Vector, "weights of the three vertices in the picture"},
                  {"z", Vector, "z_v of the three vertices, world units"}}},
                Vector,
                "weights in space; their sum is 1",
                OwnMeasure::Largest,
                0.01,
                true,
                "smooth",
                "The middle is not the middle",
                "for every fragment of a perspective camera",
                "λ_i / z_i, divided by their sum.",
                [](A a) -> R { return a.v(0) / a.v(1) / sum(a.v(0) / a.v(1)); },
                {{{"affine", "weights not divided by z", [](A a) -> R { return a.v(0); }},
                  {"no-sum", "not divided by their sum", [](A a) -> R { return a.v(0) / a.v(1); }},
                  {"times-z", "multiplied by z instead of divided",
                   [](A a) -> R { return a.v(0) * a.v(1) / sum(a.v(0) * a.v(1)); }}}}},
    OwnContract{OwnFunction::Intensity,
                "intensity",
                StageId::ZBuffer,
                {{{"I1", Number, "intensity of the upper vertex"},
                  {"I2", Number, "intensity of the vertex at the end of the first edge"},
                  {"I4", Number, "intensity of the vertex at the end of the second edge"},
                  {"y1", Number, "row of the upper vertex, pixels"},
                  {"y2", Number, "row of the vertex with I2"},
                  {"y4", Number, "row of the vertex with I4"},
                  {"ys", Number, "row of the pixel's centre"},
                  {"xa", Number, "column where the row crosses the first edge"},
                  {"xb", Number, "column where it crosses the second edge"},
                  {"xs", Number, "column of the pixel's centre"}}},
                Number,
                "I_s, lecture 1’s double interpolation",
                OwnMeasure::Largest,
                0.5,
                false,
                "smooth",
                "A line that is not there",
                "for pixels of triangles in Gouraud shading, rows below the upper vertex",
                "I_a on the edge 1–2, I_b on the edge 1–4, then along the row.",
                [](A a) -> R { return between(first(a), second(a), a.n(7), a.n(8), a.n(9)); },
                {{{"wrong-end", "interpolated from the wrong end",
                   [](A a) -> R {
                       const double ia = between(a.n(1), a.n(0), a.n(3), a.n(4), a.n(6));
                       return between(ia, between(a.n(2), a.n(0), a.n(3), a.n(5), a.n(6)), a.n(7), a.n(8), a.n(9));
                   }},
                  {"one-edge", "one edge for both ends of the row",
                   [](A a) -> R { return between(first(a), first(a), a.n(7), a.n(8), a.n(9)); }},
                  {"no-start", "distance from the first column instead of the column",
                   [](A a) -> R { return first(a) + (second(a) - first(a)) * a.n(9) / (a.n(8) - a.n(7)); }}}}},
    OwnContract{OwnFunction::IsPaintedFirst,
                "isPaintedFirst",
                StageId::ZBuffer,
                {{{"zA", Numbers, "z_v of the vertices of polygon A, world units"},
                  {"zB", Numbers, "z_v of the vertices of polygon B"}}},
                Truth,
                "true: A is painted before B",
                OwnMeasure::Same,
                0,
                false,
                "painter",
                "Which one first?",
                "for every two polygons of different mean depth, of up to 100",
                "From back to front, by the mean of the vertices’ depths.",
                [](A a) -> R { return meanOf(a, 0) > meanOf(a, 1); },
                {{{"nearest-first", "painted from front to back", [](A a) -> R { return meanOf(a, 0) < meanOf(a, 1); }},
                  {"first-corner", "one vertex for the whole polygon", [](A a) -> R { return a.n(0, 0) > a.n(1, 0); }},
                  {"sum", "added instead of combined", [](A a) -> R { return sumOf(a, 0) > sumOf(a, 1); }}}}},
    OwnContract{OwnFunction::DepthCode,
                "depthCode",
                StageId::ZBuffer,
                {{{"z", Number, "z_v, world units"}, {"n", Number, "near plane"}, {"f", Number, "far plane"}}},
                Number,
                "0 at the near plane, 1 at the far one",
                OwnMeasure::Largest,
                1e-4,
                true,
                "depth-precision",
                "Half of all codes",
                "for every fragment of a perspective camera",
                "d = a + b / z. Which a and b give 0 for n and 1 for f?",
                [](A a) -> R { return a.n(2) / (a.n(2) - a.n(1)) - a.n(2) * a.n(1) / ((a.n(2) - a.n(1)) * a.n(0)); },
                {{{"middle", "depth grows linearly", [](A a) -> R { return (a.n(0) - a.n(1)) / (a.n(2) - a.n(1)); }},
                  {"ndc", "−1 to 1 instead of 0 to 1",
                   [](A a) -> R {
                       const double n = a.n(1), f = a.n(2);
                       return (f + n) / (f - n) - 2 * f * n / ((f - n) * a.n(0));
                   }},
                  {"reversed", "near and far exchanged",
                   [](A a) -> R {
                       const double n = a.n(1), f = a.n(2);
                       return n / (n - f) - f * n / ((n - f) * a.n(0));
                   }}}}},
};
static_assert(std::tuple_size_v<decltype(kDrawing)> == index(OwnFunction::DepthCode) - index(OwnFunction::NormalColor));

}  // namespace
}  // namespace own

std::span<const OwnContract> ownOfDrawing() { return own::kDrawing; }

}  // namespace pipeline
