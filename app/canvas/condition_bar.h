#pragma once
#include <QWidget>
#include <optional>

#include "app/document/document.h"
#include "app/jobs/background_job.h"
#include "lessons/expression/condition_stop.h"

class QLabel;
class QLineEdit;
class QToolButton;

namespace app {

// The field for the document's condition over all pixels. It counts the pixels for which the condition is true, goes
// from one to the next, and runs to the next moment of the frame at which it becomes true for some pixel; Play stops
// there too. An expression without a comparison gives numbers instead of a mask. Mask and numbers are derived buffers.
class ConditionBar : public QWidget {
    Q_OBJECT
public:
    explicit ConditionBar(Document& document, QWidget* parent = nullptr);

    void open();    // with the keys going to the text
    void reveal();  // without
    void close();
    void setText(const QString& text);
    void setBare(bool bare);  // for an audience: the condition as words, and nothing to press
    // Of the document's frame; null while it is closed, without a condition, or where it is wrong.
    std::shared_ptr<const lessons::ConditionMask> mask() const;
    QString said() const;  // the count, or what is wrong
    void goTo(bool next);  // the pixel after or before the picked one
    // To the next step that makes it hold at a pixel, from where the stepper stands, else from the frame's beginning.
    void runToStop();
    bool hasCondition() const { return m_condition.has_value(); }
    bool busy() const;

signals:
    void left();     // closes, and had the focus
    void changed();  // the mask, or that there is none

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    void watchPlay();  // finds where Play has to end, whenever that may have changed
    void read();       // the text
    void tell();       // what has been found
    void say(const QString& text, bool isWrong);

    Document& m_document;
    void showWords(bool words);

    QLineEdit* m_text;
    QLabel* m_said;
    QToolButton *m_previous, *m_next, *m_stop, *m_close;
    std::optional<lessons::Expression> m_condition;
    QString m_wrong;  // with the text
    bool m_isOfNumbers = false;
    // Where Play ends, of these steps, ahead of that moment; nothing where it is not known.
    struct Ahead {
        StepsPtr steps;
        pipeline::Moment from;
        std::string condition;
        std::optional<lessons::ConditionStop> stop;
    };
    std::optional<Ahead> m_ahead;
    glm::ivec2 m_stopsAt{0};  // the pixel of the newest stop that was found
    std::shared_ptr<const pipeline::Scene> m_searchedScene;
    BackgroundJob m_searching, m_watching;
};

// Veils the pixels of a mask's picture for which it does not hold.
QImage veilOf(const lessons::ConditionMask& mask);

}  // namespace app
