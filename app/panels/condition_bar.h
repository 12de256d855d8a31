#pragma once
#include <QWidget>
#include <optional>

#include "app/core/background_job.h"
#include "app/core/document.h"
#include "lessons/condition_stop.h"

class QLabel;
class QLineEdit;
class QToolButton;

namespace app {

// A condition over all pixels, typed: says for how many it holds, goes from one to the next, and on to the next moment
// of the frame at which it begins to hold, where Play ends too. It follows the scene, and asks off the GUI thread.
class ConditionBar : public QWidget {
    Q_OBJECT
public:
    explicit ConditionBar(Document& document, QWidget* parent = nullptr);

    void open();  // with the keys going to the text
    void close();
    void setText(const QString& text);
    // Of the document's frame; nothing without a condition, or where it is wrong.
    const std::optional<lessons::ConditionMask>& mask() const { return m_mask; }
    QString said() const;  // the count, or what is wrong
    void goTo(bool next);  // the pixel after or before the picked one
    // To the next step that makes it hold at a pixel, from where the stepper stands, else from the frame's beginning.
    void runToStop();
    bool hasCondition() const { return m_condition.has_value(); }
    bool busy() const { return m_asking.busy() || m_searching.busy(); }

signals:
    void changed();  // the mask, or that there is none

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    void watchPlay();  // finds where Play has to end, whenever that may have changed
    void read();       // the text
    void evaluate();   // on the newest frame
    void take(const pipeline::Result<lessons::ConditionMask>& found);
    void say(const QString& text, bool isWrong);

    Document& m_document;
    QLineEdit* m_text;
    QLabel* m_said;
    QToolButton *m_previous, *m_next, *m_stop, *m_close;
    std::optional<lessons::Condition> m_condition;
    std::optional<lessons::ConditionMask> m_mask;
    // Where Play ends, of these steps, ahead of that moment; nothing where it is not known.
    struct Ahead {
        StepsPtr steps;
        pipeline::Moment from;
        std::string condition;
        std::optional<lessons::ConditionStop> stop;
    };
    std::optional<Ahead> m_ahead;
    glm::ivec2 m_stopsAt{0};  // the pixel of the newest stop that was found
    BackgroundJob m_asking, m_searching, m_watching;
};

// Veils the pixels of a mask's picture for which it does not hold.
QImage veilOf(const lessons::ConditionMask& mask);

}  // namespace app
