#include "app/canvas/legend_bar.h"

#include <QFontMetrics>
#include <QPainter>
#include <algorithm>

#include "app/widgets/follow_theme.h"

namespace app {

LegendBar::LegendBar(QWidget* parent) : QWidget(parent) {
    followTheme(this, [this] {
        setFont(Theme::current().text(12));
        updateGeometry();
    });
}

QSize LegendBar::minimumSizeHint() const { return {80, Theme::current().px(20)}; }

void LegendBar::setEntries(std::vector<LegendEntry> entries) {
    m_entries = std::move(entries);
    QStringList texts;
    for (const LegendEntry& entry : m_entries) texts << entry.text;
    setToolTip(texts.join('\n'));
    setAccessibleName(tr("Legend"));
    setAccessibleDescription(texts.join("; "));
    update();
}

// From left to right, in further rows where there is height for them; what is left then is the tip's.
std::vector<QRect> LegendBar::places() const {
    const Theme& theme = Theme::current();
    const QFontMetrics metrics(font());
    const int line = theme.px(20), space = theme.px(14), most = std::max(1, height() / line);
    std::vector<QRect> places;
    int x = 0, row = 0;
    for (const LegendEntry& entry : m_entries) {
        const int needed = theme.px(18) + metrics.horizontalAdvance(entry.text);
        if (x > 0 && x + needed > width()) {
            if (++row == most) break;
            x = 0;
        }
        places.emplace_back(x, row * line, needed, line);
        x += needed + space;
    }
    const int top = (height() - (std::min(row, most - 1) + 1) * line) / 2;
    for (QRect& place : places) place.translate(0, top);
    return places;
}

void LegendBar::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::current();
    QPainter painter(this);
    const int side = theme.px(12), gap = theme.px(6);
    const std::vector<QRect> all = places();
    for (std::size_t i = 0; i < all.size(); ++i) {
        const QRect swatch(all[i].left(), all[i].top() + (all[i].height() - side) / 2, side, side);
        painter.setPen(theme.colors().outline);
        painter.setBrush(m_entries[i].color);
        painter.drawRect(swatch);
        if (m_entries[i].hatch != Qt::NoBrush)
            painter.fillRect(swatch, QBrush(QColor(0, 0, 0, 150), m_entries[i].hatch));
        painter.setPen(theme.colors().text2);
        painter.drawText(all[i].adjusted(side + gap, 0, 0, 0), Qt::AlignVCenter | Qt::AlignLeft, m_entries[i].text);
    }
    if (all.empty() || all.size() == m_entries.size()) return;
    painter.setPen(theme.colors().text3);
    painter.drawText(all.back().translated(all.back().width() + gap, 0), Qt::AlignVCenter | Qt::AlignLeft, "…");
}

}  // namespace app
