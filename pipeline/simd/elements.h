// Included once for each instruction set, like lanes.h.
#if defined(SHADESCOPE_ELEMENTS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHADESCOPE_ELEMENTS_H
#undef SHADESCOPE_ELEMENTS_H
#else
#define SHADESCOPE_ELEMENTS_H
#endif

#include <vector>

#include "pipeline/simd/surfaces.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {

// The first or the second 3-vector of each pair in an array.
template <class Pair>
HWY_INLINE Floats3 gatherOf(const std::vector<Pair>& values, Ints index, int which) {
    static_assert(sizeof(Pair) == 6 * sizeof(float));
    const auto* base = reinterpret_cast<const float*>(values.data()) + std::ptrdiff_t(3) * which;
    const Ints at = hn::Mul(index, hn::Set(I(), 6));
    const Ints one = hn::Set(I(), 1);
    return {hn::GatherIndex(F(), base, at), hn::GatherIndex(F(), base, hn::Add(at, one)),
            hn::GatherIndex(F(), base, hn::Add(at, hn::Add(one, one)))};
}

// For each pixel of a row of blocks: the index of its polygon, or of its triangle's vertices, in
// ShadingOutput::Elements.
struct ElementRow {
    alignas(64) std::int32_t places[3][kRowPixels];  // flat shading uses the first only
};

// places: Elements::places. i: the first pixel of a vector.
HWY_INLINE void findElements(const ShadingInputs& inputs, const ShadingSources<float>& in,
                             const std::vector<std::uint32_t>& places, const SurfaceRow& row, std::size_t i,
                             ElementRow& to) {
    const auto put = [&](Ints number, int corner) HWY_ATTR {
        const auto* of = reinterpret_cast<const std::int32_t*>(places.data());
        hn::Store(places.empty() ? number : hn::GatherIndex(I(), of, number), I(), to.places[corner] + i);
    };
    if (inputs.shading == Shading::Flat) return put(hn::Load(I(), row.polygon + i), 0);
    const Ints triangle = hn::Load(I(), row.triangle + i), first = hn::Add(triangle, hn::Add(triangle, triangle));
    static_assert(sizeof(Triangle) == 12);
    const auto* words = reinterpret_cast<const std::int32_t*>(in.transform.topology->triangles.data());
    for (int corner = 0; corner < 3; ++corner)
        put(hn::GatherIndex(I(), words, hn::Add(first, hn::Set(I(), corner))), corner);
}

// The terms of the pixels of a vector.
template <class A>
struct Elements {
    bool flat;
    Floats3 weights;
    Ints of[3];
    HWY_INLINE Elements(bool isFlat, const ElementRow& row, const Row3& weightsOf, std::size_t i)
        : flat(isFlat), weights(load(weightsOf, i)) {
        of[0] = hn::Load(I(), row.places[0] + i);
        for (int corner = 1; corner < 3; ++corner) of[corner] = flat ? of[0] : hn::Load(I(), row.places[corner] + i);
    }
    // Interpolates by differences, so that equal values stay exactly equal.
    template <class Pair>
    HWY_INLINE Floats3 difference(const std::vector<Pair>& values, int which) const {
        const Floats3 first = gatherOf(values, of[0], which);
        if (flat) return first;
        const Floats3 second = gatherOf(values, of[1], which) - first;
        const Floats3 third = gatherOf(values, of[2], which) - first;
        return scaledPlus<A>(third, weights.z, scaledPlus<A>(second, weights.y, first));
    }
    template <class Pair>
    HWY_INLINE Floats3 sum(const std::vector<Pair>& values, std::int32_t lights, std::int32_t k, int which) const {
        const auto at = [&](int corner) HWY_ATTR {
            return gatherOf(values, hn::Add(hn::Mul(of[corner], hn::Set(I(), lights)), hn::Set(I(), k)), which);
        };
        if (flat) return at(0);
        const Floats3 first = scaledPlus<A>(at(0), weights.x, all(Vec3<float>(0)));
        return scaledPlus<A>(at(2), weights.z, scaledPlus<A>(at(1), weights.y, first));
    }
};

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
