#pragma once
#include <QWidget>

#include "app/lesson/lesson_run.h"
#include "app/lesson/lesson_shelf.h"

class QVBoxLayout;

namespace app {

// The end of a lesson: its pages with marks and points, the possible next steps, the user's mistakes, and the next
// lesson.
class LessonEnd : public QWidget {
    Q_OBJECT
public:
    LessonEnd(LessonRun& run, const LessonShelf& shelf, QWidget* parent);
    void showRun();  // at its end
    void takeFocus();

signals:
    void beginAsked(const QString& lesson);
    void allAsked();
    void resultsAsked();
    void forgetAsked();

private:
    void addPages();
    void addMistakes();
    void addNext();
    void addResults();

    LessonRun& m_run;
    const LessonShelf& m_shelf;
    QWidget* m_content = nullptr;
    QVBoxLayout* m_column;
};

}  // namespace app
