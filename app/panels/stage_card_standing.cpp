// A StageCard while another renderer is compared: how its stage stands.
#include <QPainter>

#include "app/core/text.h"
#include "app/panels/follow_theme.h"
#include "app/panels/stage_card.h"
#include "app/panels/standing_row.h"

namespace app {

using pipeline::foreign::Standing;

void StageCard::setStanding(std::optional<Standing> standing, const QString& finding) {
    if (!standing && !m_standing) return;
    m_standing = standing, m_finding = finding;
    const QString word = standing ? toQString(words(*standing)) : app::word(m_status.state);
    setAccessibleName(QStringLiteral("%1: %2. %3").arg(text(), word, standing ? finding : m_status.reason));
    setToolTip(standing ? QStringLiteral("%1: %2<br>%3").arg(text(), word, finding.toHtmlEscaped()) : m_status.tooltip);
    update();
}

// The mark at the right, and the word before it.
void StageCard::paintStanding(QPainter& painter, const Head& head) const {
    const Theme& theme = Theme::current();
    const int side = theme.px(15), gap = theme.px(6);
    QRect line = head.line;
    app::paintStanding(painter, QRectF(line.right() - side, line.center().y() - side / 2.0, side, side), *m_standing);
    line.setLeft(head.title.right() + gap);
    painter.setFont(theme.text(12, 500));
    painter.setPen(standingColor(*m_standing));
    painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter, head.state);
}

// Compact, the word; else what was found.
void StageCard::paintFinding(QPainter& painter, const QRect& line) const {
    const Theme& theme = Theme::current();
    const bool saysWord = m_compact || m_finding.isEmpty();
    painter.setFont(theme.text(12, saysWord ? 500 : 400));
    painter.setPen(saysWord ? standingColor(*m_standing) : theme.colors().text2);
    const QString text = saysWord ? toQString(words(*m_standing)) : m_finding;
    painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(text, Qt::ElideRight, line.width()));
}

}  // namespace app
