#pragma once
#include <QWidget>

#include "app/lesson/lesson_run.h"

class QVBoxLayout;

namespace app {

class ProseView;
class QuestionCard;

// A page of a lesson: its text, its question; its second half once the question is settled. Before that the second half is
// not made, so that nothing can read it out.
class LessonPage : public QWidget {
    Q_OBJECT
public:
    LessonPage(LessonRun& run, Document& document, QWidget* parent);

    void showPage();  // another one
    void fill();      // its texts are there
    void showThen();  // its question is settled
    QuestionCard& card() { return *m_card; }

private:
    LessonRun& m_run;
    QVBoxLayout* m_column;
    ProseView *m_heading, *m_text;
    QuestionCard* m_card;
    ProseView* m_then = nullptr;
};

}  // namespace app
