#pragma once
#include <QKeyEvent>
#include <QScrollArea>

namespace app {

// Leaves Alt with an arrow to the lesson, which turns its pages; a scroll area would scroll.
class LessonScroll : public QScrollArea {
public:
    using QScrollArea::QScrollArea;

protected:
    void keyPressEvent(QKeyEvent* event) override {
        if (event->modifiers() == Qt::AltModifier)
            event->ignore();
        else
            QScrollArea::keyPressEvent(event);
    }
};

}  // namespace app
