#include "pipeline/simd/normals.h"

#include <algorithm>

#include "pipeline/simd/fetch_ahead.h"
#include "pipeline/simd/targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/simd/normals.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
//
#include "pipeline/simd/area_vectors.h"
#include "pipeline/simd/arithmetic.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {

namespace {

HWY_INLINE void storeUnit(Floats3 v, float* to) {
    const Floats3 unit = Exact::unit(v, hn::Eq(hn::Zero(F()), hn::Zero(F())));
    hn::StoreInterleaved3(unit.x, unit.y, unit.z, F(), to);
}

}  // namespace

void triangleNormals(const NormalsInputs& inputs, const TransformOutput<float>& in, std::size_t begin, std::size_t end,
                     NormalsOutput<float>& out) {
    const std::span<const Triangle> triangles = in.topology->triangles;
    const std::size_t lanes = hn::Lanes(F());
    const bool mirrors = in.anyMirrored();
    std::size_t base = begin;
    for (; base + lanes <= end; base += lanes) {
        const Triangle* const here = &triangles[base];
        fetchAhead(here, lanes);
        const auto corner = [&](int i) HWY_ATTR {
            return loadThrees(in.world, [&](std::size_t l) { return here[l].vertices[i]; });
        };
        const Floats3 origin = corner(0), a = corner(1) - origin, b = corner(2) - origin;
        const Floats3 sum = areaVectors(in, mirrors, a, b, [&](std::size_t l) { return base + l; });
        if (HWY_UNLIKELY(!hn::AllFalse(F(), areSmall(sum)))) {
            polygonNormals(inputs, in, base, base + lanes, out);
            continue;
        }
        if (!out.weighted.empty()) hn::StoreInterleaved3(sum.x, sum.y, sum.z, F(), &out.weighted[base].x);
        storeUnit(sum, &out.polygon[base].x);
    }
    polygonNormals(inputs, in, base, end, out);
}

// For meshes that are not all triangles: one polygon in each lane. Polygons with many vertices are left to the scalar
// stage, because the other lanes would wait for them.
void polygonSums(const NormalsInputs& inputs, const TransformOutput<float>& in, std::size_t begin, std::size_t end,
                 NormalsOutput<float>& out) {
    constexpr std::size_t kMostCorners = 8;
    const std::size_t lanes = hn::Lanes(F());
    const bool mirrors = in.anyMirrored();
    std::size_t base = begin;
    for (; base + lanes <= end; base += lanes) {
        Topology::Corners corners[16];
        HWY_ALIGN std::int32_t counts[16];
        std::size_t most = 0;
        for (std::size_t l = 0; l < lanes; ++l) {
            corners[l] = in.topology->corners(base + l);
            counts[l] = std::int32_t(std::min(corners[l].size(), kMostCorners + 1)),
            most = std::max(most, corners[l].size());
        }
        if (most > kMostCorners) {
            polygonNormals(inputs, in, base, base + lanes, out);
            continue;
        }
        const Ints count = hn::Load(I(), counts);
        // Vertex i of each polygon, or its last one if it has fewer.
        const auto corner = [&](std::size_t i) HWY_ATTR {
            return loadThrees(in.world, [&](std::size_t l) { return corners[l][std::min(i, corners[l].size() - 1)]; });
        };
        const Floats3 origin = corner(0);
        Floats3 sum = all(Vec3<float>(0)), before = corner(1) - origin;
        for (std::size_t i = 2; i < most; ++i) {
            const Floats3 here = corner(i) - origin;
            const Mask isThere = asFloats(hn::Gt(count, hn::Set(I(), std::int32_t(i))));
            const Floats3 more = sum + cross(before, here);
            sum = {hn::IfThenElse(isThere, more.x, sum.x), hn::IfThenElse(isThere, more.y, sum.y),
                   hn::IfThenElse(isThere, more.z, sum.z)};
            before = here;
        }
        if (HWY_UNLIKELY(!hn::AllFalse(F(), areSmall(sum)))) {
            polygonNormals(inputs, in, base, base + lanes, out);
            continue;
        }
        if (mirrors) sum = outward(in, sum, [&](std::size_t l) { return base + l; });
        if (!out.weighted.empty()) hn::StoreInterleaved3(sum.x, sum.y, sum.z, F(), &out.weighted[base].x);
        storeUnit(sum, &out.polygon[base].x);
    }
    polygonNormals(inputs, in, base, end, out);
}

void unitSums(const NormalsInputs& inputs, const TransformOutput<float>& in, std::size_t object, std::size_t begin,
              std::size_t end, NormalsOutput<float>& out) {
    const std::size_t lanes = hn::Lanes(F());
    std::size_t i = begin;
    for (; i + lanes <= end; i += lanes) {
        float* const at = &out.vertex.own()[in.topology->firstVertex[object] + i].x;
        Floats3 sum;
        hn::LoadInterleaved3(F(), at, sum.x, sum.y, sum.z);
        storeUnit(sum, at);
    }
    unitVertexNormals(inputs, in, object, i, end, out);
}

