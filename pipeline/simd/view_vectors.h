// Included once for each instruction set, like lanes.h.
#if defined(SHADESCOPE_VIEW_VECTORS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHADESCOPE_VIEW_VECTORS_H
#undef SHADESCOPE_VIEW_VECTORS_H
#else
#define SHADESCOPE_VIEW_VECTORS_H
#endif

#include "pipeline/simd/arithmetic.h"
#include "pipeline/simd/blocks.h"
#include "pipeline/simd/rows.h"
#include "pipeline/stages/interpolate.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {

// V at the pixels of a tile, one row of blocks at a time: towardsEye. One part of the ray through a pixel is the same
// in a whole column, the other in a whole row.
class ViewVectors {
public:
    ViewVectors(const View& view, Tile tile)
        : m_isPerspective(view.perspective), m_back(-Vec3<float>(view.forward)), m_rays(view), m_tile(tile) {
        if (!m_isPerspective) return;
        for (std::size_t i = 0; i < kRowPixels; i += hn::Lanes(F()))
            store(scaled(all(m_rays.right), along(VectorPlace(i).column(), 0)), m_across, i);
    }
    void beginRow(int y) {
        if (!m_isPerspective) return;
        for (std::size_t i = 0; i < kBlockPixels; i += hn::Lanes(F())) {
            const Floats3 down = scaled(all(m_rays.up), along(VectorPlace(std::size_t(y) * kRowPixels + i).row(), 1));
            store(down - all(m_rays.forward), m_down, i);
        }
    }
    // For vector i of the row, in the lanes `wanted`; arbitrary numbers in the others.
    template <class A>
    HWY_INLINE Floats3 at(std::size_t i, Mask wanted) const {
        if (!m_isPerspective) return all(m_back);
        return A::unit(load(m_down, i % kBlockPixels) - load(m_across, i), wanted);
    }

private:
    HWY_INLINE Floats along(Ints inTile, int part) const {
        const Floats pixel = hn::ConvertTo(F(), hn::Add(inTile, hn::Set(I(), m_tile.min[part])));
        return hn::Mul(hn::Add(pixel, all(m_rays.first[part])), all(m_rays.step[part]));
    }
    bool m_isPerspective;
    Vec3<float> m_back;  // opposite to the direction of an orthographic view
    PixelRays<float> m_rays;
    Tile m_tile;
    Row3 m_across, m_down;  // at the pixels of a row, and of one of its blocks
};

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
