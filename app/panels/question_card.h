#pragma once
#include <QFrame>

class QLineEdit;
class QPushButton;

namespace app {

class ProseView;

// A question with a field for the answer, Check and Hint, and what is said to the answer.
class QuestionCard : public QFrame {
    Q_OBJECT
public:
    explicit QuestionCard(QWidget* parent = nullptr);

    void ask(const QString& question, bool hasHint);  // clears field and comment
    void setQuestion(const QString& question);        // the same question, its numbers filled in
    void setReady(bool ready);                        // whether an answer can be checked yet
    enum class Comment { Hint, Right, NotYet };
    void say(const QString& markdown, Comment kind);

signals:
    void answered(const QString& typed);
    void hintAsked();

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    ProseView* m_question;
    QLineEdit* m_field;
    QPushButton *m_check, *m_hint;
    ProseView* m_comment;
};

}  // namespace app
