#pragma once
#include "app/compare/compare_bar.h"
#include "app/compare/difference_picture.h"
#include "app/compare/other_side.h"
#include "app/compare/side_switch.h"
#include "lessons/state/window_state.h"

namespace app {

class BufferCanvas;

// Compares what a buffer view shows, A, with something else, B: shows one, the other, both or their difference, and
// says how much they differ.
class BufferCompare : public QObject {
    Q_OBJECT
public:
    // window: what the bar stands in.
    BufferCompare(Document& document, BufferCanvas* canvas, QWidget* window);

    CompareBar* bar() { return m_bar; }
    OtherSide& other() { return m_other; }
    DifferencePicture& difference() { return m_difference; }
    const std::optional<OtherSource>& source() const { return m_source; }
    void compareWith(std::optional<OtherSource> source);  // nothing: no longer
    bool isOn() const { return current().has_value(); }   // the pictures bear names of their own
    bool isMine() const { return m_source && m_source->kind == OtherSource::Kind::Mine; }
    CompareMode mode() const { return m_sides.mode(); }
    void setMode(CompareMode mode);  // the same again: back to A
    // Saves B and the mode; restores them. Nothing: no B. "Before the last change" is saved as the changed setting,
    // because a later change would be another one. Returns an error if there is no such B.
    std::optional<lessons::BufferShown::Compared> state() const;
    pipeline::Errors lookAt(const std::optional<lessons::BufferShown::Compared>& state);
    void holdOther(bool held);     // shows B meanwhile
    void holdPrevious(bool held);  // shows the stage before meanwhile, whatever B is
    void goToWorst();

    // Whether the view shows B, or what differs, at all.
    bool showsOther() const { return showsDifference() || (m_difference.hasB() && m_sides.wipe().share < 1); }
    bool showsDifference() const { return mode() == CompareMode::Difference && m_difference.found().has_value(); }
    // Adds B to the view's request, if there is a B.
    void addOther(ShowRequest& request);
    // Returns what the view shows: A, or the difference. Hands B to the canvas.
    ShownBuffer show(const ShowAnswer& answer);
    // The text after A's value at a pixel: B's value; empty without B.
    QString readout(QPoint pixel) const { return m_difference.readout(pixel, showsDifference()); }

signals:
    void changed();  // the view is to be shown anew
    void busyChanged();
    void chosen();  // in the menu: the view that shows it takes the keys
    void stagesChosen();

private:
    std::optional<OtherSource> current() const;  // what is held wins
    void nameSides(const OtherSource& source, const ShowAnswer& answer, const ShownOther* other);
    void nameDifference(const OtherSource& source, const pipeline::Scene& a, const pipeline::Scene& b);
    Wipe wipe() const;
    void tell();

    Document& m_document;
    BufferCanvas* m_canvas;
    CompareBar* m_bar;
    OtherSide m_other;
    SideSwitch m_sides;
    DifferencePicture m_difference;
    std::optional<OtherSource> m_source;
    bool m_goesToWorst = false;  // once it is found
    QString m_nameA, m_nameB;
};

}  // namespace app
