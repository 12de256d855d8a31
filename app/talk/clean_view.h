#pragma once
#include <QWidget>
#include <memory>

#include "app/document/document.h"
#include "app/talk/cue_model.h"

class QLabel;

namespace app {

class AskPanel;
class PenLayer;
class PinnedSettings;
class SceneOpener;
class TalkAlgorithm;
class TalkCaption;
class TalkEquation;
class TalkHint;
class TalkKeys;
class TalkPointer;
class TalkWork;
class ViewArea;

// The view for an audience: the window's views, the equation of the picked pixel or the algorithm of the step, the
// cue's sliders and a line of text. It shows the document, as the window does. It places its parts, and hides those
// that do not fit.
class CleanView : public QWidget {
    Q_OBJECT
public:
    CleanView(Document& document, CueModel& cues, const SceneOpener& opener);
    ~CleanView() override;

    pipeline::Errors lookAt(const lessons::WindowState& state);  // the views of a state, as they stand in the window
    ViewArea& views() { return *m_views; }
    PenLayer& pen() { return *m_pen; }
    AskPanel& ask() { return *m_ask; }
    TalkKeys& keys() { return *m_keys; }
    QString caption() const;
    QString shownKey() const;  // the last key pressed, or what has failed; empty after a moment
    // The text size at which the smallest text has at least 22 px of 1080 lines.
    static double scaleFor(int height);

signals:
    void left();
    void swapAsked();
    void cancelAsked();  // of the scene that is being read

protected:
    void resizeEvent(QResizeEvent* event) override;
    void closeEvent(QCloseEvent* event) override;

private:
    void arrange();
    void showQuestion();
    void showStep();
    void placeOverlays();

    ViewArea* m_views;
    TalkAlgorithm* m_algorithm;  // beside the views
    AskPanel* m_ask;             // the choices of a question, beside the views
    QLabel* m_title;             // a question, or its answer
    PinnedSettings* m_sliders;
    TalkEquation* m_equation;
    TalkCaption* m_caption;
    TalkHint* m_hint;  // the hint, the work and the pen are over the views
    TalkWork* m_work;
    PenLayer* m_pen;
    std::unique_ptr<TalkKeys> m_keys;
    std::unique_ptr<TalkPointer> m_pointer;
};

}  // namespace app
