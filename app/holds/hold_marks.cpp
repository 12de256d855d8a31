#include "app/holds/hold_marks.h"

#include <QPainter>
#include <QPainterPath>

#include "app/look/theme.h"

namespace app {

namespace {

const ThemeColors& dark() { return Theme::colors(ThemeId::Dark); }
double thin() { return Theme::current().px(2); }

}  // namespace

HoldMarks::HoldMarks(QWidget* canvas) : QWidget(canvas) {
    setObjectName("holds");
    setAttribute(Qt::WA_TransparentForMouseEvents);
    hide();
}

void HoldMarks::show(HeldMarks marks) {
    m_marks = std::move(marks);
    update();
}

void HoldMarks::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    for (const HeldMarks::Lead& lead : m_marks.leads) paintLead(painter, lead);
    if (m_marks.ring)
        for (const auto& [color, width] : {std::pair(Qt::black, 2.5), std::pair(Qt::white, 1.25)}) {
            painter.setBrush(Qt::NoBrush);
            painter.setPen(QPen(color, width * thin()));
            painter.drawEllipse(*m_marks.ring, 5 * thin(), 5 * thin());
        }
    if (m_marks.vectors) paintVectors(painter, *m_marks.vectors);
    paintWords(painter);
}

void HoldMarks::line(QPainter& painter, QPointF a, QPointF b, const QColor& color, Qt::PenStyle style) const {
    painter.setPen(QPen(QColor(0, 0, 0, 170), 3 * thin(), Qt::SolidLine, Qt::RoundCap));
    if (style == Qt::SolidLine) painter.drawLine(a, b);
    painter.setPen(QPen(color, 1.5 * thin(), style, Qt::RoundCap));
    painter.drawLine(a, b);
}

void HoldMarks::paintLead(QPainter& painter, const HeldMarks::Lead& lead) const {
    using LeadKind = HeldMarks::Lead::Kind;
    if (lead.kind == LeadKind::Track) return line(painter, lead.from, lead.to, QColor(0x8A93A0));
    if (lead.kind == LeadKind::Lamp) return line(painter, lead.from, lead.to, dark().L, Qt::DotLine);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(Qt::white, thin(), Qt::DotLine));
    painter.drawEllipse(lead.to, 3 * thin(), 3 * thin());
    painter.drawLine(lead.from, lead.to);
}

void HoldMarks::paintVectors(QPainter& painter, const HeldMarks::Vectors& vectors) const {
    const QColor N = dark().N;
    painter.setPen(QPen(N, thin() / 2, Qt::DashLine));
    painter.setBrush(QColor(N.red(), N.green(), N.blue(), 45));
    painter.drawPolygon(vectors.horizon);
    painter.setBrush(Qt::NoBrush);
    line(painter, vectors.at, vectors.N, N);
    line(painter, vectors.at, vectors.L, dark().L, vectors.isLit ? Qt::SolidLine : Qt::DotLine);
    painter.setPen(QPen(Qt::white, thin()));
    painter.drawPolyline(vectors.arc);
    paintLetter(painter, vectors.at, vectors.N, QStringLiteral("N"), N);
    paintLetter(painter, vectors.at, vectors.L, QStringLiteral("L"), dark().L);
    if (!vectors.H) return;
    line(painter, vectors.at, *vectors.H, dark().H);
    // Its letter stands aside: H may lie on N.
    const QLineF along(vectors.at, *vectors.H);
    const QPointF aside = along.length() > 0 ? along.normalVector().unitVector().p2() - along.p1() : QPointF();
    paintLetter(painter, *vectors.H, *vectors.H + aside, QStringLiteral("H"), dark().H);
}

// Beyond the tip.
void HoldMarks::paintLetter(QPainter& painter, QPointF from, QPointF to, const QString& name,
                            const QColor& color) const {
    QFont font = Theme::current().formula(24);
    font.setBold(true), font.setItalic(true);
    QLineF away(from, to);
    away.setLength(away.length() + Theme::current().px(16));
    const QPointF base(-QFontMetricsF(font).horizontalAdvance(name) / 2, Theme::current().px(8));
    QPainterPath path;
    path.addText(away.p2() + base, font, name);
    painter.strokePath(path, QPen(Qt::black, 2 * thin()));
    painter.fillPath(path, color);
}

void HoldMarks::paintWords(QPainter& painter) const {
    const Theme& theme = Theme::current();
    const QRect room = rect().adjusted(theme.px(20), theme.px(14), -theme.px(20), -theme.px(14));
    const auto put = [&](const QString& text, int layout, const QColor& color) {
        if (text.isEmpty()) return;
        const QRect box = painter.boundingRect(room, layout, text);
        painter.setPen(Qt::NoPen);
        painter.setBrush(QColor(0, 0, 0, 150));
        const int x = theme.px(12), y = theme.px(4);
        painter.drawRoundedRect(box.adjusted(-x, -y, x, y), theme.px(8), theme.px(8));
        painter.setPen(color);
        painter.drawText(room, layout, text);
    };
    painter.setFont(theme.text(21, 600));
    put(m_marks.play, Qt::AlignTop | Qt::AlignHCenter | Qt::TextWordWrap, QColor(0xF2F4F7));
    painter.setFont(theme.mono(18));
    put(m_marks.shows, Qt::AlignBottom | Qt::AlignLeft | Qt::TextWordWrap, dark().L);
}

}  // namespace app
