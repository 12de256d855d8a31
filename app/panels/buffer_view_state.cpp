// How a BufferView looks at its buffer, as a file has it.
#include <algorithm>
#include <cmath>

#include "app/core/text.h"
#include "app/panels/buffer_canvas.h"
#include "app/panels/buffer_compare.h"
#include "app/panels/buffer_header.h"
#include "app/panels/buffer_view.h"
#include "app/panels/condition_bar.h"
#include "app/panels/loupe.h"
#include "app/panels/shadow_overlay.h"

namespace app {

using pipeline::BufferId;

std::optional<pipeline::PaletteRange>& BufferView::keptRange() {
    return m_compare->showsDifference() ? m_compare->range() : kept().range;
}

void BufferView::setRange(pipeline::PaletteRange range) {
    keptRange() = range;
    refresh();
}

void BufferView::autofit(bool keep) {
    keptRange().reset();
    m_fitsOnce = !keep;
    refresh();
}

void BufferView::setLogCounts(bool logarithmic) {
    kept().logCounts = logarithmic;
    refresh();
}

lessons::BufferShown BufferView::state() const {
    lessons::BufferShown state{m_name.text(), channel()};
    const auto kept = m_kept.find(m_name.text());
    // Where all values are one, as where nothing is seen, there is no range to keep.
    const auto range = kept != m_kept.end() ? kept->second.range : std::nullopt;
    if (range && range->first != range->last && std::isfinite(range->first) && std::isfinite(range->last))
        state.range = {double(range->first), double(range->last)};
    if (kept != m_kept.end()) state.logCounts = kept->second.logCounts;
    state.flipped = m_canvas->isFlipped();
    if (m_regionShown) {
        const glm::ivec2 first = m_regionShown->first(), last = m_regionShown->last();
        state.region = {first.x, first.y, last.x, last.y};
    }
    state.overlays.clear();  // also of those that are on where nothing else is said
    for (const OverlayInfo& overlay : overlayTable())
        if (m_overlays[index(overlay.id)]) state.overlays.emplace_back(keyOf(overlay.id));
    if (const auto light = m_shadows->light())
        state.overlays.push_back(pipeline::BufferName{BufferId::ShadowVerdict, int(*light)}.text());
    if (!m_condition->isHidden()) state.overlays.push_back(pipeline::BufferName{BufferId::Condition}.text());
    state.zoom = m_canvas->part();
    state.compared = m_compare->state();
    return state;
}

pipeline::Errors BufferView::lookAt(const lessons::BufferShown& state) {
    pipeline::Errors errors;
    const auto name = pipeline::findAnyBuffer(state.buffer);
    if (!name) return {{{}, "there is no buffer \"" + state.buffer + '"'}};
    m_overlays.reset();
    std::optional<std::size_t> verdictsOf;
    bool asks = name->id == BufferId::Condition || name->id == BufferId::Expression;
    for (const std::string& key : state.overlays) {
        if (const auto derived = pipeline::findDerived(key)) {
            if (derived->id == BufferId::ShadowVerdict) verdictsOf = std::size_t(derived->light);
            asks = asks || derived->id == BufferId::Condition;
            continue;
        }
        const auto row = std::ranges::find(overlayTable(), key, [](const OverlayInfo& o) { return keyOf(o.id); });
        if (row != overlayTable().end())
            m_overlays.set(index(row->id));
        else
            errors.push_back({{}, "there is no overlay \"" + key + '"'});
    }
    m_shadows->setLight(verdictsOf);
    asks ? m_condition->reveal() : m_condition->close();
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
    const pipeline::Errors compared = m_compare->lookAt(state.compared);
    errors.insert(errors.end(), compared.begin(), compared.end());
    want();
    m_fitsPicture = !state.zoom;
    refresh();
    m_canvas->showPart(state.zoom);
    return errors;
}

// A state is looked at before its scene's frame is there: what fits is known with that frame.
void BufferView::showContent() {
    m_canvas->setContent(m_shown->content);
    if (m_fitsPicture && m_canvas->look().fits) m_canvas->fit();
    if (m_frame->sharedScene() == m_document.sharedScene()) m_fitsPicture = false;
    m_header->setZoom(m_canvas->zoom());
}

}  // namespace app
