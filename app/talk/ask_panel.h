#pragma once
#include <QWidget>
#include <optional>

#include "app/talk/cue_model.h"

namespace app {

// The choices of a cue with a question, for the audience: letters and words, the counted votes, and in the answer the
// right choice. Votes are typed: a letter, then digits; Tab goes to the next.
class AskPanel : public QWidget {
    Q_OBJECT
public:
    AskPanel(CueModel& cues, QWidget* parent);

    bool asks() const { return m_cue.has_value(); }  // a question or its answer is on show
    bool isAnswer() const { return asks() && *m_cue != m_cues.current(); }
    QString title() const;   // the question; of an answer its caption
    QString remark() const;  // for the line at the bottom
    // Whether a key is for the votes, and takes it.
    bool wantsKey(int key) const;
    bool takeKey(int key);
    bool leaveField();                     // false where none had been chosen
    int field() const { return m_field; }  // that digits go into; -1: none

signals:
    void changed();

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void show(bool anew);
    void paintChoice(QPainter& painter, const QRectF& box, int choice, int total) const;
    const lessons::CueQuestion& question() const { return *m_cues.cue(*m_cue).ask; }

    CueModel& m_cues;
    std::optional<int> m_cue;  // that asks
    int m_field = -1;
    bool m_isNew = true;  // the first digit replaces what was there
};

}  // namespace app
