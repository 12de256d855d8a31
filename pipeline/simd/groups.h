// Included once for each instruction set, like lanes.h.
#if defined(SHADESCOPE_GROUPS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHADESCOPE_GROUPS_H
#undef SHADESCOPE_GROUPS_H
#else
#define SHADESCOPE_GROUPS_H
#endif

#include <bit>
#include <vector>

#include "pipeline/simd/surfaces.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {

// Groups the pixels of a row of blocks by object, if objects have to be told apart.
class Groups {
public:
    void find(const SurfaceRow& row, bool byObject) {
        m_count = 0, m_blocks = 0;
        if (!byObject) return takeAll(row);
        for (std::size_t i = 0; i < kRowPixels; i += hn::Lanes(F())) {
            std::uint32_t left = row.seen[i / hn::Lanes(F())];
            if (left == 0) continue;
            m_blocks |= 1U << i / kBlockPixels;
            const std::int32_t* const objects = row.object + i;
            const Ints object = hn::Load(I(), objects);
            while (left != 0) {
                const std::int32_t one = objects[std::countr_zero(left)];
                const std::uint32_t mine = left & bitsOf(asFloats(hn::Eq(object, hn::Set(I(), one))));
                of(std::size_t(one)).add(i, mine);
                left &= ~mine;
            }
        }
    }
    std::span<const Group> all() const { return {m_groups.data(), m_count}; }
    bool areOne() const { return m_count == 1; }
    std::uint32_t blocks() const { return m_blocks; }  // bit mask of the blocks in which something was drawn

private:
    // Without a branch: a CPU cannot predict where the surfaces of a row end.
    void takeAll(const SurfaceRow& row) {
        Group& all = of(0);
        std::size_t count = 0;
        for (std::size_t i = 0; i < kRowPixels; i += hn::Lanes(F())) {
            const std::uint32_t pixels = row.seen[i / hn::Lanes(F())];
            const bool isSeen = pixels != 0;
            all.at[count] = i, all.bits[count] = pixels, count += isSeen;
            m_blocks |= std::uint32_t(isSeen) << i / kBlockPixels;
        }
        all.count = count, m_count = count > 0;
    }
    Group& of(std::size_t object) {
        for (std::size_t n = 0; n < m_count; ++n)
            if (m_groups[n].object == object) return m_groups[n];
        if (m_count == m_groups.size()) m_groups.emplace_back();
        Group& added = m_groups[m_count++];
        added.object = object, added.count = 0;
        return added;
    }
    std::vector<Group> m_groups;  // keeps its capacity from row to row
    std::size_t m_count = 0;
    std::uint32_t m_blocks = 0;
};

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
