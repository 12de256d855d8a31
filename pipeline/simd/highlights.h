// Included once for each instruction set, like lanes.h.
#if defined(SHADESCOPE_HIGHLIGHTS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHADESCOPE_HIGHLIGHTS_H
#undef SHADESCOPE_HIGHLIGHTS_H
#else
#define SHADESCOPE_HIGHLIGHTS_H
#endif

#include "pipeline/core/numerics.h"
#include "pipeline/simd/incidence.h"
#include "pipeline/simd/power.h"
#include "pipeline/simd/rows.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {

HWY_INLINE long long countOf(Mask mask) { return static_cast<long long>(hn::CountTrue(F(), mask)); }

// The q of a pixel without a highlight; otherwise q is 1 - R·V or 1 - N·H, at most 2.
inline constexpr float kNoHighlight = 4;

struct HighlightCounts {
    long long there = 0, vanished = 0;  // of `there`: too small to count
};

// Computes the powers of highlights, and their logarithms if `logs` is not null (Incidence::kNoHighlight where there is
// no highlight). Only for vectors with a lane in `asked`. vanishesFrom: exponent times q above which a power is too
// small to count.
template <class A>
HWY_INLINE HighlightCounts raiseHighlights(const Group& group, float exponent, float vanishesFrom, const Row& qs,
                                           Row& powers, Row* logs) {
    const Floats power = all(exponent), none = all(Incidence::kNoHighlight);
    const bool mayVanish = exponent * kNoHighlight > vanishesFrom;
    HighlightCounts counts;
    Group asking;
    for (std::size_t n = 0; n < group.count; ++n) {
        const std::size_t i = group.at[n];
        const Floats q = load(qs, i);
        const Mask there = hn::Lt(q, all(kNoHighlight));
        counts.there += countOf(there);
        Mask asked = hn::Lt(q, all(1));
        if (mayVanish) {
            const Mask vanishes = hn::And(there, hn::Gt(hn::Mul(power, q), all(vanishesFrom)));
            counts.vanished += countOf(vanishes);
            if (!logs) asked = hn::AndNot(vanishes, asked);  // with another exponent they may not vanish
        }
        if (const std::uint32_t bits = bitsOf(asked); bits != 0) {
            asking.add(i, bits);
        } else {
            store(all(0), powers, i);
            if (logs) store(none, *logs, i);
        }
    }
    // Two vectors at a time, because each is a long chain of dependent operations.
    for (std::size_t n = 0; n < asking.count; n += 2) {
        const std::size_t next = std::min(n + 1, asking.count - 1), i = asking.at[n], j = asking.at[next];
        const Mask asked = asking.mask(n), askedNext = asking.mask(next);
        const Floats log = logOneMinus<A>(hn::IfThenElseZero(asked, load(qs, i)));
        const Floats logNext = logOneMinus<A>(hn::IfThenElseZero(askedNext, load(qs, j)));
        const Floats raised = expOfNegative<A>(hn::Mul(power, log));
        const Floats raisedNext = expOfNegative<A>(hn::Mul(power, logNext));
        store(hn::IfThenElseZero(asked, raised), powers, i);
        store(hn::IfThenElseZero(askedNext, raisedNext), powers, j);
        if (!logs) continue;
        store(hn::IfThenElse(asked, log, none), *logs, i);
        store(hn::IfThenElse(askedNext, logNext, none), *logs, j);
    }
    return counts;
}

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
