#include "app/inspector/fragments_section.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <utility>

#include "app/look/accessible.h"
#include "app/look/number_format.h"
#include "app/look/text.h"
#include "app/widgets/follow_theme.h"
#include "pipeline/buffers/palette.h"

namespace app {

using pipeline::CulledReport;
using pipeline::FragmentReport;
using pipeline::FragmentVerdict;

namespace {

QColor culledColor(char letter) {
    // The stops stand in the order kept, back-facing, degenerate, outside, clipped, wholly transparent.
    const auto stops = paletteStops(pipeline::Palette::Verdict);
    const std::size_t i = letter == 'B'   ? 1
                          : letter == 'D' ? 2
                          : letter == 'O' ? 3
                          : letter == 'C' ? 4
                          : letter == 'T' ? 5
                                          : 0;
    return {stops[i].r, stops[i].g, stops[i].b};
}

void paintMark(QPainter& painter, FragmentVerdict verdict, QPointF centre) {
    const ThemeColors& c = Theme::current().colors();
    painter.setBrush(Qt::NoBrush);
    switch (verdict) {
        case FragmentVerdict::WonStays:
        case FragmentVerdict::PaintedLast:
            painter.setPen(Qt::NoPen);
            painter.setBrush(c.run);
            painter.drawEllipse(centre, 4.5, 4.5);
            break;
        case FragmentVerdict::Overwritten:
        case FragmentVerdict::PaintedOver:
            painter.setPen(QPen(c.reused, 1.6));
            painter.drawEllipse(centre, 3.7, 3.7);
            break;
        case FragmentVerdict::NotNearer:
            painter.setPen(QPen(c.leftOut, 2));
            painter.drawLine(centre - QPointF(4, 0), centre + QPointF(4, 0));
            break;
        case FragmentVerdict::NotYet:
            painter.setPen(Qt::NoPen);
            painter.setBrush(c.text3);
            painter.drawEllipse(centre, 1.6, 1.6);
            break;
    }
}

}  // namespace

FragmentsSection::FragmentsSection(QWidget* parent) : QWidget(parent) {
    setAccessibleRole(*this, QAccessible::List);
    setAccessibleName(tr("Fragments"));
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::PointingHandCursor);
    setToolTip(tr("A click on a row marks its polygon in every view"));
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    setSizePolicy(policy);
    followTheme(this, [this] {
        updateGeometry();
        update();
    });
}

void FragmentsSection::show(const pipeline::Frame& frame, const pipeline::PixelReport& report) {
    m_isDrawn = frame.until() >= pipeline::StageId::ZBuffer;
    m_fragments = report.fragments;
    m_culled = report.culled;
    m_current = std::clamp(m_current, 0, std::max(0, int(m_fragments.size() + m_culled.size()) - 1));
    QStringList lines;
    for (const FragmentReport& f : m_fragments)
        lines << tr("polygon %1, %2, %3")
                     .arg(f.polygon)
                     .arg(toQString(comparisonText(f, chosenNumbers()).whole()), toQString(name(f.verdict)));
    for (const CulledReport& culled : m_culled)
        lines << tr("polygon %1, %2").arg(culled.polygon).arg(toQString(culled.reason));
    setAccessibleDescription(lines.join("; "));
    updateGeometry();
    update();
}

QString FragmentsSection::sentence() const {
    if (!m_isDrawn) return toQString(name(FragmentVerdict::NotYet));
    QString text = toQString(pipeline::fragmentCounts(m_fragments));
    if (!m_culled.empty()) text += tr("; %1 culled").arg(m_culled.size());
    return text;
}

int FragmentsSection::rowHeight() const { return Theme::current().px(24); }

FragmentsSection::Widths FragmentsSection::widths() const {
    const Theme& theme = Theme::current();
    const QFontMetrics words(theme.text(12)), digits(theme.mono(12));
    Widths w{0, 0, 0, 0, true};
    int verdict = 0;
    for (const FragmentReport& f : m_fragments) {
        const pipeline::ComparisonText c = comparisonText(f, chosenNumbers());
        w.polygon = std::max(w.polygon, words.horizontalAdvance(tr("polygon %1").arg(f.polygon)));
        w.fresh = std::max(w.fresh, digits.horizontalAdvance(toQString(c.depth)));
        w.relation = std::max(w.relation, digits.horizontalAdvance(toQString(c.relation)));
        w.stored = std::max(w.stored, digits.horizontalAdvance(toQString(c.stored)));
        verdict = std::max(verdict, words.horizontalAdvance(toQString(name(f.verdict))));
    }
    const int gap = theme.px(8);
    w.fitsVerdict = w.polygon + w.fresh + w.relation + w.stored + verdict + 5 * gap + theme.px(18) <= width();
    return w;
}

