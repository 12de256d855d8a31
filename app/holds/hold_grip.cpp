#include "app/holds/hold_grip.h"

#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

#include "app/look/theme.h"
#include "app/widgets/follow_theme.h"

namespace app {

using GripShape = HoldGrip::Look::Shape;

HoldGrip::HoldGrip(const QString& name, Look look, QWidget* room)
    : QWidget(room), m_look(std::move(look)), m_words(new QLabel(room)) {
    speak(*this);
    setObjectName("holdGrip");
    setAccessibleName(name);
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

void HoldGrip::place(const Place& place) {
    setVisible(place.middle.has_value());
    if (!place.middle) return;
    m_isBehind = place.isBehind;
    m_scale = place.scale;
    const QWidget& room = *parentWidget();
    const double half = side() / 2.0;
    const QPointF at(std::clamp(place.middle->x(), half, std::max(half, room.width() - half)),
                     std::clamp(place.middle->y(), half, std::max(half, room.height() - half)));
    move((at - QPointF(half, half)).toPoint());
    setAccessibleDescription(place.words);
    m_words->setText(place.words);
    m_words->setWordWrap(false);
    m_words->adjustSize();
    if (const int most = room.width() - 4; m_words->width() > most) {
        m_words->setWordWrap(true);
        m_words->resize(most, m_words->heightForWidth(most));
    }
    m_words->setVisible(!place.words.isEmpty());
    const bool isBeside = place.isBeside || at.y() - half - m_words->height() < place.top;
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

void HoldGrip::setDragged(bool dragged) {
    m_isDragged = dragged;
    setCursor(dragged ? Qt::ClosedHandCursor : Qt::OpenHandCursor);
}

// One step that way, as the arrow keys do it: a lamp or the eye has no single number.
void HoldGrip::slideTo(double value) {
    if (value != m_scale.value) emit nudged({value > m_scale.value ? 1 : -1, 0}, false);
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
        case Qt::Key_Left: return emit nudged({-1, 0}, isCoarse);
        case Qt::Key_Right: return emit nudged({1, 0}, isCoarse);
        case Qt::Key_Up: return emit nudged({0, -1}, isCoarse);
        case Qt::Key_Down: return emit nudged({0, 1}, isCoarse);
        case Qt::Key_Home: return emit restored();
        case Qt::Key_Escape:
            if (m_isDragged) return emit cancelled();
            [[fallthrough]];
        default: QWidget::keyPressEvent(event);
    }
}

void HoldGrip::hideEvent(QHideEvent*) { m_words->hide(); }

void HoldGrip::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QPointF middle = QRectF(rect()).center();
    const double unit = side() / 44.0;
    const bool isLamp = m_look.shape == GripShape::Sun || m_look.shape == GripShape::Foot;
    const bool isHollow = m_isBehind || m_look.shape == GripShape::Foot;
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
    painter.setBrush(isHollow ? QBrush(Qt::black) : isLamp ? sun : ink);
    if (m_look.shape == GripShape::Square)
        painter.drawRoundedRect(QRectF(middle - QPointF(radius, radius), middle + QPointF(radius, radius)), 8 * unit,
                                8 * unit);
    else
        painter.drawEllipse(middle, radius, radius);
    if (isHollow) {
        painter.setPen(QPen(sun, 3 * unit));
        painter.drawEllipse(middle, radius - 2 * unit, radius - 2 * unit);
    }
    painter.setPen(Qt::black);
    painter.setFont(Theme::current().text(18, 700));
    painter.drawText(rect(), Qt::AlignCenter, m_look.sign);
    if (!hasFocus()) return;
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(Theme::colors(ThemeId::Dark).focus, 3 * unit));
    painter.drawEllipse(middle, 20 * unit, 20 * unit);
}

}  // namespace app
