#include "app/widgets/standing_row.h"

#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>

#include "app/look/text.h"
#include "app/widgets/follow_theme.h"

namespace app {

using pipeline::foreign::Standing;

QColor standingColor(Standing standing) {
    const ThemeColors& c = Theme::current().colors();
    switch (standing) {
        case Standing::Agrees: return c.run;
        case Standing::WrongHere: return c.failed;
        case Standing::GivenInput:
        case Standing::CannotTell: return c.warn;
        case Standing::NoFile: break;
    }
    return c.leftOut;
}

void paintStanding(QPainter& painter, const QRectF& box, Standing standing) {
    const QColor color = standingColor(standing);
    const double r = box.width() / 2, line = box.width() / 9;
    const QPointF c = box.center();
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(color, line, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    const auto at = [&](double x, double y) { return c + QPointF(x * r, y * r); };
    switch (standing) {
        case Standing::Agrees:
            painter.drawEllipse(c, r - line / 2, r - line / 2);
            painter.drawPolyline(QPolygonF{at(-0.45, 0.02), at(-0.1, 0.38), at(0.48, -0.34)});
            break;
        case Standing::WrongHere:
            painter.setPen(Qt::NoPen);
            painter.setBrush(color);
            painter.drawRoundedRect(box, r / 4, r / 4);
            painter.setPen(QPen(Theme::current().colors().surface, 1.4 * line, Qt::SolidLine, Qt::RoundCap));
            painter.drawLine(at(-0.42, -0.42), at(0.42, 0.42));
            painter.drawLine(at(-0.42, 0.42), at(0.42, -0.42));
            break;
        case Standing::GivenInput:
            painter.drawPolygon(QPolygonF{at(0.15, -0.95), at(-0.6, 0.15), at(-0.05, 0.15), at(-0.2, 0.95),
                                          at(0.6, -0.2), at(0.05, -0.2)});
            break;
        case Standing::NoFile: painter.drawLine(at(-0.7, 0), at(0.7, 0)); break;
        case Standing::CannotTell: {
            QPen dashed(color, line);
            dashed.setDashPattern({2, 2});
            painter.setPen(dashed);
            painter.drawEllipse(c, r - line / 2, r - line / 2);
            QFont font = Theme::current().text(13, 700);
            font.setPixelSize(int(1.3 * r));
            painter.setFont(font);
            painter.setPen(color);
            painter.drawText(box, Qt::AlignCenter, QStringLiteral("?"));
            break;
        }
    }
    painter.restore();
}

StandingRow::StandingRow(pipeline::StageId stage, QWidget* parent) : QAbstractButton(parent), m_stage(stage) {
    setObjectName(QStringLiteral("standing:") + toQString(stageInfo(stage).name));
    setText(toQString(stageInfo(stage).label));
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_Hover);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    followTheme(this, [this] { updateGeometry(), update(); });
}

void StandingRow::show(Standing standing, const QString& line, bool isFirst) {
    m_standing = standing, m_line = line, m_isFirst = isFirst;
    const QString word = toQString(words(standing));
    setAccessibleName(QStringLiteral("%1 %2: %3").arg(index(m_stage) + 1).arg(text(), word));
    setAccessibleDescription(line);
    setToolTip(line.toHtmlEscaped());
    updateGeometry();
    update();
}

void StandingRow::setOnShow(bool onShow) {
    if (m_onShow == onShow) return;
    m_onShow = onShow;
    update();
}

QSize StandingRow::sizeHint() const {
    const int row = QFontMetrics(Theme::current().text(13)).height() + Theme::current().px(6);
    const int below = m_line.isEmpty() ? 0 : QFontMetrics(Theme::current().text(12)).height();
    return {Theme::current().px(240), row + below};
}
QSize StandingRow::minimumSizeHint() const { return {Theme::current().px(120), sizeHint().height()}; }

void StandingRow::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::current();
    const ThemeColors& c = theme.colors();
    QPainter painter(this);
    if (m_onShow || underMouse()) painter.fillRect(rect(), m_onShow ? c.tint : c.hover);
    if (m_isFirst) painter.fillRect(0, 0, theme.px(3), height(), c.failed);
    const int margin = theme.px(12), side = theme.px(15), gap = theme.px(8);
    const int row = QFontMetrics(theme.text(13)).height() + theme.px(6);
    paintStanding(painter, QRectF(margin, (row - side) / 2.0, side, side), m_standing);
    QRect line(margin + side + gap, 0, width() - 2 * margin - side - gap, row);
    painter.setFont(theme.text(13));
    painter.setPen(c.text2);
    const QString number = QString::number(index(m_stage) + 1);
    painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter, number);
    line.setLeft(line.left() + painter.fontMetrics().horizontalAdvance(number) + gap);
    const QString word = toQString(words(m_standing));
    const QFont wordFont = theme.text(12, 500), name = theme.text(13, m_isFirst || m_onShow ? 600 : 400);
    const int wordWidth = QFontMetrics(wordFont).horizontalAdvance(word);
    painter.setPen(c.text);
    painter.setFont(name);
    const int nameRoom = line.width() - wordWidth - gap;
    painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter,
                     QFontMetrics(name).elidedText(text(), Qt::ElideRight, nameRoom));
    painter.setFont(wordFont);
    painter.setPen(m_standing == Standing::NoFile ? c.text2 : standingColor(m_standing));
    painter.drawText(line, Qt::AlignRight | Qt::AlignVCenter, word);
    if (!m_line.isEmpty()) {
        const QFont small = theme.text(12);
        painter.setFont(small);
        painter.setPen(c.text2);
        const QRect below(line.left(), row - theme.px(3), line.width(), QFontMetrics(small).height());
        painter.drawText(below, Qt::AlignLeft | Qt::AlignVCenter,
                         QFontMetrics(small).elidedText(m_line, Qt::ElideRight, below.width()));
    }
    if (hasFocus()) {
        painter.setPen(QPen(c.focus, 2));
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
}

void StandingRow::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) return click();
    QAbstractButton::keyPressEvent(event);
}

StandingMark::StandingMark(QWidget* parent) : QWidget(parent) {
    followTheme(this, [this] { setFixedSize(QSize(1, 1) * Theme::current().px(24)); });
}

void StandingMark::show(Standing standing) {
    m_standing = standing;
    update();
}

void StandingMark::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    paintStanding(painter, QRectF(rect()).adjusted(1, 1, -1, -1), m_standing);
}

}  // namespace app
