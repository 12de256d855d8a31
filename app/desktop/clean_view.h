#pragma once
#include <QTimer>
#include <QWidget>

#include "app/core/cue_model.h"
#include "app/core/document.h"

class QLabel;

namespace app {

class BufferView;
class CaptionLine;
class MathView;
class PenLayer;
class View3dPanel;

// What an audience sees: one or two views, the equation of the picked pixel, and a line of words; nothing else. It shows
// the document, as the window does. Keys: B black, W white, P pen, O spotlight, 1 and 2 how many views, Esc takes back
// what covers the views, then leaves.
class CleanView : public QWidget {
    Q_OBJECT
public:
    CleanView(Document& document, CueModel& cues);
    ~CleanView() override;

    // The views of a state: two buffers where it shows two, else a buffer and the 3D view.
    pipeline::Errors lookAt(const WindowState& state);
    int viewCount() const { return m_views; }
    void setViewCount(int views);  // 1 or 2
    PenLayer& pen() { return *m_pen; }
    BufferView& first() { return *m_first; }
    QString caption() const;
    QString shownKey() const;  // the last key pressed, for 1.2 s
    // The key does something here, or was an ordinary one.
    bool takeKey(int key);
    // The size of the letters that keeps all of them readable: 22 px in 1080 lines at least.
    static double scaleFor(int height);

signals:
    void left();
    void swapAsked();  // F4
    void changed();    // what is seen, save for what the document tells

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void closeEvent(QCloseEvent* event) override;

private:
    QWidget* makeViews();
    QWidget* makeEquation();
    void showEquation();
    void showCaption();
    void showKey(const QKeyEvent& key);
    void showNames();
    void wakeCursor();
    void applyTheme();

    Document& m_document;
    CueModel& m_cues;
    BufferView *m_first, *m_second;
    View3dPanel* m_space;
    QWidget *m_firstFrame, *m_secondFrame, *m_spaceFrame;
    QLabel *m_firstName, *m_secondName;
    QWidget* m_equationRow;
    MathView* m_math;
    QLabel *m_swatch, *m_value;
    CaptionLine* m_caption;
    PenLayer* m_pen;
    QTimer m_keyTime, m_cursorTime;
    int m_views = 2;
    bool m_twoBuffers = false, m_cursorHidden = false;
};

}  // namespace app
