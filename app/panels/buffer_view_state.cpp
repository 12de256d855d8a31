// How a BufferView looks at its buffer, as a file has it.
#include <algorithm>

#include "app/core/text.h"
#include "app/panels/buffer_canvas.h"
#include "app/panels/buffer_view.h"
#include "app/panels/loupe.h"

namespace app {

void BufferView::setLogCounts(bool logarithmic) {
    kept().logCounts = logarithmic;
    refresh();
}

BufferShown BufferView::state() const {
    BufferShown state{m_name.text(), channel()};
    const auto kept = m_kept.find(m_name.text());
    if (kept != m_kept.end() && kept->second.range)
        state.range = {double(kept->second.range->first), double(kept->second.range->last)};
    if (kept != m_kept.end()) state.logCounts = kept->second.logCounts;
    state.flipped = m_canvas->isFlipped();
    if (m_regionShown) {
        const glm::ivec2 first = m_regionShown->first(), last = m_regionShown->last();
        state.region = {first.x, first.y, last.x, last.y};
    }
    for (const OverlayInfo& overlay : overlayTable())
        if (m_overlays[index(overlay.id)]) state.overlays.emplace_back(overlay.key);
    state.zoom = m_canvas->part();
    return state;
}

pipeline::Errors BufferView::lookAt(const BufferShown& state) {
    pipeline::Errors errors;
    const auto name = pipeline::findBuffer(state.buffer);
    if (!name) return {{{}, "there is no buffer \"" + state.buffer + '"'}};
    m_overlays.reset();
    for (const std::string& key : state.overlays) {
        const auto row =
            std::ranges::find(overlayTable(), key, [](const OverlayInfo& o) { return std::string(o.key); });
        if (row != overlayTable().end())
            m_overlays.set(index(row->id));
        else
            errors.push_back({{}, "there is no overlay \"" + key + '"'});
    }
    setBuffer(*name);
    setChannel(state.channel);
    kept().range =
        state.range ? std::optional(pipeline::PaletteRange{(*state.range)[0], (*state.range)[1]}) : std::nullopt;
    kept().logCounts = state.logCounts;
    setFlipped(state.flipped);
    setRegion(state.region ? std::optional(Region{{(*state.region)[0], (*state.region)[1]},
                                                  {(*state.region)[2], (*state.region)[3]}})
                           : std::nullopt);
    m_canvas->setShowEdges(m_overlays[index(OverlayId::Edges)]);
    setShowLoupe(m_loupe->isVisibleTo(m_canvas));  // the header tells whether there are overlays
    want();
    refresh();
    m_canvas->showPart(state.zoom);
    return errors;
}

}  // namespace app
