// Included once for each instruction set, like lanes.h.
#if defined(SHADESCOPE_PLANE_EQUATIONS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHADESCOPE_PLANE_EQUATIONS_H
#undef SHADESCOPE_PLANE_EQUATIONS_H
#else
#define SHADESCOPE_PLANE_EQUATIONS_H
#endif

#include "pipeline/simd/snapped_corners.h"
#include "pipeline/stages/rasterize.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {

// The PlaneEquation of each lane's triangle.
struct PlanesInVectors {
    Floats first, column, row;
};

// Computes planeEquation in double, in the same order. In grid steps every number is that of planeEquation times a
// power of 2.
template <class D>
struct PlanesInDouble {
    using V = hn::Vec<D>;
    V first, column, row;  // column, row: for one grid step

    // x, y, w: of the vertices, in order. atX, atY: the centre of the planes' first pixels, in steps.
    template <class H, class HF>
    HWY_INLINE PlanesInDouble(const H (&x)[3], const H (&y)[3], const HF (&w)[3], H area, H atX, H atY) {
        const D d;
        const auto wide = [&](auto of) HWY_ATTR { return hn::PromoteTo(d, of); };
        const V inverse = hn::Div(hn::Set(d, 1), wide(area)), w0 = wide(w[0]);
        const V one = hn::Sub(wide(w[1]), w0), two = hn::Sub(wide(w[2]), w0);
        const auto slope = [&](H p20, H p01) HWY_ATTR {
            return hn::Mul(hn::Add(hn::Mul(one, wide(p20)), hn::Mul(two, wide(p01))), inverse);
        };
        column = slope(hn::Sub(y[2], y[0]), hn::Sub(y[0], y[1])), row = slope(hn::Sub(x[0], x[2]), hn::Sub(x[1], x[0]));
        first = hn::Add(w0, hn::Add(hn::Mul(column, wide(hn::Sub(atX, x[0]))), hn::Mul(row, wide(hn::Sub(atY, y[0])))));
    }
};

// area: positive. from: the planes' first pixels; side: of the triangles' boxes, in steps. holds: the lanes whose plane
// is accurate enough; arbitrary for tiny triangles.
HWY_INLINE PlanesInVectors planesOf(const SnappedCorners& corners, Ints area, Ints fromX, Ints fromY, Ints sideX,
                                    Ints sideY, int bits, bool perspective, Mask& holds) {
    const Ints(&x)[3] = corners.x, (&y)[3] = corners.y;
    const Floats(&w)[3] = corners.w;
    const Ints atX = SnappedCorners::centre(fromX, bits), atY = SnappedCorners::centre(fromY, bits);
    PlanesInVectors out{hn::Zero(F()), hn::Zero(F()), hn::Zero(F())};
#if HWY_TARGET == HWY_SCALAR  // whose vectors of one number have no halves
    using D = hn::Rebind<double, F>;
    const auto pixel = hn::Set(D(), double(1 << bits));
    const PlanesInDouble<D> planes(x, y, w, area, atX, atY);
    out.first = hn::DemoteTo(F(), planes.first);
    out.column = hn::DemoteTo(F(), hn::Mul(planes.column, pixel)),
    out.row = hn::DemoteTo(F(), hn::Mul(planes.row, pixel));
#else
    using D = hn::Rebind<double, hn::Half<F>>;
    const hn::Half<I> ints;
    const hn::Half<F> floats;
    const auto pixel = hn::Set(D(), double(1 << bits));
    const auto half = [&](auto part) HWY_ATTR {
        const hn::Vec<hn::Half<I>> hx[3]{part(ints, x[0]), part(ints, x[1]), part(ints, x[2])};
        const hn::Vec<hn::Half<I>> hy[3]{part(ints, y[0]), part(ints, y[1]), part(ints, y[2])};
        const hn::Vec<hn::Half<F>> hw[3]{part(floats, w[0]), part(floats, w[1]), part(floats, w[2])};
        return PlanesInDouble<D>(hx, hy, hw, part(ints, area), part(ints, atX), part(ints, atY));
    };
    const auto low = half([](auto d, auto v) HWY_ATTR { return hn::LowerHalf(d, v); });
    const auto high = half([](auto d, auto v) HWY_ATTR { return hn::UpperHalf(d, v); });
    const auto both = [&](hn::Vec<D> one, hn::Vec<D> two)
                          HWY_ATTR { return hn::Combine(F(), hn::DemoteTo(floats, two), hn::DemoteTo(floats, one)); };
    out.first = both(low.first, high.first);
    out.column = both(hn::Mul(low.column, pixel), hn::Mul(high.column, pixel));
    out.row = both(hn::Mul(low.row, pixel), hn::Mul(high.row, pixel));
#endif
    const auto reach = [&](Ints side) HWY_ATTR {
        return hn::Add(hn::Mul(hn::ConvertTo(F(), side), all(1.0F / float(1 << bits))), all(float(kBlock)));
    };
    const Floats grows = hn::Add(hn::Mul(hn::Abs(out.column), reach(sideX)), hn::Mul(hn::Abs(out.row), reach(sideY)));
    const Floats least = perspective ? w[0] : hn::Max(hn::Abs(w[0]), hn::Max(hn::Abs(w[1]), hn::Abs(w[2])));
    holds = hn::Le(grows, hn::Mul(all(float(kSteepest)), least));
    return out;
}

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
