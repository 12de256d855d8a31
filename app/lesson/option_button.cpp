#include "app/lesson/option_button.h"

#include <QPainter>
#include <algorithm>

#include "app/widgets/follow_theme.h"

namespace app {

namespace {

constexpr int kFlags = Qt::TextWordWrap | Qt::AlignLeft | Qt::AlignVCenter;

void paintMark(QPainter& painter, const QRectF& box, bool isRound, bool isChosen, bool isOff) {
    const ThemeColors& c = Theme::current().colors();
    painter.setPen(QPen(isOff ? c.warn : isChosen ? c.accent : c.outline, isOff ? 1.6 : 1.2));
    painter.setBrush(isChosen && !isOff && !isRound ? QBrush(c.fill) : QBrush(c.raised));
    if (isOff) {
        painter.setBrush(Qt::NoBrush);
        painter.drawPolygon(QPolygonF{{box.center().x(), box.top() + 1}, box.bottomRight(), box.bottomLeft()});
    } else if (isRound) {
        painter.drawEllipse(box);
        if (!isChosen) return;
        painter.setPen(Qt::NoPen);
        painter.setBrush(c.accent);
        painter.drawEllipse(box.adjusted(3.5, 3.5, -3.5, -3.5));
    } else {
        painter.drawRoundedRect(box, 3, 3);
        if (!isChosen) return;
        painter.setPen(QPen(c.onFill, 2));
        painter.drawPolyline(QPolygonF{{box.left() + 3, box.center().y()},
                                       {box.center().x() - 1, box.bottom() - 4},
                                       {box.right() - 3, box.top() + 4}});
    }
}

}  // namespace

template <class Button>
OptionButton<Button>::OptionButton(const QString& plain, int key, QWidget* parent) : Button(parent), m_key(key) {
    this->setText(plain);
    this->setAccessibleName(plain);
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Minimum);
    policy.setHeightForWidth(true);
    this->setSizePolicy(policy);
    this->setAttribute(Qt::WA_Hover);
    followTheme(this, [this] {
        this->setFont(Theme::current().text());
        this->updateGeometry();
    });
}

template <class Button>
void OptionButton<Button>::setOff(bool off) {
    m_off = off;
    this->setEnabled(!off);
    this->setAccessibleDescription(off ? Button::tr("Tried, not right") : QString());
    this->update();
}

template <class Button>
QRect OptionButton<Button>::textRect(int width) const {
    const Theme& theme = Theme::current();
    return {theme.px(32), 0, width - theme.px(32) - theme.px(38), 10000};
}

template <class Button>
int OptionButton<Button>::heightForWidth(int width) const {
    const Theme& theme = Theme::current();
    const int text =
        QFontMetrics(theme.text()).boundingRect(textRect(width), kFlags & ~Qt::AlignVCenter, this->text()).height();
    return std::max(theme.px(30), text + theme.px(12));
}

template <class Button>
QSize OptionButton<Button>::sizeHint() const {
    const int width = Theme::current().px(300);
    return {width, heightForWidth(width)};
}

// Of narrow lines: else the words in one line would be the least width of the page.
template <class Button>
QSize OptionButton<Button>::minimumSizeHint() const {
    return {Theme::current().px(140), Theme::current().px(30)};
}

template <class Button>
void OptionButton<Button>::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::current();
    const ThemeColors& c = theme.colors();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF box = QRectF(this->rect()).adjusted(1, 1, -1, -1);
    const bool isChosen = this->isChecked() && !m_off;
    if (isChosen || m_off || (this->underMouse() && this->isEnabled())) {
        painter.setPen(isChosen ? QPen(c.accent) : m_off ? QPen(c.outline) : QPen(Qt::NoPen));
        painter.setBrush(isChosen ? c.tint : c.hover);
        painter.drawRoundedRect(box, 4, 4);
    }
    const double side = theme.px(14);
    paintMark(painter, {theme.px(10) + 0.5, this->height() / 2.0 - side / 2, side, side},
              std::is_same_v<Button, QRadioButton>, isChosen, m_off);
    painter.setFont(theme.text());
    painter.setPen(m_off ? c.text2 : this->isEnabled() ? c.text : c.text3);
    QRect words = textRect(this->width());
    words.setHeight(this->height());
    painter.drawText(words, kFlags, this->text());
    if (this->isEnabled() || m_off) {
        const QRectF key(this->width() - theme.px(30), this->height() / 2.0 - theme.px(10), theme.px(20), theme.px(20));
        painter.setPen(c.outline);
        painter.setBrush(c.raised);
        painter.drawRoundedRect(key, 3, 3);
        painter.setPen(c.text2);
        painter.setFont(theme.mono(11));
        painter.drawText(key, Qt::AlignCenter, QString::number(m_key));
    }
    if (!this->hasFocus()) return;
    painter.setPen(QPen(c.focus, 2));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(box, 4, 4);
}

template class OptionButton<QRadioButton>;
template class OptionButton<QCheckBox>;

}  // namespace app