int FragmentsSection::culledHeight(const CulledReport& culled) const {
    const QFontMetrics words(Theme::current().text(12));
    const QRect area(0, 0, width() - Theme::current().px(28), 1000);
    const QString text = tr("polygon %1: %2").arg(culled.polygon).arg(toQString(culled.reason));
    return std::max(rowHeight(), words.boundingRect(area, Qt::TextWordWrap, text).height() + Theme::current().px(6));
}

QSize FragmentsSection::sizeHint() const {
    int height = Theme::current().px(4);
    height += int(m_fragments.size()) * rowHeight() * (widths().fitsVerdict ? 1 : 2);
    for (const CulledReport& culled : m_culled) height += culledHeight(culled);
    return {Theme::current().px(320), std::max(height, rowHeight())};
}

void FragmentsSection::resizeEvent(QResizeEvent*) { updateGeometry(); }

// Below the words: those of the selected polygon, and a ring around the one that the keys are at.
void FragmentsSection::paintRows(QPainter& painter) const {
    const ThemeColors& c = Theme::current().colors();
    const auto all = rows();
    for (int i = 0; i < int(all.size()); ++i) {
        const QRect row = all[std::size_t(i)];
        if (m_selected && polygonOf(i) == *m_selected) painter.fillRect(row, c.tint);
        if (!hasFocus() || i != m_current) continue;
        painter.setPen(QPen(c.focus, 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(row.adjusted(1, 1, -1, -1), 3, 3);
    }
}

void FragmentsSection::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::current();
    const ThemeColors& c = theme.colors();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QFont words = theme.text(12), digits = theme.mono(12);
    const Widths w = widths();
    const int gap = theme.px(8), line = rowHeight();
    paintRows(painter);
    int y = 0;
    for (const FragmentReport& f : m_fragments) {
        const pipeline::ComparisonText comparison = comparisonText(f, chosenNumbers());
        const bool stays = f.verdict == FragmentVerdict::WonStays;
        int x = 0;
        const auto write = [&](const QFont& font, int width, Qt::Alignment alignment, const QString& text) {
            painter.setFont(font);
            painter.setPen(!won(f.verdict) ? c.text2 : c.text);
            painter.drawText(QRect(x, y, width, line), Qt::AlignVCenter | alignment, text);
            x += width + gap;
        };
        write(words, w.polygon, Qt::AlignLeft, tr("polygon %1").arg(f.polygon));
        write(digits, w.fresh, Qt::AlignRight, toQString(comparison.depth));
        write(digits, w.relation, Qt::AlignHCenter, toQString(comparison.relation));
        write(digits, w.stored, Qt::AlignRight, toQString(comparison.stored));
        if (!w.fitsVerdict) {
            y += line;
            x = 0;
        }
        paintMark(painter, f.verdict, QPointF(x + theme.px(7), y + line / 2.0));
        x += theme.px(18);
        write(theme.text(12, stays ? 600 : 400), width() - x, Qt::AlignLeft, toQString(name(f.verdict)));
        y += line;
    }
    for (const CulledReport& culled : m_culled) {
        const int height = culledHeight(culled), side = theme.px(18);
        const QRect letter(0, y + (line - side) / 2, side, side);
        painter.setPen(Qt::NoPen);
        painter.setBrush(culledColor(culled.letter));
        painter.drawRoundedRect(letter, 3, 3);
        painter.setFont(theme.text(12, 600));
        painter.setPen(Qt::black);
        painter.drawText(letter, Qt::AlignCenter, QString(QChar(culled.letter)));
        painter.setFont(words);
        painter.setPen(c.text2);
        painter.drawText(QRect(theme.px(28), y + theme.px(3), width() - theme.px(28), height), Qt::TextWordWrap,
                         tr("polygon %1: %2").arg(culled.polygon).arg(toQString(culled.reason)));
        y += height;
    }
    if (m_fragments.empty() && m_culled.empty()) {
        painter.setFont(words);
        painter.setPen(c.text2);
        painter.drawText(rect(), Qt::AlignVCenter | Qt::AlignLeft,
                         m_isDrawn ? tr("No polygon covers this pixel.") : tr("The polygons are not drawn yet."));
    }
}

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
