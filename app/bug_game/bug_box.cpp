#include "app/bug_game/bug_box.h"

#include <QPainter>

#include "app/look/text.h"
#include "app/widgets/follow_theme.h"
#include "app/widgets/standing_row.h"
#include "lessons/games/wrong_picture.h"

namespace app {

using pipeline::foreign::Standing;

BugBox::BugBox(int box, QWidget* parent) : QAbstractButton(parent), m_box(box) {
    setObjectName(QStringLiteral("bugBox:%1").arg(box));
    setText(toQString(lessons::boxLabel(box)));
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_Hover);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    followTheme(this, [this] { updateGeometry(), update(); });
    show(State::Open, 0, false);
}

QString BugBox::verdict() const {
    switch (m_state) {
        case State::Cleared: return tr("did what it should");
        case State::Wrong: return tr("wrong here");
        case State::Open: break;
    }
    if (m_isMarked) return tr("marked");
    return m_looks == 0 ? tr("not marked") : m_looks == 1 ? tr("1 look") : tr("%1 looks").arg(m_looks);
}

void BugBox::show(State state, int looks, bool isMarked) {
    m_state = state, m_looks = looks, m_isMarked = isMarked;
    setAccessibleName(QStringLiteral("%1 %2: %3").arg(m_box).arg(text(), verdict()));
    setToolTip(tr("Key %1 marks it").arg(m_box));
    update();
}

QSize BugBox::sizeHint() const { return {Theme::current().px(150), Theme::current().px(54)}; }
QSize BugBox::minimumSizeHint() const { return {Theme::current().px(92), sizeHint().height()}; }

void BugBox::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::current();
    const ThemeColors& c = theme.colors();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF box = QRectF(rect()).adjusted(1, 1, -1, -1);
    const QColor border = m_state == State::Wrong ? c.failed : m_isMarked ? c.accent : c.line;
    painter.setPen(QPen(border, m_isMarked || m_state == State::Wrong ? 2 : 1));
    painter.setBrush(m_isMarked ? c.tint : underMouse() ? c.hover : m_state == State::Cleared ? c.bg : c.surface);
    painter.drawRoundedRect(box, theme.px(6), theme.px(6));
    if (hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(c.focus, 2));
        painter.drawRoundedRect(box.adjusted(2, 2, -2, -2), theme.px(5), theme.px(5));
    }
    const int margin = theme.px(10), side = theme.px(14), gap = theme.px(6);
    QRect line(margin, theme.px(6), width() - 2 * margin, QFontMetrics(theme.text(13, 600)).height());
    if (m_state != State::Open) {
        paintStanding(painter, QRectF(line.right() - side, line.center().y() - side / 2.0, side, side),
                      m_state == State::Wrong ? Standing::WrongHere : Standing::Agrees);
        line.setRight(line.right() - side - gap);
    }
    painter.setFont(theme.text(13, 500));
    painter.setPen(c.text2);
    const QString number = QString::number(m_box);
    painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter, number);
    line.setLeft(line.left() + painter.fontMetrics().horizontalAdvance(number) + gap);
    painter.setFont(theme.text(13, 600));
    painter.setPen(m_state == State::Cleared ? c.text2 : c.text);
    painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(text(), Qt::ElideRight, line.width()));
    const QFont small = theme.text(12);
    const QRect below(margin, line.bottom() + theme.px(2), width() - 2 * margin, QFontMetrics(small).height());
    painter.setFont(small);
    painter.setPen(m_state == State::Wrong ? c.failed : c.text2);
    painter.drawText(below, Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(verdict(), Qt::ElideRight, below.width()));
}

}  // namespace app
