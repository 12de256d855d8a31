#include "app/panels/legend_bar.h"

#include <QFontMetrics>
#include <QPainter>

#include "app/panels/follow_theme.h"

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

void LegendBar::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::current();
    QPainter painter(this);
    const QFontMetrics metrics(font());
    const int side = theme.px(12), gap = theme.px(6), space = theme.px(14);
    int x = 0;
    for (const LegendEntry& entry : m_entries) {
        const int needed = side + gap + metrics.horizontalAdvance(entry.text);
        if (x + needed > width()) {
            painter.setPen(theme.colors().text3);
            painter.drawText(QRect(x, 0, width() - x, height()), Qt::AlignVCenter | Qt::AlignLeft, "…");
            break;
        }
        const QRect swatch(x, (height() - side) / 2, side, side);
        painter.setPen(theme.colors().outline);
        painter.setBrush(entry.color);
        painter.drawRect(swatch);
        if (entry.hatch != Qt::NoBrush) painter.fillRect(swatch, QBrush(QColor(0, 0, 0, 150), entry.hatch));
        painter.setPen(theme.colors().text2);
        painter.drawText(QRect(x + side + gap, 0, needed, height()), Qt::AlignVCenter | Qt::AlignLeft, entry.text);
        x += needed + space;
    }
}

}  // namespace app
