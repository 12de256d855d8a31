#include "pipeline/stages/vertex_weights.h"

#include <algorithm>
#include <cmath>

namespace pipeline {
namespace {

bool inFront(const View& view, double z) { return !view.perspective || z >= view.near; }

template <class Real>
VertexWeights<Real> ofTriangle(const Triangle& triangle, Vec3<Real> weights, Interpolation used) {
    const auto& v = triangle.vertices;
    return {3, {v[0], v[1], v[2], 0}, {weights.x, weights.y, weights.z, 0}, used};
}

// Affine over the piece of a clipped triangle that covers the pixel.
template <class Real>
Vec3<Real> affineOfPiece(const TransformOutput<Real>& in, std::uint32_t triangle, Vec3<Real> b, glm::ivec2 pixel) {
    const auto& v = in.topology->triangles[triangle].vertices;
    Vec3<Real> weights = b;
    const auto look = [&](const RasterTriangle<Real>& piece) {
        forEachCovered(piece.snapped, {pixel, pixel + 1}, [&](glm::ivec2, const std::array<std::int64_t, 3>& e) {
            const Real l1 = Real(e[1]) * piece.inverseArea2, l2 = Real(e[2]) * piece.inverseArea2;
            weights = piece.weights[0] + l1 * (piece.weights[1] - piece.weights[0]) +
                      l2 * (piece.weights[2] - piece.weights[0]);
        });
    };
    setUpTriangle<Real>(in.view, {in.viewSpace(v[0]), in.viewSpace(v[1]), in.viewSpace(v[2])}, triangle, look);
    return weights;
}

template <class Real>
VertexWeights<Real> affine(const TransformOutput<Real>& in, std::uint32_t id, Vec3<Real> b, glm::ivec2 pixel) {
    const Triangle& triangle = in.topology->triangles[id];
    if (!in.view.perspective) return ofTriangle(triangle, b, Interpolation::Affine);
    Vec3<Real> l;
    for (int i = 0; i < 3; ++i) {
        const Real z = in.viewSpace(triangle.vertices[i]).z;
        if (!inFront(in.view, double(z)))
            return ofTriangle(triangle, affineOfPiece(in, id, b, pixel), Interpolation::Affine);
        l[i] = b[i] * z;
    }
    return ofTriangle(triangle, l / (l.x + l.y + l.z), Interpolation::Affine);
}

// Where the rasterizer sees a vertex: on its grid, which every coverage is decided on. In double, like there.
template <class Real>
glm::dvec2 placeInPicture(const TransformOutput<Real>& in, std::uint32_t vertex) {
    const View& view = in.view;
    const Vec3d v(in.viewSpace(vertex));
    const double spread = view.perspective ? v.z : 1;
    const double places = std::ldexp(1.0, view.subPixelBits);
    const auto onGrid = [&](double x) { return std::floor(x * places + 0.5) / places; };
    return {onGrid(view.centre.x + view.scale.x * v.x / spread), onGrid(view.centre.y - view.scale.y * v.y / spread)};
}

// A vertex on the row counts as above it, which is the top-left rule's view of it: every outline crosses an even number
// of times.
template <class Real>
void cross(const TransformOutput<Real>& in, std::uint32_t polygon, int y, RowCrossings& out) {
    out.polygon = polygon, out.row = y;
    out.crossings.clear();
    const Topology::Corners corners = in.topology->corners(polygon);
    for (std::size_t i = 0; i < corners.size(); ++i)
        if (!inFront(in.view, double(in.viewSpace(corners[i]).z))) return;
    const double middle = y + 0.5;
    glm::dvec2 p = placeInPicture(in, corners[corners.size() - 1]);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec2 q = placeInPicture(in, corners[i]);
        if (!std::isfinite(q.x) || !std::isfinite(q.y)) return out.crossings.clear();
        const std::uint32_t from = corners[i == 0 ? corners.size() - 1 : i - 1], to = corners[i];
        if ((p.y <= middle) != (q.y <= middle)) {
            const double along = (middle - p.y) / (q.y - p.y);
            out.crossings.push_back({p.x + (q.x - p.x) * along, from, to, along});
        }
        p = q;
    }
    std::ranges::stable_sort(out.crossings, {}, &RowCrossings::Crossing::x);
}

template <class Real>
void add(VertexWeights<Real>& w, std::uint32_t vertex, double weight) {
    if (weight == 0) return;
    for (std::size_t i = 0; i < w.count; ++i) {
        if (w.vertices[i] != vertex) continue;
        w.weights[i] += Real(weight);
        return;
    }
    w.vertices[w.count] = vertex;
    w.weights[w.count++] = Real(weight);
}

// L1: I_a = I_1 + (I_2 - I_1) (y_s - y_1) / (y_2 - y_1), likewise I_b, I_s = I_a + (I_b - I_a) (x_s - x_a) / (x_b - x_a).
// Of several spans in a concave polygon the one that holds the pixel; a sub-pixel of tolerance for rounding. Nothing
// where there is none: an outline that crosses itself covers pixels that lie in no span.
template <class Real>
bool scanline(const RowCrossings& row, double x, double tolerance, VertexWeights<Real>& out) {
    for (std::size_t i = 0; i + 1 < row.crossings.size(); i += 2) {
        const RowCrossings::Crossing &a = row.crossings[i], &b = row.crossings[i + 1];
        if (x < a.x - tolerance || x > b.x + tolerance) continue;
        const double u = b.x > a.x ? std::clamp((x - a.x) / (b.x - a.x), 0.0, 1.0) : 0;
        out = {0, {}, {}, Interpolation::Scanline};
        add(out, a.from, (1 - u) * (1 - a.along));
        add(out, a.to, (1 - u) * a.along);
        add(out, b.from, u * (1 - b.along));
        add(out, b.to, u * b.along);
        return true;
    }
    return false;
}

}  // namespace

template <class Real>
VertexWeights<Real> vertexWeights(Interpolation mode, const TransformOutput<Real>& in, std::uint32_t triangle,
                                  Vec3<Real> b, glm::ivec2 pixel, RowCrossings& row) {
    if (mode == Interpolation::Perspective)
        return ofTriangle(in.topology->triangles[triangle], b, Interpolation::Perspective);
    if (mode == Interpolation::Scanline) {
        const std::uint32_t polygon = in.topology->polygonOf(triangle);
        if (row.polygon != polygon || row.row != pixel.y) cross(in, polygon, pixel.y, row);
        VertexWeights<Real> weights;
        if (scanline(row, pixel.x + 0.5, std::ldexp(1.0, -in.view.subPixelBits), weights)) return weights;
    }
    return affine(in, triangle, b, pixel);
}

#define SHADESCOPE_INSTANTIATE(Real)                                                                                   \
    template VertexWeights<Real> vertexWeights(Interpolation, const TransformOutput<Real>&, std::uint32_t, Vec3<Real>, \
                                               glm::ivec2, RowCrossings&);
SHADESCOPE_FOR_EVERY_REAL(SHADESCOPE_INSTANTIATE)
#undef SHADESCOPE_INSTANTIATE

}  // namespace pipeline
