#pragma once
#include <QToolButton>
#include <QWidget>

class QLabel;
class QVBoxLayout;

namespace app {

class ElidedLabel;

// A part of a panel with a title that folds it. Folded, the title also has a sentence that sums the part up.
class Section : public QWidget {
    Q_OBJECT
public:
    // `extra`, which may be null, stands at the right of the title; it is hidden while folded.
    Section(const QString& title, QWidget* body, QWidget* extra = nullptr, QWidget* parent = nullptr);

    void setSentence(const QString& sentence);
    void setKeepsSentence();  // shows it unfolded too, at the right
    void setFolded(bool folded);
    bool isFolded() const { return !m_title->isChecked(); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QToolButton* m_title;
    ElidedLabel* m_sentence;
    QWidget* m_body;
    QWidget* m_extra;
    QString m_text;
    bool m_keepsSentence = false;
};

}  // namespace app
