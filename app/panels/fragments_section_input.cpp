// The mouse and the keys of a FragmentsSection.
#include <QKeyEvent>
#include <QMouseEvent>
#include <algorithm>
#include <utility>

#include "app/panels/fragments_section.h"

namespace app {

std::vector<QRect> FragmentsSection::rows() const {
    std::vector<QRect> rows;
    int y = 0;
    const auto add = [&](int height) { rows.emplace_back(0, std::exchange(y, y + height), width(), height); };
    const int height = rowHeight() * (widths().fitsVerdict ? 1 : 2);
    for (std::size_t i = 0; i < m_fragments.size(); ++i) add(height);
    for (const pipeline::CulledReport& culled : m_culled) add(culledHeight(culled));
    return rows;
}

std::uint32_t FragmentsSection::polygonOf(int row) const {
    const auto i = std::size_t(row);
    return std::uint32_t(i < m_fragments.size() ? m_fragments[i].polygon : m_culled[i - m_fragments.size()].polygon);
}

void FragmentsSection::setSelected(std::optional<std::uint32_t> polygon) {
    m_selected = polygon;
    update();
}

void FragmentsSection::mouseReleaseEvent(QMouseEvent* event) {
    const auto all = rows();
    const auto hit =
        std::ranges::find_if(all, [&](const QRect& row) { return row.contains(event->position().toPoint()); });
    if (hit == all.end()) return;
    m_current = int(hit - all.begin());
    emit polygonAsked(polygonOf(m_current));
}

void FragmentsSection::keyPressEvent(QKeyEvent* event) {
    const int count = int(m_fragments.size() + m_culled.size());
    const int step = event->key() == Qt::Key_Down ? 1 : event->key() == Qt::Key_Up ? -1 : 0;
    const bool enters = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (count == 0 || (step == 0 && !enters)) return QWidget::keyPressEvent(event);
    m_current = std::clamp(m_current + step, 0, count - 1);
    if (enters) emit polygonAsked(polygonOf(m_current));
    update();
}

void FragmentsSection::focusInEvent(QFocusEvent*) { update(); }
void FragmentsSection::focusOutEvent(QFocusEvent*) { update(); }

}  // namespace app
