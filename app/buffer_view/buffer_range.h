#pragma once
#include <map>
#include <string>

#include "app/buffer_view/buffer_feature.h"

namespace app {

class BufferCompare;
class ChannelChoice;
class RangeBar;

// The range of values that the palette spans: the user's, or one that fits every frame. Kept for each buffer. The range of
// a difference is the comparison's.
class RangeChoice : public BufferFeature {
public:
    RangeChoice(BufferView& view, BufferCompare& compare, const ChannelChoice& channel);

    RangeBar& foot() { return *m_foot; }
    void set(pipeline::PaletteRange range);
    void fit(bool keep);  // keep: to every frame from now on
    void setLogCounts(bool logarithmic);

    bool press(const QKeyEvent& key) override;
    void addTo(ShowRequest& request) override;
    void show() override;
    void write(lessons::BufferShown& state) const override;
    pipeline::Errors read(const lessons::BufferShown& state) override;

private:
    struct Kept {
        std::optional<pipeline::PaletteRange> range;  // nothing: fits every frame
        bool logCounts = true;                        // the axis of the histogram
    };
    Kept& kept();
    std::optional<pipeline::PaletteRange>& keptRange();  // of the buffer on show, or of the difference

    BufferCompare& m_compare;
    RangeBar* m_foot;
    std::map<std::string, Kept> m_kept;  // by the buffer's name
    bool m_fitsOnce = false;             // keeps the range that fits the next picture
};

}  // namespace app
