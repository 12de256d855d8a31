#pragma once
#include <QFrame>

class QLabel;

namespace app {

class ProseView;

// The feedback to an answer: a box with a bar at its left, a heading with its mark, and text.
class NoteBox : public QFrame {
    Q_OBJECT
public:
    enum class Kind : unsigned char { Known, Unknown, Again, Right };

    explicit NoteBox(QWidget* parent);
    void say(Kind kind, const QString& heading, const QString& markdown);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    Kind m_kind = Kind::Again;
    QLabel* m_heading;
    ProseView* m_text;
};

}  // namespace app
