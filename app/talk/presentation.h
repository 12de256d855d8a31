#pragma once
#include <QObject>
#include <map>
#include <memory>
#include <optional>

#include "app/document/document.h"
#include "app/look/theme.h"
#include "app/talk/cue_model.h"

class QAction;
class QScreen;
class QWidget;

namespace app {

class CleanView;
class NotesWindow;
class SceneOpener;

// A talk: the clean view on one screen and, where there is another, the notes on it. Letters are as large as the
// audience's screen needs them while it lasts.
class Presentation : public QObject {
    Q_OBJECT
public:
    Presentation(Document& document, CueModel& cues, const SceneOpener& opener, QWidget& window);
    ~Presentation() override;

    bool isOn() const { return m_clean != nullptr; }
    // From before it begins until the text has its size again.
    bool changesWindow() const { return m_changesWindow; }
    // keys: actions whose keys work in the clean view and in the notes.
    void begin(const lessons::WindowState& state, const QList<QAction*>& keys, bool withNotes);
    void end();
    pipeline::Errors lookAt(const lessons::WindowState& state);
    CleanView* cleanView() { return m_clean.get(); }
    NotesWindow* notes() { return m_notes.get(); }

signals:
    void cueAsked(int cue);
    void cancelAsked();  // of the scene that is being read
    void ended();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void place();
    void magnify();
    void restoreScales();

    Document& m_document;
    CueModel& m_cues;
    const SceneOpener& m_opener;
    QWidget& m_window;
    std::unique_ptr<CleanView> m_clean;
    std::unique_ptr<NotesWindow> m_notes;
    bool m_swapped = false, m_changesWindow = false;
    double m_scale = 1;                  // of the letters, while it lasts
    std::map<ThemeId, double> m_scales;  // the user's, of the themes that have been in force
};

}  // namespace app
