#pragma once
#include <QWidget>
#include <functional>
#include <optional>

#include "app/lesson/lesson_run.h"

class QVBoxLayout;

namespace app {

// The control in which a question is answered: a field, rows to choose from, a thing to click, settings to turn. The
// panel handles Enter and checks the answer.
class AnswerBody : public QWidget {
    Q_OBJECT
public:
    // Nothing until the user has chosen, typed or picked something.
    virtual std::optional<lessons::Given> given() const = 0;
    virtual void takeAttempt(const lessons::Attempt& attempt) { Q_UNUSED(attempt) }  // after a try
    virtual void takeFocus() = 0;
    virtual void choose(QChar key) { Q_UNUSED(key) }  // a digit, or the sign of a number
    // What one can do now: "Choose with 1 to 4, then Enter checks."
    virtual QString advice() const = 0;
    // For the bar over the views; empty where the answer is given in the card.
    virtual QString banner() const { return {}; }

signals:
    void changed();  // given() is another

protected:
    explicit AnswerBody(QWidget* parent);
    QVBoxLayout* m_column;
};

// For the question on the run's page; its texts must have arrived.
AnswerBody* makeAnswerBody(LessonRun& run, Document& document, QWidget* parent);

// One for each kind; choice and several are the same rows.
AnswerBody* makeNumberBody(const lessons::NumberQuestion& question, QWidget* parent);
AnswerBody* makeOptionsBody(const LessonRun& run, bool several, Document& document, QWidget* parent);
AnswerBody* makePickBody(const lessons::ClickQuestion& question, Document& document, QWidget* parent);
AnswerBody* makeOrderBody(const LessonRun& run, QWidget* parent);
AnswerBody* makeWriteBody(const lessons::WriteQuestion& question, const LessonRun& run, QWidget* parent);
AnswerBody* makeUntilBody(const lessons::UntilQuestion& question, LessonRun& run, Document& document, QWidget* parent);

}  // namespace app