// The mesh's own numbers in double. given: these numbers, in float or in double.
template <class T>
HWY_INLINE void unitGivenIn(std::span<const Vec3<T>> given, const NormalsInputs& inputs,
                            const TransformOutput<float>& in, std::size_t object, std::size_t begin, std::size_t end,
                            NormalsOutput<float>& out) {
    const hn::CappedTag<double, 8> d;
    const hn::Rebind<float, decltype(d)> f;
    const glm::dmat3& matrix = in.normalMatrix[object];
    const std::size_t lanes = hn::Lanes(d), first = in.topology->firstVertex[object];
    const std::span<Vec3<float>> normals = out.vertex.own();
    std::size_t i = begin;
    for (; i + lanes <= end; i += lanes) {
        fetchAhead(&given[i], lanes);
        auto x = hn::Zero(d), y = x, z = x;
        if constexpr (std::is_same_v<T, float>) {
            auto narrowX = hn::Zero(f), narrowY = narrowX, narrowZ = narrowX;
            hn::LoadInterleaved3(f, &given[i].x, narrowX, narrowY, narrowZ);
            x = hn::PromoteTo(d, narrowX), y = hn::PromoteTo(d, narrowY), z = hn::PromoteTo(d, narrowZ);
        } else {
            hn::LoadInterleaved3(d, &given[i].x, x, y, z);
        }
        const auto row = [&](int r) HWY_ATTR {
            const auto of = [&](int column, auto v) HWY_ATTR { return hn::Mul(hn::Set(d, matrix[column][r]), v); };
            return hn::Add(hn::Add(of(0, x), of(1, y)), of(2, z));
        };
        const auto nx = row(0), ny = row(1), nz = row(2);
        const auto square = hn::Add(hn::Add(hn::Mul(nx, nx), hn::Mul(ny, ny)), hn::Mul(nz, nz));
        if (HWY_UNLIKELY(!hn::AllTrue(d, needsNoScaling(d, square)))) {
            unitVertexNormals(inputs, in, object, i, i + lanes, out);
            continue;
        }
        const auto stays = hn::Le(hn::Abs(hn::Sub(square, hn::Set(d, 1))), hn::Set(d, kOffUnit<float>));
        const auto length = hn::IfThenElse(stays, hn::Set(d, 1), hn::Sqrt(square));
        const auto unit = [&](auto v) HWY_ATTR { return hn::DemoteTo(f, hn::Div(v, length)); };
        hn::StoreInterleaved3(unit(nx), unit(ny), unit(nz), f, &normals[first + i].x);
    }
    unitVertexNormals(inputs, in, object, i, end, out);
}
void unitGiven(const NormalsInputs& inputs, const TransformOutput<float>& in, std::size_t object, std::size_t begin,
               std::size_t end, NormalsOutput<float>& out) {
    const VertexVectors& given = in.topology->meshes[object]->normals;
    if (given.doubles().empty())
        unitGivenIn(given.floats(), inputs, in, object, begin, end, out);
    else
        unitGivenIn(given.doubles(), inputs, in, object, begin, end, out);
}

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pipeline {

HWY_EXPORT(triangleNormals);
HWY_EXPORT(polygonSums);
HWY_EXPORT(unitSums);
HWY_EXPORT(unitGiven);

void polygonNormalsInVectors(const NormalsInputs& inputs, const TransformOutput<float>& in, std::size_t begin,
                             std::size_t end, NormalsOutput<float>& out) {
    const bool stable = inputs.form == PolygonNormalForm::Newell && inputs.unit == UnitForm::Scaled;
    if (!stable) return polygonNormals(inputs, in, begin, end, out);
    if (in.topology->triangles.size() == in.topology->polygonCount())
        HWY_DYNAMIC_DISPATCH(triangleNormals)(inputs, in, begin, end, out);
    else
        HWY_DYNAMIC_DISPATCH(polygonSums)(inputs, in, begin, end, out);
}

void unitVertexNormalsInVectors(const NormalsInputs& inputs, const TransformOutput<float>& in, std::size_t object,
                                std::size_t begin, std::size_t end, NormalsOutput<float>& out) {
    if (inputs.unit != UnitForm::Scaled) return unitVertexNormals(inputs, in, object, begin, end, out);
    if (inputs.weight == NormalWeight::Given && !in.topology->meshes[object]->normals.empty())
        HWY_DYNAMIC_DISPATCH(unitGiven)(inputs, in, object, begin, end, out);
    else
        HWY_DYNAMIC_DISPATCH(unitSums)(inputs, in, object, begin, end, out);
}

}  // namespace pipeline
#endif
