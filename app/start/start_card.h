#pragma once
#include <functional>
#include <vector>

#include "app/start/start_button.h"

class QLabel;

namespace app {

// A scene on the start page: its picture above its name.
class StartCard : public StartButton {
    Q_OBJECT
public:
    StartCard(const QString& title, const QString& text, QWidget* parent);

    void setPicture(const ScenePicture& picture);
    // In pixels, of that width: 1 or 2 lines.
    int nameLines(int width) const;
    void setNameHeight(int height) { m_nameHeight = height, update(); }

protected:
    void paintInside(QPainter& painter, const QRectF& box) const override;

private:
    ScenePicture m_picture;
    int m_nameHeight = 0;
};

// Scenes in rows under headings; the rows share the height. The arrows move, and Tab leaves.
class SceneGrid : public QWidget {
    Q_OBJECT
public:
    using QWidget::QWidget;

    void beginGroup(const QString& title);
    void add(StartCard* card);  // to the last group
    const QList<StartCard*>& shown() const { return m_shown; }
    // Shows those that are wanted under their heading.
    void choose(const std::function<bool(const StartCard& card, const QString& heading)>& isWanted);
    void setMostPicture(double share) { m_mostPicture = share; }  // of a picture's width, its height
    int leastHeight(int width) const;                             // with pictures that can still be recognised

signals:
    void leftUp();  // from the first row

protected:
    void resizeEvent(QResizeEvent* event) override;
    void paintEvent(QPaintEvent* event) override;  // the line beside each heading
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Group {
        QLabel* heading;
        QList<StartCard*> cards, shown;
    };
    struct Sizes;
    Sizes sizesAt(int width) const;
    void place();
    void focus(StartCard* card);
    StartCard* inRow(const StartCard& from, int by) const;

    std::vector<Group> m_groups;
    QList<StartCard*> m_shown;
    double m_mostPicture = 0.9;
};

}  // namespace app
