// Included once for each instruction set, like lanes.h.
#if defined(SHADESCOPE_KEEP_INCIDENCE_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHADESCOPE_KEEP_INCIDENCE_H
#undef SHADESCOPE_KEEP_INCIDENCE_H
#else
#define SHADESCOPE_KEEP_INCIDENCE_H
#endif

#include <memory>

#include "pipeline/simd/incidence.h"
#include "pipeline/simd/surfaces.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {

// Takes down the incidence in a tile while it is shaded.
class IncidenceKeeper {
public:
    explicit IncidenceKeeper(std::size_t lights) : m_lights(lights) {}

    // The pixels of one object in a row of blocks.
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
    // Light k on them. Its log and S are null where it has no highlight and no shadow.
    void addLight(const Group& group, std::size_t k, const Row& nDotL, const Row* log, const Row* S) {
        std::size_t piece = m_first;
        for (std::size_t n = 0; n < group.count; ++n) {
            const std::size_t i = group.at[n], pixel = i % kBlockPixels;
            piece += m_kept->pieces[piece].block != i / kBlockPixels;
            Incidence::Light& to = m_kept->lights[piece * m_lights + k];
            const Floats cosine = load(nDotL, i), none = all(Incidence::kNoHighlight);
            hn::Store(cosine, F(), to.nDotL + pixel);
            hn::Store(log ? load(*log, i) : none, F(), to.log + pixel);
            // Where there is nothing to multiply, whatever the material, it need not be known.
            hn::Store(S ? hn::IfThenElse(hn::Gt(cosine, all(0)), load(*S, i), all(1)) : all(1), F(), to.S + pixel);
        }
    }
    void endRow(std::size_t y) { m_kept->first[y + 1] = std::uint32_t(m_kept->pieces.size()); }
    // Nothing where it is too many pieces to be worth their memory.
    std::shared_ptr<const Incidence> whole() {
        if (m_kept->pieces.size() > kMostPieces) return {};
        m_kept->pieces.shrink_to_fit(), m_kept->lights.shrink_to_fit();
        return std::move(m_kept);
    }

private:
    std::size_t m_lights, m_first = 0;
    std::shared_ptr<Incidence> m_kept = std::make_shared<Incidence>();
};

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
