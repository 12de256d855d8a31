// Included once for each instruction set, like lanes.h.
#if defined(SHADESCOPE_KEEP_INCIDENCE_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHADESCOPE_KEEP_INCIDENCE_H
#undef SHADESCOPE_KEEP_INCIDENCE_H
#else
#define SHADESCOPE_KEEP_INCIDENCE_H
#endif

#include <algorithm>
#include <memory>

#include "pipeline/simd/incidence.h"
#include "pipeline/simd/surfaces.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {

// Records the incidence of a tile while the tile is shaded.
class IncidenceKeeper {
public:
    explicit IncidenceKeeper(std::size_t lights) : m_lights(lights) {}

    // Adds the pixels of one object in a row of blocks.
    void add(const Group& group, SpecularForm highlight) {
        std::vector<Incidence::Piece>& pieces = m_kept->pieces;
        m_first = pieces.size();
        for (std::size_t n = 0; n < group.count; ++n) {
            const std::size_t block = group.at[n] / kBlockPixels, pixel = group.at[n] % kBlockPixels;
            if (pieces.size() == m_first || pieces.back().block != block)
                pieces.push_back({std::uint32_t(group.object), 0, std::uint8_t(block), highlight});
            pieces.back().pixels = std::uint16_t(pieces.back().pixels | group.bits[n] << pixel);
        }
        m_kept->lights.resize(pieces.size() * m_lights);
    }
    // Adds light k for these pixels. log is null without a highlight, S without a shadow.
    void addLight(const Group& group, std::size_t k, const Row& nDotL, const Row* log, const Row* S) {
        std::size_t piece = m_first;
        for (std::size_t n = 0; n < group.count; ++n) {
            const std::size_t i = group.at[n], pixel = i % kBlockPixels;
            piece += m_kept->pieces[piece].block != i / kBlockPixels;
            Incidence::Light& to = m_kept->lights[piece * m_lights + k];
            const Mask mask = group.mask(n);
            const Floats cosine = load(nDotL, i), none = all(Incidence::kNoHighlight);
            const Mask lit = hn::And(mask, hn::Gt(cosine, all(0)));
            if (hn::AllFalse(F(), lit)) continue;  // no highlight either, and nothing to multiply S with
            put(cosine, to.nDotL, 0, pixel);
            if (const Floats of = log ? load(*log, i) : none; !hn::AllFalse(F(), hn::And(mask, hn::Lt(of, none))))
                put(of, to.log, Incidence::kNoHighlight, pixel);
            // S does not matter where the terms are 0 with any material.
            if (const Floats of = S ? hn::IfThenElse(lit, load(*S, i), all(1)) : all(1);
                !hn::AllTrue(F(), hn::Eq(of, all(1))))
                put(of, to.S, 1, pixel);
        }
    }
    void endRow(std::size_t y) { m_kept->first[y + 1] = std::uint32_t(m_kept->pieces.size()); }
    // Null if there are too many pieces to be worth the memory.
    std::shared_ptr<const Incidence> whole() {
        if (m_kept->pieces.size() > kMostPieces) return {};
        m_kept->pieces.shrink_to_fit(), m_kept->lights.shrink_to_fit(), m_kept->numbers.shrink_to_fit();
        return std::move(m_kept);
    }

private:
    // Stores a vector of numbers of a block, from `pixel` on. The first one makes room, with `same` at the other pixels.
    HWY_INLINE void put(Floats of, std::uint32_t& place, float same, std::size_t pixel) {
        if (place == Incidence::kSame) {
            place = std::uint32_t(m_kept->numbers.size());
            m_kept->numbers.emplace_back();
            if (kVectors > 1) std::ranges::fill(m_kept->numbers.back().of, same);
        }
        hn::Store(of, F(), m_kept->numbers[place].of + pixel);
    }

    std::size_t m_lights, m_first = 0;
    std::shared_ptr<Incidence> m_kept = std::make_shared<Incidence>();
};

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
