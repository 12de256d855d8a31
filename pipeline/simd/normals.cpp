#include "pipeline/simd/normals.h"

#include "pipeline/simd/targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/simd/normals.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
//
#include "pipeline/simd/lanes.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {

void triangleNormals(const NormalsInputs& inputs, const TransformOutput<float>& in, std::size_t begin, std::size_t end,
                     NormalsOutput<float>& out) {
    const I whole;
    const std::size_t lanes = hn::Lanes(whole);
    std::size_t base = begin;
    for (; base + lanes <= end; base += lanes) {
        Ints v[3], polygon;
        hn::LoadInterleaved4(whole, reinterpret_cast<const std::int32_t*>(&in.topology->triangles[base]), v[0], v[1],
                             v[2], polygon);
        const Floats3 origin = gather(in.world, v[0]), a = gather(in.world, v[1]) - origin,
                      b = gather(in.world, v[2]) - origin;
        const auto minor = [](Floats p, Floats q, Floats r, Floats s)
                               HWY_ATTR { return hn::Sub(hn::Mul(p, q), hn::Mul(r, s)); };
        // Added to zero, as the sum over a polygon's triangles is: a negative zero becomes a positive one.
        const Floats3 zero = all(Vec3<float>(0));
        Floats3 sum = zero + Floats3{minor(a.y, b.z, b.y, a.z), minor(a.z, b.x, b.z, a.x), minor(a.x, b.y, b.x, a.y)};
        HWY_ALIGN float turned[16];
        bool mirrors = false;
        for (std::size_t l = 0; l < lanes; ++l) {
            const bool mirrored = in.mirrored[in.topology->polygonObject[base + l]] != 0;
            turned[l] = mirrored ? -1.0F : 1.0F;
            mirrors = mirrors || mirrored;
        }
        if (mirrors) sum = scaled(sum, hn::Load(F(), turned));
        if (!out.weighted.empty()) hn::StoreInterleaved3(sum.x, sum.y, sum.z, F(), &out.weighted[base].x);
        // normalized, where its squares need no scaling.
        const Floats largest = hn::Max(hn::Abs(sum.x), hn::Max(hn::Abs(sum.y), hn::Abs(sum.z)));
        const Mask middle = hn::And(hn::Lt(largest, all(0x1p30F)), hn::Gt(largest, all(0x1p-30F)));
        const Floats length =
            hn::Sqrt(hn::Add(hn::Add(hn::Mul(sum.x, sum.x), hn::Mul(sum.y, sum.y)), hn::Mul(sum.z, sum.z)));
        hn::StoreInterleaved3(hn::Div(sum.x, length), hn::Div(sum.y, length), hn::Div(sum.z, length), F(),
                              &out.polygon[base].x);
        if (hn::AllTrue(F(), middle)) continue;
        HWY_ALIGN float isMiddle[16];
        hn::Store(hn::IfThenElseZero(middle, all(1)), F(), isMiddle);
        for (std::size_t l = 0; l < lanes; ++l)
            if (isMiddle[l] == 0) polygonNormals(inputs, in, base + l, base + l + 1, out);
    }
    polygonNormals(inputs, in, base, end, out);
}

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pipeline {

HWY_EXPORT(triangleNormals);

void polygonNormalsInVectors(const NormalsInputs& inputs, const TransformOutput<float>& in, std::size_t begin,
                             std::size_t end, NormalsOutput<float>& out) {
    const bool triangles = in.topology->triangles.size() == in.topology->polygonCount();
    const bool stable = inputs.form == PolygonNormalForm::Newell && inputs.unit == UnitForm::Scaled;
    if (!triangles || !stable) return polygonNormals(inputs, in, begin, end, out);
    HWY_DYNAMIC_DISPATCH(triangleNormals)(inputs, in, begin, end, out);
}

}  // namespace pipeline
#endif
