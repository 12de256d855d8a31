#include "pipeline/simd/relight.h"

#include <bit>

#include "pipeline/simd/targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/simd/relight.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
//
#include "pipeline/simd/power.h"
#include "pipeline/simd/put_pixels.h"
#include "pipeline/simd/surfaces.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {
namespace {

// Lights the pixels of a tile again, one row of blocks at a time.
template <class A>
class TileRelighter {
public:
    TileRelighter(const ShadingInputs& inputs, std::span<const Look> looks, const Incidence& kept)
        : m_count(inputs.lights.size()),
          m_looks(looks),
          m_kept(kept),
          m_vanishesFrom(vanishesFrom<float>(inputs.illumination.detail.logContrast)) {
        for (std::size_t k = 0; k < m_count; ++k)
            if (inputs.parts.of(Part::Light, k)) m_lights.push_back(k);
        for (const Look& look : looks) m_bases.push_back(sumOf(look.base));
    }
    bool relight(Tile tile, ShadingOutput<float>& out, ShadingCounts& counts) {
        const ToBytes bytes(out.iMax);
        Row3 intensity;
        for (int y = 0; y * kBlock < tile.max.y - tile.min.y; ++y) {
            const auto row = std::size_t(y);
            std::uint32_t blocks = 0;
            for (std::size_t i = m_kept.first[row]; i < m_kept.first[row + 1]; ++i) {
                const std::uint32_t block = 1U << m_kept.pieces[i].block;
                if (!relightPiece(i, (blocks & block) != 0, intensity)) return false;
                blocks |= block;
            }
            const auto pixelsAt = [&](std::size_t) HWY_ATTR { return maskOf(~std::uint64_t(0)); };  // 0 already
            putRow<A>(intensity, blocks, pixelsAt, bytes, tile, y, out);
        }
        counts.relit += m_relit, counts.powers += m_powers;
        return true;
    }

private:
    // For the pixels of a block from `first` on.
    HWY_INLINE Floats numbers(std::uint32_t place, std::size_t first, float same) const {
        return place == Incidence::kSame ? all(same) : hn::Load(F(), m_kept.numbers[place].of + first);
    }
    // isShared: another piece of the same block has been done before.
    HWY_INLINE bool relightPiece(std::size_t number, bool isShared, Row3& intensity) {
        const Incidence::Piece& piece = m_kept.pieces[number];
        const Look& look = m_looks[piece.object];
        const bool shines = look.highlight != SpecularForm::None;
        if (shines && look.highlight != piece.highlight) return false;
        const Incidence::Light* const lights = &m_kept.lights[number * m_count];
        const Floats exponent = all(look.exponent), faintest = all(-m_vanishesFrom);
        const Floats3 base = all(m_bases[piece.object]), none = all(Vec3<float>(0));
        for (std::size_t first = 0; first < kBlockPixels; first += hn::Lanes(F())) {
            const std::size_t i = std::size_t(piece.block) * kBlockPixels + first;
            const Mask mask = maskOf(std::uint64_t(piece.pixels) >> first);
            Floats3 sum = base;
            for (const std::size_t k : m_lights) {
                const Reflected& reflected = look.lights[k];
                // The operations of TileShader, in the same order.
                const Incidence::Light& light = lights[k];
                if (look.isFinite && light.nDotL == Incidence::kSame) continue;
                const Floats nDotL = numbers(light.nDotL, first, 0);
                const Mask lit = hn::And(mask, hn::Gt(nDotL, all(0)));
                if (look.isFinite && hn::AllFalse(F(), lit)) continue;  // the terms are 0
                Floats3 diffuse = where(lit, scaled(all(reflected.diffuse), nDotL)), specular = none;
                const auto shine = [&] HWY_ATTR {
                    if (look.isFinite && light.log == Incidence::kSame) return false;
                    const Floats log = numbers(light.log, first, Incidence::kNoHighlight);
                    const Floats y = hn::Mul(exponent, log);
                    const Mask there = hn::And(mask, hn::And(hn::Le(log, all(0)), hn::Ge(y, faintest)));
                    if (look.isFinite && hn::AllFalse(F(), there)) return false;
                    const Floats power = hn::IfThenElseZero(there, expOfNegative<A>(y));
                    specular = scaled(all(reflected.specular), power);
                    m_powers += static_cast<long long>(hn::CountTrue(F(), there));
                    return true;
                };
                // A sum is never -0, because the base is not, so terms of 0 need not be added.
                if (HWY_LIKELY(light.S == Incidence::kSame)) {
                    sum = sum + diffuse;
                    if (shines && shine()) sum = sum + specular;
                    continue;
                }
                if (shines) shine();
                const Floats S = numbers(light.S, first, 1);
                const Mask unknown = hn::And(lit, hn::Gt(S, all(1)));
                if (HWY_UNLIKELY(!hn::AllFalse(F(), unknown)))
                    if (!hn::AllFalse(F(), hn::AndNot(areZero(diffuse, specular), unknown))) return false;
                sum = sum + scaled(diffuse, S) + scaled(specular, S);
            }
            store(choose(mask, sum, isShared ? load(intensity, i) : none), intensity, i);
        }
        m_relit += std::popcount(piece.pixels) * static_cast<long long>(m_lights.size());
        return true;
    }
    HWY_INLINE static Mask areZero(Floats3 a, Floats3 b) {
        const auto isZero = [](Floats3 v) HWY_ATTR {
            return hn::And(hn::Eq(v.x, all(0)), hn::And(hn::Eq(v.y, all(0)), hn::Eq(v.z, all(0))));
        };
        return hn::And(isZero(a), isZero(b));
    }

    std::size_t m_count;
    std::span<const Look> m_looks;
    const Incidence& m_kept;
    float m_vanishesFrom;               // -log of a power
    std::vector<std::size_t> m_lights;  // those that shine
    std::vector<Vec3<float>> m_bases;   // for each object: its intensity without any light
    long long m_relit = 0, m_powers = 0;
};

}  // namespace

bool relightTile(const ShadingInputs& inputs, std::span<const Look> looks, const Incidence& kept, Tile tile,
                 ShadingOutput<float>& out, ShadingCounts& counts) {
    return inputs.parts[Part::FastVectors] ? TileRelighter<Fast>(inputs, looks, kept).relight(tile, out, counts)
                                           : TileRelighter<Exact>(inputs, looks, kept).relight(tile, out, counts);
}

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pipeline {

HWY_EXPORT(relightTile);

bool relightInVectors(const ShadingInputs& inputs, std::span<const Look> looks, const Incidence& kept, Tile tile,
                      ShadingOutput<float>& out, ShadingCounts& counts) {
    return HWY_DYNAMIC_DISPATCH(relightTile)(inputs, looks, kept, tile, out, counts);
}

}  // namespace pipeline
#endif
