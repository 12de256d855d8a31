#pragma once
#include <QObject>
#include <QTimer>
#include <optional>

class QMainWindow;
class QToolBar;

namespace app {

class Document;
class PanelDock;
class PanelDocks;
class Presentation;
class StageStrip;
class StatusLine;
class Timeline;
class ViewArea;
class WindowCentre;

// What is around the views, from edge to edge of the window.
struct AroundViews {
    StageStrip& strip;
    QToolBar& timelineBar;
    Timeline& timeline;
    StatusLine& status;
};

// Fits the window's parts into its width: which panels are shown, how wide they are, what is compact. On the start page
// none of them is shown.
class WindowLayout : public QObject {
    Q_OBJECT
public:
    WindowLayout(QMainWindow& window, Document& document, const WindowCentre& centre, const AroundViews& around,
                 PanelDocks& docks, const Presentation& presentation);

    void showStart();
    void showViews();
    bool showsViews() const { return m_width.has_value(); }  // not the start page
    bool showsScene() const;
    bool isWide() const { return m_width == Width::Wide; }

    // The panels that a window of its width has. Panels that the user has chosen stay within a class of widths.
    enum class Fit : unsigned char { AnotherClass, Always };
    void fit(Fit when);
    void fitText();  // after the text has changed its size
    // Panels at the sides give way while views have no room. Their menu entries bring them back.
    void giveViewsRoom();
    void putBack();                               // all panels in their first places
    void keep() const;                            // where panels are, for the next scene and the next start
    void setKept(bool kept) { m_isKept = kept; }  // a lesson's choice of panels is not kept

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    void changed();     // what is shown
    void startShows();  // the start page comes next
    void fitted();      // the panels of the width are shown

private:
    enum class Width : unsigned char { Narrow, Medium, Wide };  // below 1100, below 1440, from there on
    Width widthClass() const;
    void showPanels();
    void sizePanels();
    void followAlgorithm();
    void showOneLeftDock(PanelDock* shown);
    void giveRoomTo(const PanelDock* shown);

    QMainWindow& m_window;
    Document& m_document;
    const WindowCentre& m_centre;
    ViewArea& m_views;
    AroundViews m_around;
    PanelDocks& m_docks;
    const Presentation& m_presentation;
    std::optional<Width> m_width;  // as last laid out; nothing on the start page
    double m_dockScale = 1;        // of the text size that the panels' widths are for
    bool m_isKept = true;
    QTimer m_soon;  // to keep what has changed: little is lost when the program ends by accident
};

}  // namespace app
