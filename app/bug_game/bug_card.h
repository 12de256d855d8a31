#pragma once
#include <QPoint>
#include <QWidget>

class QLabel;
class QLineEdit;
class QListWidget;
class QPlainTextEdit;
class QPushButton;
class QScrollArea;

namespace app {

class BugCausePart;
class BugEndPart;
class BugRound;
class BugStagePart;

// The texts of the game: the question, the number of looks, the last message, the points; below them the part of the
// current phase.
class BugCard : public QWidget {
    Q_OBJECT
public:
    BugCard(BugRound& round, QWidget* parent);

    BugCausePart& causes() { return *m_causes; }
    void showCursor(QPoint pixel);

signals:
    void lessonAsked(const QString& lesson, const QString& heading);
    void ownAsked();

private:
    void makeFields();
    void layOut();
    void showState();
    void showLooks();
    void say(const QString& text);
    void fitText();
    void setFonts();
    void begin();  // with the seed that was typed

    BugRound& m_round;
    BugStagePart* m_stage;
    BugCausePart* m_causes;
    BugEndPart* m_end;
    QLabel *m_heading, *m_what, *m_count, *m_foot;
    QListWidget* m_looks;
    QPlainTextEdit* m_text;
    QScrollArea* m_scroll;
    class KeptInSight* m_sight;
    QLineEdit *m_pixel, *m_seed;
    QPushButton *m_hint, *m_own;
};

}  // namespace app
