#pragma once
#include <QTimer>
#include <QWidget>

#include "app/core/cue_model.h"
#include "app/core/document.h"

class QFrame;
class QLabel;

namespace app {

class AlgorithmView;
class AskPanel;
class CaptionLine;
class MathView;
class OpeningBar;
class PenLayer;
class SceneOpener;
class ViewArea;

// What an audience sees: the views as the window has them, the equation of the picked pixel or the algorithm of the step,
// the cue's sliders and a line of words; nothing else. It shows the document, as the window does. Keys: B black, W white, P pen, O spotlight, A algorithm, 1 the active view
// alone, 2 all views, Esc stops what takes long, takes back what covers the views, then leaves.
class CleanView : public QWidget {
    Q_OBJECT
public:
    CleanView(Document& document, CueModel& cues, const SceneOpener& opener);
    ~CleanView() override;

    pipeline::Errors lookAt(const lessons::WindowState& state);  // the views of a state, as they stand in the window
    ViewArea& views() { return *m_views; }
    PenLayer& pen() { return *m_pen; }
    AskPanel& ask() { return *m_ask; }
    QString caption() const;
    QString shownKey() const;  // the last key pressed, for 1.2 s; what could not be read, for 4 s
    // The key does something here, or was an ordinary one.
    bool takeKey(int key);
    // The size of the letters that keeps all of them readable: 22 px in 1080 lines at least.
    static double scaleFor(int height);

signals:
    void left();
    void swapAsked();    // F4
    void cancelAsked();  // of the scene that is being read

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void closeEvent(QCloseEvent* event) override;

private:
    QWidget* makeAlgorithm();
    QWidget* makeEquation();
    void makeWork();
    void showEquation();
    void showAlgorithm();
    void showCaption();
    void showQuestion();
    void showKey(const QKeyEvent& key);
    void wakeCursor();
    void applyTheme();
    void placeWork();
    void showKeys();
    bool stopWork();

    Document& m_document;
    CueModel& m_cues;
    ViewArea* m_views;
    QWidget* m_algorithmColumn;  // beside the views: the lines, and why some are left out
    AlgorithmView* m_algorithm;
    QLabel* m_leftOut;
    QLabel* m_title;  // a question, or its answer
    AskPanel* m_ask;  // its choices, beside the views
    QWidget* m_equationRow;
    MathView* m_math;
    QLabel *m_swatch, *m_value;
    CaptionLine* m_caption;
    QLabel* m_hint;  // how to go on and how to leave, or all keys: until the next key or for some seconds
    const SceneOpener& m_opener;
    QFrame* m_work;  // over the views, while the next scene is being read, and what takes long
    PenLayer* m_pen;
    QTimer m_keyTime, m_hintTime, m_cursorTime;
    QTimer m_workTime;  // runs for a moment after work was on show
    bool m_works = false;
    bool m_cursorHidden = false;
};

}  // namespace app
