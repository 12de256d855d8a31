#pragma once
#include "app/start/start_button.h"
#include "app/start/start_lessons.h"

namespace app {

// A lesson in its list.
class LessonRow : public StartButton {
    Q_OBJECT
public:
    // number: from 1, in its lecture.
    LessonRow(const StartLesson& lesson, int number, QWidget* parent);

    const StartLesson& lesson() const { return m_lesson; }
    void setLit(bool isLit);  // the one to go on with
    int wantedHeight(int width) const;

protected:
    void paintInside(QPainter& painter, const QRectF& box) const override;

private:
    int besideName() const;  // what mark and foot take of the width
    QString atRight() const;

    StartLesson m_lesson;
    int m_number;
    bool m_isLit = false;
};

}  // namespace app
