#pragma once
#include <QFontMetrics>
#include <QLabel>
#include <QPainter>
#include <algorithm>

namespace app {

// As many phrases, separated by commas, as fit, from the first on.
inline QString wholePhrases(QString words, const QFontMetrics& metrics, int width) {
    while (metrics.horizontalAdvance(words) > width) words.truncate(std::max<qsizetype>(words.lastIndexOf(','), 0));
    return words;
}

// One line that ends in … where it does not fit; its tooltip then has the whole of it.
class ElidedLabel : public QLabel {
public:
    using QLabel::QLabel;

    QSize minimumSizeHint() const override { return {0, QLabel::minimumSizeHint().height()}; }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.setPen(palette().color(foregroundRole()));
        const QRect area = contentsRect();
        painter.drawText(area, int(alignment()), fontMetrics().elidedText(text(), Qt::ElideRight, area.width()));
    }
    // When it is asked for, since nothing tells of another text.
    bool event(QEvent* event) override {
        if (event->type() == QEvent::ToolTip || event->type() == QEvent::Resize)
            setToolTip(fontMetrics().horizontalAdvance(text()) > contentsRect().width() ? text() : QString());
        return QLabel::event(event);
    }
};

}  // namespace app
