#pragma once
#include <QWidget>

#include "app/document/document.h"
#include "app/talk/cue_model.h"

class QLabel;
class QLineEdit;
class QListView;
class QPlainTextEdit;
class QPushButton;

namespace app {

// The cues of a talk: their order, names, captions and notes. The window shows a cue and saves its views as one.
class CuePanel : public QWidget {
    Q_OBJECT
public:
    explicit CuePanel(Document& document, QWidget* parent = nullptr);

    CueModel& model() { return *m_model; }
    QListView& list() { return *m_list; }

signals:
    void asked(int cue);  // show it
    void keepAsked();     // what is seen, as a new cue
    void replaceAsked();  // likewise, in place of the current one
    void openAsked();
    void saveAsAsked();
    void presentAsked();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QWidget* makeHead();
    QWidget* makeEditor();
    void showCurrent();
    int selected() const;

    CueModel* m_model;
    QListView* m_list;
    QLabel *m_title = nullptr, *m_empty = nullptr;
    QPushButton *m_present = nullptr, *m_putBack = nullptr;
    QWidget* m_editor = nullptr;
    QLineEdit* m_caption = nullptr;
    QPlainTextEdit* m_note = nullptr;
    bool m_fills = false;  // the note, with that of another cue
};

}  // namespace app
