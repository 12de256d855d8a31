#pragma once
#include <QFrame>

#include "app/lesson/lesson_run.h"

class QHBoxLayout;
class QLabel;
class QPushButton;
class QStackedWidget;
class QVBoxLayout;

namespace app {

class AnswerBody;
class NoteBox;
class ProseView;

// The question of the open page: its points, the control for the answer, the feedback, its hints, and the solution once
// it is settled.
class QuestionCard : public QFrame {
    Q_OBJECT
public:
    QuestionCard(LessonRun& run, Document& document, QWidget* parent);

    void ask();         // another page's question, its texts not yet there
    void fill();        // they are there
    void showWindow();  // whether the window shows what the page does
    void check();
    void giveHint();
    void askToShow();        // the answer: once, in its place
    void choose(QChar key);  // a digit, or the sign of a number
    void takeFocus();
    bool isOpen() const;     // answers are taken
    QString advice() const;  // what one can do now
    QString banner() const;
    QWidget& note() const;  // what was said to the last answer
    // Puts Check, Hint and Show me before the last row of a column that does not scroll; null: back into the card.
    void standIn(QVBoxLayout* column);

signals:
    void settled();
    void said(const QString& sentence);  // after a try, for the status bar
    void adviceChanged();
    void failed(const QString& what, const pipeline::Errors& errors);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void makeButtons();
    void arrange();
    void showHints();
    void showSettled();
    void dropBody();

    LessonRun& m_run;
    Document& m_document;
    QVBoxLayout* m_column;
    QLabel *m_worth, *m_tries;
    ProseView* m_question;
    AnswerBody* m_body = nullptr;
    NoteBox* m_note;
    QWidget* m_hints;
    QWidget* m_elsewhere;
    QStackedWidget* m_acts;  // its buttons, or whether one is sure
    QPushButton *m_check, *m_hint, *m_show;
    ProseView* m_solution;
};

// "1.5": points as the card and the head write them.
QString pointsText(double points);

}  // namespace app
