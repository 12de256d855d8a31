// Included once for each instruction set, like lanes.h.
#if defined(SHADESCOPE_MICROFACETS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHADESCOPE_MICROFACETS_H
#undef SHADESCOPE_MICROFACETS_H
#else
#define SHADESCOPE_MICROFACETS_H
#endif

#include "pipeline/simd/arithmetic.h"
#include "pipeline/simd/look.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {

// The terms that one light adds, in each lane.
struct Terms {
    Floats3 diffuse, specular;
};

// addCookTorrance in each lane of `lit`, which is where N·L > 0; 0 in the others. The same operations in the same order.
// N, H, V: unit vectors.
template <class A>
HWY_INLINE Terms microfacetTerms(const Mirrors& mirrors, const Reflected& reflected, Floats3 N, Floats3 H, Floats3 V,
                                 Floats nDotL, Floats nDotH, Mask lit) {
    const Floats one = all(1), two = all(2);
    const auto cosine = [&](Floats c) HWY_ATTR { return hn::Min(hn::Max(c, all(0)), one); };
    const auto fifth = [](Floats x) HWY_ATTR {
        const Floats square = hn::Mul(x, x);
        return hn::Mul(hn::Mul(square, square), x);
    };
    const auto lessFifth = [&](Floats c) HWY_ATTR { return hn::Sub(one, fifth(hn::Sub(one, c))); };
    const Floats square = all(mirrors.square), rest = all(1 - mirrors.square);
    const auto root = [&](Floats c) HWY_ATTR { return hn::Sqrt(A::mulAdd(hn::Mul(rest, c), c, square)); };

    const Floats cosL = cosine(nDotL), cosV = cosine(A::dot(N, V)), cosH = cosine(nDotH);
    const Floats through = hn::Mul(lessFifth(cosL), lessFifth(cosV));
    const Floats grazing = fifth(hn::Sub(one, cosine(A::dot(V, H))));
    const Floats3 difference = N - H;
    const Floats q = hn::Mul(A::dot(difference, difference), all(0.5F));
    const Floats narrow = hn::IfThenElse(hn::Gt(cosH, all(0)), hn::Mul(q, hn::Sub(two, q)), one);
    const Floats spread = A::mulAdd(hn::Mul(square, cosH), cosH, narrow);
    const Floats density = hn::Div(square, hn::Mul(spread, spread));
    const Floats masked = A::mulAdd(hn::Div(cosV, cosL), root(cosL), root(cosV));
    const Floats seen = hn::Div(one, hn::Mul(two, masked));

    const auto fresnel = [&](float ks) HWY_ATTR { return A::mulAdd(all(1 - ks), grazing, all(ks)); };
    const Vec3<float>& ks = mirrors.specular;
    const Floats3 mirrored{hn::Mul(all(reflected.specular.x), fresnel(ks.x)),
                           hn::Mul(all(reflected.specular.y), fresnel(ks.y)),
                           hn::Mul(all(reflected.specular.z), fresnel(ks.z))};
    return {where(lit, scaled(scaled(all(reflected.diffuse), through), cosL)),
            where(lit, scaled(scaled(mirrored, density), seen) + all(Vec3<float>(0)))};
}

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
