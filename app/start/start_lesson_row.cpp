#include "app/start/start_lesson_row.h"

#include <QPainter>
#include <algorithm>

#include "app/look/theme.h"

namespace app {
namespace {

int leftOfName() { return Theme::current().px(38); }
int rowSide() { return Theme::current().px(11); }
QFont rowFont() { return Theme::current().text(13); }

QString spokenState(const StartLesson& lesson) {
    return lesson.isDone()    ? LessonRow::tr("done")
           : lesson.isBegun() ? LessonRow::tr("page %1 of %2").arg(lesson.page).arg(lesson.pages)
                              : LessonRow::tr("not begun");
}

}  // namespace

LessonRow::LessonRow(const StartLesson& lesson, int number, QWidget* parent)
    : StartButton(lesson.title, lesson.text, Frame::Flat, parent), m_lesson(lesson), m_number(number) {
    setObjectName(QStringLiteral("lesson:") + lesson.name);
    setAccessibleName(lesson.title + QStringLiteral(", ") + spokenState(lesson));
}

void LessonRow::setLit(bool isLit) {
    m_isLit = isLit;
    update();
}

QString LessonRow::atRight() const {
    if (m_isLit) return m_lesson.isBegun() ? tr("Go on") : tr("Begin");
    return m_lesson.isDone() || m_lesson.minutes == 0 ? QString() : tr("%1 min").arg(m_lesson.minutes);
}

int LessonRow::besideName() const {
    const QString right = atRight();
    const int gap = right.isEmpty() ? 0 : Theme::current().px(8);
    return leftOfName() + rowSide() + gap + QFontMetrics(Theme::current().text(12, 600)).horizontalAdvance(right);
}

int LessonRow::wantedHeight(int width) const {
    const QRect room(0, 0, std::max(1, width - besideName()), 1000);
    const int words = QFontMetrics(rowFont()).boundingRect(room, Qt::TextWordWrap, text()).height();
    return words + Theme::current().px(m_lesson.isBegun() ? 13 : 4);
}

void LessonRow::paintInside(QPainter& painter, const QRectF& box) const {
    const Theme& theme = Theme::current();
    const ThemeColors& c = theme.colors();
    if (m_isLit) painter.fillRect(box, underMouse() ? c.hover : c.tint);
    const QPointF mark(box.left() + rowSide() + theme.px(5), box.center().y());
    const double radius = theme.px(4.5);
    if (m_lesson.isDone()) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(c.run);
        painter.drawEllipse(mark, radius, radius);
    } else if (m_lesson.isBegun()) {
        painter.setPen(QPen(c.accent, std::max(1, theme.px(1.5))));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(mark, radius - 0.5, radius - 0.5);
        painter.setPen(Qt::NoPen);
        painter.setBrush(c.accent);
        painter.drawPie(QRectF(mark.x() - radius, mark.y() - radius, 2 * radius, 2 * radius), 90 * 16, 180 * 16);
    } else {
        painter.setFont(theme.mono(12));
        painter.setPen(c.text3);
        painter.drawText(QRectF(box.left() + rowSide(), box.top(), leftOfName(), box.height()),
                         Qt::AlignLeft | Qt::AlignVCenter, QString::number(m_number));
    }
    const QRectF name(box.left() + leftOfName(), box.top(), box.width() - besideName(),
                      box.height() - theme.px(m_lesson.isBegun() ? 8 : 0));  // above the bar
    painter.setFont(rowFont());
    painter.setPen(c.text);
    painter.drawText(name, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap, text());
    const QRectF right(box.left(), box.top(), box.width() - rowSide(), box.height());
    painter.setFont(theme.text(12, m_isLit ? 600 : 400));
    painter.setPen(m_isLit ? c.accent : c.text2);
    painter.drawText(right, Qt::AlignRight | Qt::AlignVCenter, atRight());
    painter.setPen(Qt::NoPen);
    if (m_lesson.isBegun()) {
        const double whole = box.width() - leftOfName() - rowSide();
        QRectF bar(name.left(), box.bottom() - theme.px(6), whole, theme.px(3));
        painter.setBrush(c.hover);
        painter.drawRoundedRect(bar, theme.px(1.5), theme.px(1.5));
        bar.setWidth(whole * m_lesson.page / m_lesson.pages);
        painter.setBrush(c.accent);
        painter.drawRoundedRect(bar, theme.px(1.5), theme.px(1.5));
    }
    painter.setPen(c.line);
    painter.drawLine(box.bottomLeft() - QPointF(0, 0.5), box.bottomRight() - QPointF(0, 0.5));
    if (y() == 0) painter.drawLine(box.topLeft() + QPointF(0, 0.5), box.topRight() + QPointF(0, 0.5));
}

}  // namespace app
