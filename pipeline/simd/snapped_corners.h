// Included once for each instruction set, like lanes.h.
#if defined(SHADESCOPE_SNAPPED_CORNERS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHADESCOPE_SNAPPED_CORNERS_H
#undef SHADESCOPE_SNAPPED_CORNERS_H
#else
#define SHADESCOPE_SNAPPED_CORNERS_H
#endif

#include <cassert>

#include "pipeline/simd/lanes.h"
#include "pipeline/stages/snapped_vertices.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {

HWY_INLINE Ints pick(Mask mask, Ints yes, Ints no) { return hn::IfThenElse(hn::RebindMask(I(), mask), yes, no); }

// An edge function in steps² of the grid: c at some pixel, a and b the steps to the next column and row.
struct EdgeInVectors {
    Ints a, b, c;
    Ints bias;  // 0 if the edge owns the samples on it, else 1
};

// The snapped vertices of each lane's triangle.
struct SnappedCorners {
    Ints x[3], y[3], planes[3];  // as in SnappedVertex
    Floats w[3];

    // vertexOf(l, i): vertex i of the triangle in lane l.
    template <class VertexOf>
    HWY_INLINE SnappedCorners(const SnappedVertices& from, VertexOf vertexOf) {
        const auto at = [&](std::size_t vertex) {
            assert(vertex - from.first < from.of.size());
            return &from.of.data()[vertex - from.first].x;
        };
        for (std::size_t i = 0; i < 3; ++i) {
            const auto corner = loadFours(I(), [&](std::size_t l) { return at(vertexOf(l, i)); });
            x[i] = corner.of[0], y[i] = corner.of[1], w[i] = hn::BitCast(F(), corner.of[2]), planes[i] = corner.of[3];
        }
    }
    // Twice their areas in steps²; positive if clockwise on the screen.
    HWY_INLINE Ints area2() const {
        return hn::Sub(hn::Mul(hn::Sub(x[1], x[0]), hn::Sub(y[2], y[0])),
                       hn::Mul(hn::Sub(y[1], y[0]), hn::Sub(x[2], x[0])));
    }
    // Orders the vertices as in RasterTriangle: clockwise, and the farthest first (of equal ones the first). turned:
    // the lanes that are anticlockwise.
    HWY_INLINE void putInOrder(Mask turned) {
        const auto turn = [&](auto& values, auto choose) HWY_ATTR {
            const auto one = values[1];
            values[1] = choose(turned, values[2], values[1]), values[2] = choose(turned, one, values[2]);
        };
        const auto choose = [](Mask mask, Ints yes, Ints no) HWY_ATTR { return pick(mask, yes, no); };
        const auto chooseFloats = [](Mask mask, Floats yes, Floats no)
                                      HWY_ATTR { return hn::IfThenElse(mask, yes, no); };
        turn(x, choose), turn(y, choose), turn(w, chooseFloats);
        const Mask second = hn::Lt(w[2], hn::Min(w[0], w[1]));
        const Mask first = hn::AndNot(second, hn::Lt(w[1], w[0]));
        const auto rotate = [&](auto& values, auto choose_) HWY_ATTR {
            const auto a = values[0], b = values[1], c = values[2];
            values[0] = choose_(second, c, choose_(first, b, a));
            values[1] = choose_(second, a, choose_(first, c, b));
            values[2] = choose_(second, b, choose_(first, a, c));
        };
        rotate(x, choose), rotate(y, choose), rotate(w, chooseFloats);
    }
    // The edge function of an edge, with c at a position. bits: of the grid.
    HWY_INLINE EdgeInVectors edge(int from, int to, int bits, Ints atX, Ints atY) const {
        const Ints dx = hn::Sub(x[to], x[from]), dy = hn::Sub(y[to], y[from]), zero = hn::Zero(I());
        const auto owns = hn::Or(hn::Lt(dy, zero), hn::And(hn::Eq(dy, zero), hn::Gt(dx, zero)));
        return {hn::ShiftLeftSame(hn::Neg(dy), bits), hn::ShiftLeftSame(dx, bits),
                hn::Sub(hn::Mul(dx, hn::Sub(atY, y[from])), hn::Mul(dy, hn::Sub(atX, x[from]))),
                hn::IfThenZeroElse(owns, hn::Set(I(), 1))};
    }
    // The centre of a pixel's column or row, in steps.
    HWY_INLINE static Ints centre(Ints pixel, int bits) {
        return hn::Add(hn::ShiftLeftSame(pixel, bits), hn::Set(I(), 1 << (bits - 1)));
    }
};

// 1 / area for positive areas, rounded once from double.
HWY_INLINE Floats inverseOf(Ints area) {
#if HWY_TARGET == HWY_SCALAR
    return hn::Set(F(), float(1 / double(hn::GetLane(area))));
#else
    // Float holds areas of up to 24 bits exactly. Dividing in float then rounds like dividing in double and rounding to
    // float, because double has more than twice as many bits plus two. S. Figueroa, "When is double rounding
    // innocuous?", ACM SIGNUM Newsletter 1995.
    if (HWY_LIKELY(hn::AllTrue(I(), hn::Lt(area, hn::Set(I(), 1 << 24)))))
        return hn::Div(all(1), hn::ConvertTo(F(), area));
    const hn::Half<I> half;
    const hn::Rebind<double, hn::Half<F>> d;
    const auto inverse = [&](auto some) HWY_ATTR {
        return hn::DemoteTo(hn::Half<F>(), hn::Div(hn::Set(d, 1), hn::PromoteTo(d, some)));
    };
    return hn::Combine(F(), inverse(hn::UpperHalf(half, area)), inverse(hn::LowerHalf(half, area)));
#endif
}

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
