// How an AlgorithmView paints its lines.
#include <QPainter>
#include <algorithm>

#include "app/core/text.h"
#include "app/core/theme.h"
#include "app/panels/algorithm_view.h"
#include "app/panels/code_words.h"

namespace app {

using pipeline::AlgorithmRow;
using pipeline::LineStatus;

namespace {

bool isGrey(LineStatus status) {
    return status == LineStatus::NotTaken || status == LineStatus::LeftOut || status == LineStatus::Elsewhere;
}

}  // namespace

void AlgorithmView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Theme& theme = Theme::current();
    const Sheet sheet = layOut(width());
    for (const Placed& placed : sheet.placed) paintRow(painter, sheet, placed);
    painter.setFont(sheet.words);
    painter.setPen(theme.colors().text2);
    const auto say = [&](std::size_t count, const QString& where, int y) {
        if (count > 0)
            painter.drawText(QRect(sheet.numbers, y, width() - sheet.numbers, sheet.placed.front().line),
                             Qt::AlignVCenter, where.arg(count));
    };
    if (!sheet.placed.empty()) {
        say(sheet.above, tr("%1 lines above"), 0);
        say(sheet.below, tr("%1 lines below"), sheet.height - sheet.placed.front().line);
    }
    if (!sheet.loop.isEmpty()) paintLoop(painter, sheet);
    if (!hasFocus()) return;
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme.colors().focus, 2));
    painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), theme.px(4), theme.px(4));
}

// From the first value to the last, with a handle where it is.
void AlgorithmView::paintLoop(QPainter& painter, const Sheet& sheet) const {
    const Theme& theme = Theme::current();
    const ThemeColors& c = theme.colors();
    const auto& range = *innermostLoop(m_rows)->range;
    const QString name = toQString(range.name), first = QString::number(range.first),
                  last = QString::number(range.last);
    const int gap = theme.px(8);
    QRect bar = sheet.loop;
    painter.setFont(sheet.words);
    painter.setPen(c.text2);
    painter.drawText(bar, Qt::AlignLeft | Qt::AlignVCenter, name);
    bar.setLeft(bar.left() + painter.fontMetrics().horizontalAdvance(name) + gap);
    painter.setFont(sheet.code);
    painter.setPen(c.text);
    painter.drawText(bar, Qt::AlignLeft | Qt::AlignVCenter, first);
    painter.drawText(bar, Qt::AlignRight | Qt::AlignVCenter, last);
    bar.setLeft(bar.left() + painter.fontMetrics().horizontalAdvance(first) + gap);
    bar.setRight(bar.right() - painter.fontMetrics().horizontalAdvance(last) - gap);
    const double share = (double(range.at - range.first) + 0.5) / (double(range.last - range.first) + 1);
    const int thick = theme.px(5), x = bar.left() + int(share * bar.width());
    const QRect track(bar.left(), bar.center().y() - thick / 2, bar.width(), thick);
    painter.fillRect(track, c.hover);
    painter.fillRect(QRect(track.topLeft(), QSize(x - track.left(), thick)), c.accent);
    painter.fillRect(QRect(x - theme.px(2), track.top() - thick, theme.px(4), 3 * thick), c.accent);
}

void AlgorithmView::paintRow(QPainter& painter, const Sheet& sheet, const Placed& placed) const {
    const Theme& theme = Theme::current();
    const ThemeColors& c = theme.colors();
    const AlgorithmRow& row = m_rows[placed.row];
    const bool isNow = row.status == LineStatus::Now;
    if (isNow) {
        painter.fillRect(placed.rect, c.tint);
        painter.fillRect(QRect(placed.rect.topLeft(), QSize(theme.px(4), placed.rect.height())), c.accent);
    }
    if (row.status == LineStatus::LeftOut) painter.fillRect(placed.rect, QBrush(c.hatch, Qt::BDiagPattern));
    QRect line(placed.rect.topLeft(), QSize(placed.rect.width(), placed.line));
    painter.setFont(sheet.code);
    painter.setPen(isNow ? c.accent : c.text2);
    painter.drawText(QRect(0, line.y(), sheet.numbers - theme.px(8), line.height()), Qt::AlignRight | Qt::AlignVCenter,
                     QString::number(row.number));
    painter.setPen(isGrey(row.status) ? c.text3 : c.text);
    const int left = sheet.numbers + row.indent * sheet.indent;
    for (qsizetype i = 0; i < placed.code.size(); ++i) {
        int x = left + (i > 0 ? sheet.hanging() : 0);
        for (const auto& [part, isWord] : wordsOf(placed.code[i])) {
            painter.setFont(isWord ? bold(sheet.code) : sheet.code);
            const int room = width() - x;
            painter.drawText(QRect(x, line.y(), room, line.height()), Qt::AlignVCenter,
                             QFontMetrics(painter.font()).elidedText(part, Qt::ElideRight, room));
            x += QFontMetrics(painter.font()).horizontalAdvance(part);
        }
        line.translate(0, placed.line);
    }
    paintValues(painter, sheet, placed);
}

void AlgorithmView::paintValues(QPainter& painter, const Sheet& sheet, const Placed& placed) const {
    const Theme& theme = Theme::current();
    const ThemeColors& c = theme.colors();
    const AlgorithmRow& row = m_rows[placed.row];
    const bool isBranch = row.status == LineStatus::Now && row.taken, isNumbers = showsNumbers(row);
    const int edge = theme.px(8);
    const qsizetype codeLines = placed.code.size() - (placed.valuesBelow ? 0 : 1);
    QRect where(placed.rect.x(), placed.rect.y() + int(codeLines) * placed.line, placed.rect.width() - edge,
                placed.line);
    if (placed.valuesBelow) where.setLeft(sheet.valuesLeft(row));
    painter.setFont(isNumbers ? bold(sheet.code) : sheet.words);
    painter.setPen(isGrey(row.status) ? c.text3 : isNumbers ? c.text : c.text2);
    for (const QString& part : placed.values) {
        painter.drawText(where, (isBranch ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter,
                         painter.fontMetrics().elidedText(part, Qt::ElideRight, where.width()));
        where.translate(0, placed.line);
    }
    if (!isBranch) return;
    // Which way it goes, with a mark that does without colour: behind the comparison, or below it.
    if (!placed.wayBelow) where.translate(0, -placed.line);
    painter.setFont(sheet.words);
    painter.setPen(*row.taken ? c.run : c.text2);
    painter.drawText(where, (placed.wayBelow ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter, wayOf(row));
}

}  // namespace app
