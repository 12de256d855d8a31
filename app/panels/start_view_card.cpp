#include "app/panels/start_view_card.h"

#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>

#include "app/panels/follow_theme.h"

namespace app {

static QString describe(const StartView& view) {
    QStringList labels;
    for (const StartView::Part& part : view.parts) labels += part.label;
    return view.text + ' ' + labels.join(QStringLiteral(", "));
}

// Fixed would be the height of the hint.
StartViewCard::StartViewCard(const StartView& view, QWidget* parent)
    : StartButton(view.title, describe(view), QSizePolicy::Expanding, QSizePolicy::Preferred, parent),
      m_view(view),
      m_pictures(view.parts.size()) {
    setObjectName(QStringLiteral("view:") + view.name);
}

void StartViewCard::setPicture(std::size_t part, const QImage& picture) {
    m_pictures[part] = picture;
    update();
}

// Pictures are twice as wide as high at most, so that what follows stays in sight.
int StartViewCard::heightForWidth(int width) const {
    const Theme& theme = Theme::current();
    return width / (2 * std::max(1, int(m_pictures.size()))) + int(labelHeight(width)) + theme.px(60);
}

// Of the labels below the pictures: two lines where one of them is too long for its picture.
double StartViewCard::labelHeight(double width) const {
    const Theme& theme = Theme::current();
    const QFontMetrics metrics(theme.text(12, 600));
    const double room = width / double(m_pictures.size()) - theme.px(8);
    const bool wraps = std::ranges::any_of(
        m_view.parts, [&](const StartView::Part& part) { return metrics.horizontalAdvance(part.label) > room; });
    return (wraps ? 2 : 1) * metrics.height() + theme.px(8);
}

QSize StartViewCard::sizeHint() const { return {Theme::current().px(480), heightForWidth(Theme::current().px(480))}; }

// The middle of a picture, cut to the place's shape.
void StartViewCard::paintPicture(QPainter& painter, const QRectF& place, std::size_t part) const {
    const Theme& theme = Theme::current();
    const QImage& picture = m_pictures[part];
    if (picture.isNull()) {
        painter.fillRect(place, theme.colors().view);
    } else {
        const double scale = std::max(place.width() / picture.width(), place.height() / picture.height());
        QRectF source(0, 0, place.width() / scale, place.height() / scale);
        source.moveCenter(QRectF(picture.rect()).center());
        painter.drawImage(place, picture, source);
    }
}

void StartViewCard::paintInside(QPainter& painter, const QRectF& box, const QPainterPath& shape) const {
    const Theme& theme = Theme::current();
    const ThemeColors& c = theme.colors();
    const double foot = theme.px(50), labels = labelHeight(box.width());
    const auto count = double(m_pictures.size());
    painter.setClipPath(shape);
    for (std::size_t i = 0; i < m_pictures.size(); ++i) {
        const double left = box.left() + double(i) * box.width() / count;
        const QRectF place(left, box.top(), box.width() / count - 1, box.height() - foot - labels);
        paintPicture(painter, place, i);
        painter.setFont(theme.text(12, 600));
        painter.setPen(c.text);
        painter.drawText(QRectF(place.left(), place.bottom(), place.width(), labels).adjusted(2, 0, -2, 0),
                         Qt::AlignCenter | Qt::TextWordWrap, m_view.parts[i].label);
    }
    painter.setClipping(false);
    QRectF words(box.left() + theme.px(12), box.bottom() - foot, box.width() - theme.px(24), foot);
    painter.setFont(theme.text(13, 600));
    painter.setPen(c.accent);
    const QString open = tr("Open");
    painter.drawText(words, Qt::AlignRight | Qt::AlignVCenter, open);
    words.setRight(words.right() - painter.fontMetrics().horizontalAdvance(open) - theme.px(12));
    painter.setFont(theme.text(14, 600));
    painter.setPen(c.text);
    painter.drawText(words, Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(text(), Qt::ElideRight, int(words.width())));
    words.setLeft(words.left() + painter.fontMetrics().horizontalAdvance(text()) + theme.px(12));
    painter.setFont(theme.text(12));
    painter.setPen(c.text2);
    if (words.width() >= painter.fontMetrics().horizontalAdvance(m_view.text))
        painter.drawText(words, Qt::AlignLeft | Qt::AlignVCenter, m_view.text);
}

void StartViewCard::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) return click();
    if (event->key() == Qt::Key_Down) return void(focusNextChild());
    if (event->key() == Qt::Key_Up) return void(focusPreviousChild());
    StartButton::keyPressEvent(event);
}

}  // namespace app
