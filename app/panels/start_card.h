#pragma once
#include <QImage>
#include <functional>

#include "app/panels/start_button.h"

namespace app {

// A scene or a lesson on the start page: a picture where it has one, a title, a sentence or two.
class StartCard : public StartButton {
    Q_OBJECT
public:
    enum class Kind { Scene, Lesson };
    StartCard(Kind kind, const QString& title, const QString& text, QWidget* parent = nullptr);

    void setPicture(const QImage& picture);
    // The line at the foot of a lesson: where the reader is, and what a click does.
    void setFoot(const QString& state, const QString& action, double progress);

    int heightForWidth(int width) const override;
    QSize sizeHint() const override;

protected:
    void paintInside(QPainter& painter, const QRectF& box, const QPainterPath& shape) const override;

private:
    int titleHeight(int width) const;

    Kind m_kind;
    QString m_text, m_state, m_action;
    double m_progress = 0;  // 0 to 1
    QImage m_picture;
};

// Cards in rows of equal width, up to four in a row where there is room, else two. Arrows move, Enter opens.
class CardGrid : public QWidget {
    Q_OBJECT
public:
    using QWidget::QWidget;

    void add(StartCard* card);
    void clear();
    void setMostColumns(int most);
    const QList<StartCard*>& cards() const { return m_cards; }
    // Shows those that are wanted, the others give them their places. Whether there is any.
    bool choose(const std::function<bool(const StartCard& card)>& isWanted);

    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;
    QSize sizeHint() const override;

protected:
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    int columns(int width) const;
    int cardWidth(int width) const;
    int cardHeight(int width) const;
    void place();
    QList<StartCard*> m_cards, m_shown;
    int m_most = 4;
};

}  // namespace app
