// Included once for each instruction set, like lanes.h.
#if defined(SHADESCOPE_AREA_VECTORS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHADESCOPE_AREA_VECTORS_H
#undef SHADESCOPE_AREA_VECTORS_H
#else
#define SHADESCOPE_AREA_VECTORS_H
#endif

#include <bit>

#include "pipeline/simd/lanes.h"
#include "pipeline/stages/area_vector.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {

HWY_INLINE Floats3 cross(Floats3 a, Floats3 b) {
    const auto minor = [](Floats p, Floats q, Floats r, Floats s)
                           HWY_ATTR { return hn::Sub(hn::Mul(p, q), hn::Mul(r, s)); };
    return {minor(a.y, b.z, b.y, a.z), minor(a.z, b.x, b.z, a.x), minor(a.x, b.y, b.x, a.y)};
}

// Reverses the vectors of polygons whose objects are mirrored, so that they point outward. polygonOf(l): the polygon of
// lane l.
template <class PolygonOf>
HWY_INLINE Floats3 outward(const TransformOutput<float>& in, Floats3 sum, PolygonOf polygonOf) {
    HWY_ALIGN float turned[16];
    for (std::size_t l = 0; l < hn::Lanes(F()); ++l)
        turned[l] = in.mirrored[in.topology->objectOfPolygon(polygonOf(l))] != 0 ? -1.0F : 1.0F;
    return scaled(sum, hn::Load(F(), turned));
}

// Twice the areas of triangles along their outward normals, as polygonNormals sums them. mirrors: in.anyMirrored(),
// which looks at every object. toSecond, toThird: the sides from vertex 0. polygonOf(l): the polygon of lane l.
template <class PolygonOf>
HWY_INLINE Floats3 areaVectors(const TransformOutput<float>& in, bool mirrors, Floats3 toSecond, Floats3 toThird,
                               PolygonOf polygonOf) {
    // Added to zero, like the sum over a polygon's triangles: this turns -0 into 0.
    const Floats3 sum = all(Vec3<float>(0)) + cross(toSecond, toThird);
    return mirrors ? outward(in, sum, polygonOf) : sum;
}

// The lanes whose edges must be scaled first, as in the scalar stage.
HWY_INLINE Mask areSmall(Floats3 sum) {
    return hn::Lt(hn::Max(hn::Max(hn::Abs(sum.x), hn::Abs(sum.y)), hn::Abs(sum.z)), all(smallestArea<float>()));
}

// Computes their normals one at a time. normalOf(l): the normal of lane l.
template <class NormalOf>
HWY_INLINE void replaceSmall(Mask seen, Floats3 sum, Floats3& normals, NormalOf normalOf) {
    const Mask small = hn::And(seen, areSmall(sum));
    if (HWY_LIKELY(hn::AllFalse(F(), small))) return;
    HWY_ALIGN float x[16], y[16], z[16];
    hn::Store(normals.x, F(), x), hn::Store(normals.y, F(), y), hn::Store(normals.z, F(), z);
    for (std::uint32_t rest = bitsOf(small); rest != 0; rest &= rest - 1) {
        const auto l = std::size_t(std::countr_zero(rest));
        const Vec3<float> normal = normalOf(l);
        x[l] = normal.x, y[l] = normal.y, z[l] = normal.z;
    }
    normals = {hn::Load(F(), x), hn::Load(F(), y), hn::Load(F(), z)};
}

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
