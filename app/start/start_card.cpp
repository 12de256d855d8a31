#include "app/start/start_card.h"

#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "app/widgets/follow_theme.h"

namespace app {
namespace {

QFont nameFont() { return Theme::current().text(12, 500); }
int namePadding() { return Theme::current().px(6); }

}  // namespace

StartCard::StartCard(const QString& title, const QString& text, QWidget* parent)
    : StartButton(title, text, Frame::Card, parent) {}

void StartCard::setPicture(const ScenePicture& picture) {
    m_picture = picture;
    update();
}

int StartCard::nameLines(int width) const {
    return QFontMetrics(nameFont()).horizontalAdvance(text()) > width - 2 * namePadding() ? 2 : 1;
}

void StartCard::paintInside(QPainter& painter, const QRectF& box) const {
    const QRectF picture = box.adjusted(0, 0, 0, -m_nameHeight);
    paintScenePicture(painter, picture, m_picture.image, m_picture.drawn);
    painter.setFont(nameFont());
    painter.setPen(Theme::current().colors().text);
    painter.drawText(QRectF(box.left(), picture.bottom(), box.width(), m_nameHeight)
                         .adjusted(namePadding(), 0, -namePadding() / 2.0, 0),
                     Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap, text());
}

void SceneGrid::beginGroup(const QString& title) {
    auto* heading = new QLabel(title, this);
    heading->setProperty("tone", 2);
    followTheme(heading, [heading] { heading->setFont(Theme::current().text(12)); });
    m_groups.push_back({heading, {}, {}});
}

void SceneGrid::add(StartCard* card) {
    card->installEventFilter(this);
    card->setFocusPolicy(m_shown.isEmpty() ? Qt::StrongFocus : Qt::ClickFocus);
    m_groups.back().cards += card, m_groups.back().shown += card, m_shown += card;
}

void SceneGrid::choose(const std::function<bool(const StartCard& card, const QString& heading)>& isWanted) {
    m_shown.clear();
    for (Group& group : m_groups) {
        group.shown.clear();
        for (StartCard* card : group.cards) {
            const bool wanted = isWanted(*card, group.heading->text());
            card->setVisible(wanted);
            if (wanted) group.shown += card;
        }
        group.heading->setVisible(!group.shown.isEmpty());
        m_shown += group.shown;
    }
    for (StartCard* card : m_shown) card->setFocusPolicy(card == m_shown.front() ? Qt::StrongFocus : Qt::ClickFocus);
    place();
}

// Of the whole grid at one width, in pixels.
struct SceneGrid::Sizes {
    int columns, width, name, heading, across, down, rows, headings;
    int withoutPictures() const { return rows * name + headings * heading + (rows + headings - 1) * down; }
};

SceneGrid::Sizes SceneGrid::sizesAt(int width) const {
    const Theme& theme = Theme::current();
    Sizes sizes{};
    sizes.across = theme.px(8), sizes.down = theme.px(width < theme.px(600) ? 3 : 6);
    sizes.columns = std::clamp((width + sizes.across) / theme.px(104), 2, 5);
    sizes.width = (width - (sizes.columns - 1) * sizes.across) / sizes.columns;
    sizes.heading = QFontMetrics(theme.text(12)).height() + theme.px(1);
    int lines = 1;
    for (const Group& group : m_groups) {
        if (group.shown.isEmpty()) continue;
        ++sizes.headings;
        sizes.rows += (int(group.shown.size()) + sizes.columns - 1) / sizes.columns;
        for (const StartCard* card : group.shown) lines = std::max(lines, card->nameLines(sizes.width));
    }
    sizes.name = lines * QFontMetrics(nameFont()).lineSpacing() + theme.px(5);
    return sizes;
}

int SceneGrid::leastHeight(int width) const {
    const Sizes sizes = sizesAt(width);
    return sizes.rows == 0 ? 0 : sizes.withoutPictures() + sizes.rows * sizes.width * 11 / 20;
}

void SceneGrid::resizeEvent(QResizeEvent*) { place(); }

void SceneGrid::place() {
    if (m_shown.isEmpty()) return setMinimumHeight(0);
    const Sizes sizes = sizesAt(width());
    setMinimumHeight(leastHeight(width()));
    const int room = (height() - sizes.withoutPictures()) / sizes.rows;
    const int picture = std::clamp(room, sizes.width * 11 / 20, int(std::lround(sizes.width * m_mostPicture)));
    int y = 0;
    for (const Group& group : m_groups) {
        if (group.shown.isEmpty()) continue;
        group.heading->setGeometry(0, y, std::min(width(), group.heading->sizeHint().width()), sizes.heading);
        y += sizes.heading + sizes.down;
        const int high = picture + sizes.name;
        for (qsizetype i = 0; i < group.shown.size(); ++i) {
            if (i > 0 && i % sizes.columns == 0) y += high + sizes.down;
            group.shown[i]->setNameHeight(sizes.name);
            group.shown[i]->setGeometry(int(i % sizes.columns) * (sizes.width + sizes.across), y, sizes.width, high);
        }
        y += high + sizes.down;
    }
}

void SceneGrid::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setPen(Theme::current().colors().line);
    for (const Group& group : m_groups) {
        if (group.heading->isHidden()) continue;
        const QRect words = group.heading->geometry();
        painter.drawLine(words.right() + Theme::current().px(10), words.center().y(), width(), words.center().y());
    }
}

void SceneGrid::focus(StartCard* card) {
    if (!card) return;
    for (StartCard* other : m_shown) other->setFocusPolicy(other == card ? Qt::StrongFocus : Qt::ClickFocus);
    card->setFocus(Qt::TabFocusReason);
}

// The nearest card of the next row; null beyond the last.
StartCard* SceneGrid::inRow(const StartCard& from, int by) const {
    StartCard* nearest = nullptr;
    const auto away = [&](const StartCard* card) {
        return std::pair(by * (card->y() - from.y()), std::abs(card->x() - from.x()));
    };
    for (StartCard* card : m_shown)
        if (by * (card->y() - from.y()) > 0 && (!nearest || away(card) < away(nearest))) nearest = card;
    return nearest;
}

bool SceneGrid::eventFilter(QObject* watched, QEvent* event) {
    auto* card = static_cast<StartCard*>(watched);
    if (event->type() == QEvent::FocusIn) focus(card);
    if (event->type() != QEvent::KeyPress) return QWidget::eventFilter(watched, event);
    const qsizetype at = m_shown.indexOf(card);
    switch (static_cast<QKeyEvent*>(event)->key()) {
        case Qt::Key_Left: focus(m_shown.value(at - 1)); return true;
        case Qt::Key_Right: focus(m_shown.value(at + 1)); return true;
        case Qt::Key_Down: focus(inRow(*card, 1)); return true;
        case Qt::Key_Up:
            if (StartCard* above = inRow(*card, -1))
                focus(above);
            else
                emit leftUp();
            return true;
        default: return QWidget::eventFilter(watched, event);
    }
}

}  // namespace app
