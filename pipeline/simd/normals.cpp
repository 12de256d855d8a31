#include "pipeline/simd/normals.h"

#include <bit>
#include <cstring>

#include "pipeline/core/numerics.h"

#include "pipeline/simd/targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/simd/normals.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
//
#include "pipeline/simd/lanes.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {

namespace {

// normalized, where no square needs scaling; gives the lanes where one does, which hold any numbers.
HWY_INLINE std::uint32_t storeUnit(Floats3 v, float* to) {
    const Floats largest = hn::Max(hn::Abs(v.x), hn::Max(hn::Abs(v.y), hn::Abs(v.z)));
    const Mask middle = hn::And(hn::Lt(largest, all(kLargestUnscaled)), hn::Gt(largest, all(1 / kLargestUnscaled)));
    const Floats square = hn::Add(hn::Add(hn::Mul(v.x, v.x), hn::Mul(v.y, v.y)), hn::Mul(v.z, v.z));
    const Floats length = hn::Sqrt(square);
    hn::StoreInterleaved3(hn::Div(v.x, length), hn::Div(v.y, length), hn::Div(v.z, length), F(), to);
    return bitsOf(hn::Not(hn::And(middle, hn::Eq(square, square))));
}

}  // namespace

void triangleNormals(const NormalsInputs& inputs, const TransformOutput<float>& in, std::size_t begin, std::size_t end,
                     NormalsOutput<float>& out) {
    const std::span<const Triangle> triangles = in.topology->triangles;
    const std::size_t lanes = hn::Lanes(F());
    std::size_t base = begin;
    for (; base + lanes <= end; base += lanes) {
        const auto corner = [&](int i) HWY_ATTR {
            return loadThrees(in.world, [&](std::size_t l) { return triangles[base + l].vertices[i]; });
        };
        const Floats3 origin = corner(0), a = corner(1) - origin, b = corner(2) - origin;
        const auto minor = [](Floats p, Floats q, Floats r, Floats s)
                               HWY_ATTR { return hn::Sub(hn::Mul(p, q), hn::Mul(r, s)); };
        // Added to zero, as the sum over a polygon's triangles is: a negative zero becomes a positive one.
        const Floats3 zero = all(Vec3<float>(0));
        Floats3 sum = zero + Floats3{minor(a.y, b.z, b.y, a.z), minor(a.z, b.x, b.z, a.x), minor(a.x, b.y, b.x, a.y)};
        HWY_ALIGN float turned[16];
        bool mirrors = false;
        for (std::size_t l = 0; l < lanes; ++l) {
            const bool mirrored = in.mirrored[in.topology->objectOfPolygon(base + l)] != 0;
            turned[l] = mirrored ? -1.0F : 1.0F;
            mirrors = mirrors || mirrored;
        }
        if (mirrors) sum = scaled(sum, hn::Load(F(), turned));
        if (!out.weighted.empty()) hn::StoreInterleaved3(sum.x, sum.y, sum.z, F(), &out.weighted[base].x);
        const std::uint32_t rest = storeUnit(sum, &out.polygon[base].x);
        for (std::uint32_t bits = rest; bits != 0; bits &= bits - 1) {
            const std::size_t other = base + std::size_t(std::countr_zero(bits));
            polygonNormals(inputs, in, other, other + 1, out);
        }
    }
    polygonNormals(inputs, in, base, end, out);
}

void unitSums(const NormalsInputs& inputs, const TransformOutput<float>& in, std::size_t object, std::size_t begin,
              std::size_t end, NormalsOutput<float>& out) {
    const std::size_t lanes = hn::Lanes(F());
    std::size_t i = begin;
    for (; i + lanes <= end; i += lanes) {
        float* const at = &out.vertex[in.topology->firstVertex[object] + i].x;
        Floats3 sum;
        hn::LoadInterleaved3(F(), at, sum.x, sum.y, sum.z);
        HWY_ALIGN float units[3 * 16];
        const std::uint32_t rest = storeUnit(sum, units);
        for (std::uint32_t bits = rest; bits != 0; bits &= bits - 1) {
            const auto l = std::size_t(std::countr_zero(bits));
            const Vec3<float> unit = normalized(Vec3<float>(at[3 * l], at[3 * l + 1], at[3 * l + 2]));
            std::memcpy(units + 3 * l, &unit, sizeof unit);
        }
        std::memcpy(at, units, 3 * lanes * sizeof(float));
    }
    unitVertexNormals(inputs, in, object, i, end, out);
}

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pipeline {

HWY_EXPORT(triangleNormals);
HWY_EXPORT(unitSums);

void polygonNormalsInVectors(const NormalsInputs& inputs, const TransformOutput<float>& in, std::size_t begin,
                             std::size_t end, NormalsOutput<float>& out) {
    const bool triangles = in.topology->triangles.size() == in.topology->polygonCount();
    const bool stable = inputs.form == PolygonNormalForm::Newell && inputs.unit == UnitForm::Scaled;
    if (!triangles || !stable) return polygonNormals(inputs, in, begin, end, out);
    HWY_DYNAMIC_DISPATCH(triangleNormals)(inputs, in, begin, end, out);
}

void unitVertexNormalsInVectors(const NormalsInputs& inputs, const TransformOutput<float>& in, std::size_t object,
                                std::size_t begin, std::size_t end, NormalsOutput<float>& out) {
    const bool given = inputs.weight == NormalWeight::Given && !in.topology->meshes[object]->normals.empty();
    if (given || inputs.unit != UnitForm::Scaled) return unitVertexNormals(inputs, in, object, begin, end, out);
    HWY_DYNAMIC_DISPATCH(unitSums)(inputs, in, object, begin, end, out);
}

}  // namespace pipeline
#endif
