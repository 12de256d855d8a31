#include "app/panels/hold_grip.h"

#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

#include "app/core/hand.h"
#include "app/core/text.h"
#include "app/panels/follow_theme.h"

namespace app {

using Kind = pipeline::Hold::Kind;

HoldGrip::HoldGrip(Hand& hand, std::size_t hold, QWidget* canvas)
    : QWidget(canvas), m_hand(hand), m_hold(hold), m_words(new QLabel(canvas)) {
    speak(*this);
    setObjectName("holdGrip");
    setAccessibleName(toQString(hand.holds()[hold].name));
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::OpenHandCursor);
    setToolTip(tr("Drag it, or use the arrow keys. Shift takes large steps, Home puts it back."));
    m_words->setObjectName("holdWords");
    m_words->setAttribute(Qt::WA_TransparentForMouseEvents);
    m_words->setTextFormat(Qt::PlainText);
    connect(this, &QObject::destroyed, m_words, &QObject::deleteLater);
    followTheme(this, [this] {
        const Theme& theme = Theme::current();
        m_words->setFont(theme.mono(16));
        m_words->setStyleSheet(
            QStringLiteral("background: rgba(0,0,0,180); color: #F2F4F7; border-radius: %1px;").arg(theme.px(6)));
        m_words->setContentsMargins(theme.px(8), theme.px(1), theme.px(8), theme.px(1));
        setFixedSize(side(), side());
    });
}

int HoldGrip::side() { return std::max(44, Theme::current().px(44)); }

void HoldGrip::place(std::optional<QPointF> middle, bool isBehind, int top) {
    setVisible(middle.has_value());
    if (!middle) return;
    m_isBehind = isBehind;
    const QWidget& room = *parentWidget();
    const double half = side() / 2.0;
    const QPointF at(std::clamp(middle->x(), half, std::max(half, room.width() - half)),
                     std::clamp(middle->y(), half, std::max(half, room.height() - half)));
    move((at - QPointF(half, half)).toPoint());
    const QString words = m_hand.words(m_hold);
    setAccessibleDescription(words);
    m_words->setText(words);
    m_words->adjustSize();
    m_words->setVisible(!words.isEmpty());
    // Above it; beside it where that would lie on the play, or on its own track.
    const bool isBeside = m_hand.holds()[m_hold].kind == Kind::Number || at.y() - half - m_words->height() < top;
    QPointF corner(at.x() - m_words->width() / 2.0, at.y() - half - m_words->height() - 2);
    if (isBeside) corner = {at.x() + half + 2, at.y() - m_words->height() / 2.0};
    if (isBeside && corner.x() + m_words->width() > room.width()) corner.setX(at.x() - half - 2 - m_words->width());
    corner.setX(std::clamp(corner.x(), 2.0, std::max(2.0, room.width() - m_words->width() - 2.0)));
    m_words->move(corner.toPoint());
    m_words->raise();
    raise();
    sayValue(*this);
    update();
}

void HoldGrip::setDragged(bool dragged) { setCursor(dragged ? Qt::ClosedHandCursor : Qt::OpenHandCursor); }

SpokenSlider::Scale HoldGrip::spoken() const {
    const pipeline::Hold& hold = m_hand.holds()[m_hold];
    const double value = m_hand.value(m_hold);
    if (hold.kind == Kind::Number || hold.kind == Kind::Along || hold.kind == Kind::Rim)
        return {value, hold.low, hold.high, (hold.high - hold.low) / 100};
    return {value, value - 180, value + 180, 1};
}

// One step that way, as the arrow keys do it: a lamp or the eye has no single number.
void HoldGrip::slideTo(double value) {
    const double now = spoken().value;
    if (value != now) m_hand.nudge(m_hold, {value > now ? 1 : -1, 0}, false);
}

void HoldGrip::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return event->ignore();
    setFocus(Qt::MouseFocusReason);
    emit grabbed(mapTo(parentWidget(), event->position()));
}

void HoldGrip::mouseMoveEvent(QMouseEvent* event) {
    if (event->buttons() & Qt::LeftButton) emit dragged(mapTo(parentWidget(), event->position()), event->modifiers());
}

void HoldGrip::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) emit dropped();
}

void HoldGrip::keyPressEvent(QKeyEvent* event) {
    const bool isCoarse = event->modifiers() & Qt::ShiftModifier;
    if (event->modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) return QWidget::keyPressEvent(event);
    switch (event->key()) {
        case Qt::Key_Left: return m_hand.nudge(m_hold, {-1, 0}, isCoarse);
        case Qt::Key_Right: return m_hand.nudge(m_hold, {1, 0}, isCoarse);
        case Qt::Key_Up: return m_hand.nudge(m_hold, {0, -1}, isCoarse);
        case Qt::Key_Down: return m_hand.nudge(m_hold, {0, 1}, isCoarse);
        case Qt::Key_Home: return m_hand.restore(m_hold);
        case Qt::Key_Escape:
            if (m_hand.isDragging()) return m_hand.cancel();
            [[fallthrough]];
        default: QWidget::keyPressEvent(event);
    }
}

void HoldGrip::hideEvent(QHideEvent*) { m_words->hide(); }

// A lamp is a sun, hollow where it is behind; a number a rounded square on its track; all else a white disc.
void HoldGrip::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Kind kind = m_hand.holds()[m_hold].kind;
    const QPointF middle = QRectF(rect()).center();
    const double unit = side() / 44.0;
    const bool isLamp = kind == Kind::LampAtInfinity || kind == Kind::LampTop || kind == Kind::LampFoot;
    const QColor sun = Theme::colors(ThemeId::Dark).L, ink(0xF2F4F7), rim(0, 0, 0, 140);
    const double radius = (isLamp ? 12 : 14) * unit;
    if (isLamp) {
        QRadialGradient glow(middle, 22 * unit);
        glow.setColorAt(0.5, QColor(sun.red(), sun.green(), sun.blue(), 130));
        glow.setColorAt(1, Qt::transparent);
        painter.setPen(Qt::NoPen);
        painter.setBrush(glow);
        painter.drawEllipse(middle, 22 * unit, 22 * unit);
    }
    painter.setPen(QPen(rim, 3 * unit));
    painter.setBrush(m_isBehind || kind == Kind::LampFoot ? QBrush(Qt::black) : isLamp ? sun : ink);
    if (kind == Kind::Number)
        painter.drawRoundedRect(QRectF(middle - QPointF(radius, radius), middle + QPointF(radius, radius)), 8 * unit,
                                8 * unit);
    else
        painter.drawEllipse(middle, radius, radius);
    if (m_isBehind || kind == Kind::LampFoot) {
        painter.setPen(QPen(sun, 3 * unit));
        painter.drawEllipse(middle, radius - 2 * unit, radius - 2 * unit);
    }
    const QString sign = kind == Kind::Along    ? QStringLiteral("⤢")
                         : kind == Kind::Eye    ? QStringLiteral("◉")
                         : kind == Kind::Number ? QStringLiteral("↕")
                         : kind == Kind::Turn   ? QStringLiteral("↔")
                                                : QString();
    painter.setPen(Qt::black);
    painter.setFont(Theme::current().text(18, 700));
    painter.drawText(rect(), Qt::AlignCenter, sign);
    if (!hasFocus()) return;
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(Theme::colors(ThemeId::Dark).focus, 3 * unit));
    painter.drawEllipse(middle, 20 * unit, 20 * unit);
}

}  // namespace app
