#include "app/buffer_view/buffer_range.h"

#include <QKeyEvent>
#include <cmath>
#include <utility>

#include "app/buffer_view/buffer_channels.h"
#include "app/buffer_view/buffer_view.h"
#include "app/canvas/range_bar.h"
#include "app/compare/buffer_compare.h"

namespace app {

RangeChoice::RangeChoice(BufferView& view, BufferCompare& compare, const ChannelChoice& channel)
    : BufferFeature(view), m_compare(compare), m_foot(new RangeBar(&view)) {
    m_foot->hide();
    connect(m_foot, &RangeBar::rangeChosen, this, &RangeChoice::set);
    connect(m_foot, &RangeBar::autofit, this, &RangeChoice::fit);
    connect(m_foot, &RangeBar::logarithmicChosen, this, &RangeChoice::setLogCounts);
    connect(&channel, &ChannelChoice::changed, this, [this] { kept().range.reset(); });  // it was of other values
    connect(&view.document(), &Document::sceneOpened, this, [this] { m_kept.clear(); });
}

RangeChoice::Kept& RangeChoice::kept() { return m_kept[view().buffer().text()]; }

std::optional<pipeline::PaletteRange>& RangeChoice::keptRange() {
    return m_compare.showsDifference() ? m_compare.difference().range() : kept().range;
}

void RangeChoice::set(pipeline::PaletteRange range) {
    keptRange() = range;
    view().refresh();
}

void RangeChoice::fit(bool keep) {
    keptRange().reset();
    m_fitsOnce = !keep;
    view().refresh();
}

void RangeChoice::setLogCounts(bool logarithmic) {
    kept().logCounts = logarithmic;
    view().refresh();
}

bool RangeChoice::press(const QKeyEvent& key) {
    const bool shift = key.modifiers() & Qt::ShiftModifier;
    if (key.key() == Qt::Key_N) return fit(shift), true;
    if (key.key() == Qt::Key_L && shift) return setLogCounts(!kept().logCounts), true;
    return false;
}

void RangeChoice::addTo(ShowRequest& request) { request.range = kept().range; }

void RangeChoice::show() {
    const ShownBuffer& shown = *view().shown();
    m_foot->show(shown, !keptRange(), kept().logCounts);
    if (view().isCurrent() && !m_compare.difference().showing().busy() && std::exchange(m_fitsOnce, false))
        set(shown.look.range);
}

void RangeChoice::write(lessons::BufferShown& state) const {
    const auto found = m_kept.find(view().buffer().text());
    if (found == m_kept.end()) return;
    // If all values are equal, as where nothing is seen, there is no range to keep.
    const auto& range = found->second.range;
    if (range && range->first != range->last && std::isfinite(range->first) && std::isfinite(range->last))
        state.range = {double(range->first), double(range->last)};
    state.logCounts = found->second.logCounts;
}

pipeline::Errors RangeChoice::read(const lessons::BufferShown& state) {
    kept().range =
        state.range ? std::optional(pipeline::PaletteRange{(*state.range)[0], (*state.range)[1]}) : std::nullopt;
    kept().logCounts = state.logCounts;
    return {};
}

}  // namespace app
