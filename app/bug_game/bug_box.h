#pragma once
#include <QAbstractButton>

namespace app {

// What can be marked in the game of the wrong picture: the file or a stage, with its key and what is known of it.
class BugBox : public QAbstractButton {
    Q_OBJECT
public:
    enum class State : unsigned char { Open, Cleared, Wrong };

    explicit BugBox(int box, QWidget* parent = nullptr);  // as lessons::boxLabel counts them

    // Open shows the number of looks, cleared "did what it should", named "wrong here". isMarked: the next accusation
    // names this one.
    void show(State state, int looks, bool isMarked);
    QString verdict() const;  // "not marked", "2 looks", "did what it should", "wrong here"
    State state() const { return m_state; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    int m_box, m_looks = 0;
    State m_state = State::Open;
    bool m_isMarked = false;
};

}  // namespace app
