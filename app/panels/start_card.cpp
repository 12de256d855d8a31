#include "app/panels/start_card.h"

#include <algorithm>

#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>

#include "app/panels/follow_theme.h"

namespace app {

StartCard::StartCard(Kind kind, const QString& title, const QString& text, QWidget* parent)
    : StartButton(title, text, QSizePolicy::Preferred, QSizePolicy::Fixed, parent), m_kind(kind), m_text(text) {}

void StartCard::setPicture(const QImage& picture) {
    m_picture = picture;
    update();
}

void StartCard::setFoot(const QString& state, const QString& action, double progress) {
    m_state = state;
    m_action = action;
    m_progress = progress;
    update();
}

int StartCard::titleHeight(int width) const {
    const Theme& theme = Theme::current();
    const QRect room(0, 0, width, 1000);
    return std::max(theme.px(20),
                    QFontMetrics(theme.text(14, 600)).boundingRect(room, Qt::TextWordWrap, text()).height());
}

int StartCard::heightForWidth(int width) const {
    const Theme& theme = Theme::current();
    const QRect room(0, 0, width - theme.px(24) - 8, 1000);
    const int words = QFontMetrics(theme.text(12)).boundingRect(room, Qt::TextWordWrap, m_text).height();
    const int padding = theme.px(28);
    return words + titleHeight(room.width()) + padding + (m_kind == Kind::Scene ? width * 3 / 4 : theme.px(34));
}

QSize StartCard::sizeHint() const { return {Theme::current().px(240), heightForWidth(Theme::current().px(240))}; }

void StartCard::paintInside(QPainter& painter, const QRectF& box, const QPainterPath& shape) const {
    const Theme& theme = Theme::current();
    const ThemeColors& c = theme.colors();

    QRectF words = box.adjusted(theme.px(12), theme.px(10), -theme.px(12), -theme.px(8));
    if (m_kind == Kind::Scene) {
        const QRectF picture(box.left(), box.top(), box.width(), box.width() * 3 / 4);
        painter.setClipPath(shape);
        if (m_picture.isNull()) {
            painter.fillRect(picture, c.view);
        } else {
            painter.drawImage(picture, m_picture);
        }
        painter.setClipping(false);
        words.setTop(picture.bottom() + theme.px(8));
    }
    painter.setFont(theme.text(14, 600));
    painter.setPen(c.text);
    const double title = titleHeight(int(words.width()));
    painter.drawText(QRectF(words.left(), words.top(), words.width(), title), Qt::AlignVCenter | Qt::TextWordWrap,
                     text());
    words.setTop(words.top() + title);
    painter.setFont(theme.text(12));
    painter.setPen(c.text2);
    painter.drawText(words, Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, m_text);

    if (!m_action.isEmpty()) {
        const QRectF foot(words.left(), words.bottom() - theme.px(18), words.width(), theme.px(18));
        painter.drawText(foot, Qt::AlignLeft | Qt::AlignVCenter, m_state);
        painter.setPen(c.accent);
        painter.drawText(foot, Qt::AlignRight | Qt::AlignVCenter, m_action);
        QRectF bar(foot.left(), foot.top() - theme.px(8), foot.width(), theme.px(4));
        painter.setPen(Qt::NoPen);
        painter.setBrush(c.hover);
        painter.drawRoundedRect(bar, theme.px(2), theme.px(2));
        bar.setWidth(bar.width() * m_progress);
        painter.setBrush(c.accent);
        painter.drawRoundedRect(bar, theme.px(2), theme.px(2));
    }
}

void CardGrid::add(StartCard* card) {
    card->setParent(this);
    card->installEventFilter(this);
    m_cards += card, m_shown += card;
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    updateGeometry();
}

void CardGrid::clear() {
    qDeleteAll(m_cards);
    m_cards.clear(), m_shown.clear();
}

bool CardGrid::choose(const std::function<bool(const StartCard& card)>& isWanted) {
    m_shown.clear();
    for (StartCard* card : m_cards) {
        const bool wanted = isWanted(*card);
        card->setVisible(wanted);
        if (wanted) m_shown += card;
    }
    place();
    updateGeometry();
    return !m_shown.isEmpty();
}

int CardGrid::columns(int width) const {
    const Theme& theme = Theme::current();
    return std::clamp(width / theme.px(210), width < theme.px(280) ? 1 : 2, m_most);
}

void CardGrid::setMostColumns(int most) {
    m_most = most;
    updateGeometry();
}

int CardGrid::cardWidth(int width) const {
    const int n = columns(width);
    return (width - (n - 1) * Theme::current().px(10)) / n;
}

// The card with the most to say decides for all.
int CardGrid::cardHeight(int width) const {
    int height = 0;
    for (const StartCard* card : m_shown) height = std::max(height, card->heightForWidth(cardWidth(width)));
    return height;
}

int CardGrid::heightForWidth(int width) const {
    if (m_shown.isEmpty()) return 0;
    const int n = columns(width), rows = (int(m_shown.size()) + n - 1) / n, gap = Theme::current().px(10);
    return rows * cardHeight(width) + (rows - 1) * gap;
}

QSize CardGrid::sizeHint() const { return {Theme::current().px(600), heightForWidth(std::max(width(), 600))}; }

void CardGrid::resizeEvent(QResizeEvent*) { place(); }

void CardGrid::place() {
    if (m_shown.isEmpty()) return;
    const int n = columns(width()), w = cardWidth(width()), h = cardHeight(width());
    const int gap = Theme::current().px(10);
    for (int i = 0; i < m_shown.size(); ++i) m_shown[i]->setGeometry((i % n) * (w + gap), (i / n) * (h + gap), w, h);
    setMinimumHeight(heightForWidth(width()));
}

bool CardGrid::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::KeyPress) return QWidget::eventFilter(watched, event);
    const qsizetype at = m_shown.indexOf(static_cast<StartCard*>(watched));
    const auto focus = [this](qsizetype i) {
        if (i >= 0 && i < m_shown.size()) m_shown[i]->setFocus(Qt::TabFocusReason);
        return true;
    };
    switch (static_cast<QKeyEvent*>(event)->key()) {
        case Qt::Key_Left: return focus(at - 1);
        case Qt::Key_Right: return focus(at + 1);
        case Qt::Key_Up: return focus(at - columns(width()));
        case Qt::Key_Down: return focus(at + columns(width()));
        case Qt::Key_Return:
        case Qt::Key_Enter: m_shown[at]->click(); return true;
        default: return QWidget::eventFilter(watched, event);
    }
}

}  // namespace app
