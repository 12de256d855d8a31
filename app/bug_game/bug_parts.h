#pragma once
#include <QWidget>
#include <array>

class QLabel;
class QPushButton;
class QRadioButton;

namespace app {

class BugRound;
class MathView;

// The part of the card in the phase of stages.
class BugStagePart : public QWidget {
public:
    BugStagePart(BugRound& round, QWidget* parent);

private:
    void showState();

    BugRound& m_round;
    QLabel* m_words;
    QPushButton* m_accuse;
};

// In the phase of causes: the causes to choose from.
class BugCausePart : public QWidget {
public:
    BugCausePart(BugRound& round, QWidget* parent);

    void choose(int cause);  // from 0; without effect if there is no such cause

private:
    void showState();

    BugRound& m_round;
    std::array<QRadioButton*, 5> m_causes{};
    QLabel* m_words;
    QPushButton* m_name;
};

// Once it is over: both equations of the pixel that differs most, the fix, and the lesson about it.
class BugEndPart : public QWidget {
    Q_OBJECT
public:
    BugEndPart(BugRound& round, QWidget* parent);

signals:
    void lessonAsked(const QString& lesson, const QString& heading);

private:
    void showReveal();
    void showState();
    void askLesson();

    BugRound& m_round;
    QLabel *m_wrongName, *m_rightName, *m_fix;
    MathView *m_wrong, *m_right;
    QPushButton *m_next, *m_lesson;
};

QLabel* bugLabel(const char* name, double size, int weight, QWidget* parent);
QPushButton* bugButton(const QString& text, const char* name, QWidget* parent);

}  // namespace app
