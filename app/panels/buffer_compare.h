#pragma once
#include <QObject>
#include <QTimer>
#include <optional>

#include "app/core/derived_job.h"
#include "app/core/difference_job.h"
#include "app/core/document.h"
#include "app/core/other_frame.h"
#include "app/core/other_source.h"
#include "app/panels/compare_bar.h"
#include "app/panels/show_job.h"
#include "app/panels/wipe.h"
#include "lessons/state/window_state.h"

class QMenu;

namespace app {

class BufferCanvas;

// "12 of 2 686 pixels differ, most by 0.5 at 268, 281".
QString findingText(const pipeline::BufferDifference& found);

// Compares what a buffer view shows, A, with something else, B: finds B, has it computed, shows one,
// the other, both or their difference, and says how much they differ.
class BufferCompare : public QObject {
    Q_OBJECT
public:
    // window: what the bar stands in.
    BufferCompare(Document& document, BufferCanvas* canvas, QWidget* window);

    CompareBar* bar() { return m_bar; }
    const std::optional<OtherSource>& source() const { return m_source; }
    void compareWith(std::optional<OtherSource> source);  // nothing: no longer
    bool isOn() const { return current().has_value(); }   // the pictures bear names of their own
    bool isMine() const { return m_source && m_source->kind == OtherSource::Kind::Mine; }
    CompareMode mode() const { return m_mode; }
    void setMode(CompareMode mode);  // the same again: back to A
    void setMetric(pipeline::DifferenceMetric metric);
    // What B is and how the two are shown, and the same again; nothing: no B. "Before the last change" is kept as the
    // setting that the change has changed, where it is one: later it is another change. Errors: no such B.
    std::optional<lessons::BufferShown::Compared> state() const;
    pipeline::Errors lookAt(const std::optional<lessons::BufferShown::Compared>& state);
    void holdOther(bool held);     // shows B meanwhile
    void holdPrevious(bool held);  // shows the stage before meanwhile, whatever B is
    void goToWorst();
    void fillMenu(QMenu& menu, const pipeline::BufferName& shown);  // with what B can be

    // Whether the view shows B, or what differs, at all.
    bool showsOther() const { return showsDifference() || (m_b && wipe().share < 1); }
    bool showsDifference() const { return m_mode == CompareMode::Difference && m_found.has_value(); }
    std::optional<pipeline::PaletteRange>& range() { return m_range; }  // the user's, of the difference
    // Lays B beside what a view asks for, where there is one.
    void addOther(ShowRequest& request);
    // What the view shows in place of A: A itself, or the difference. Tells the canvas about B.
    ShownBuffer show(const ShowAnswer& answer);
    bool busy() const { return m_showing.busy(); }  // the picture of a difference is being made
    void cancel() { m_showing.cancel(); }
    void retry() { m_showing.retry(); }
    bool waitsForB() const { return m_other.busy() || m_derived.busy(); }
    // What stands behind A's value at a pixel: B's, or nothing.
    QString readout(QPoint pixel) const;
    const std::optional<pipeline::BufferDifference>& found() const { return m_found; }
    const pipeline::FramePtr& otherFrame() const { return m_frameB; }
    const std::optional<pipeline::AnyBuffer>& otherFile() const { return m_file; }  // what a file has, once it is read
    QString why() const { return m_why; }  // there is no B, or it cannot be compared; else empty

signals:
    void changed();  // the view is to be shown anew
    void busyChanged(bool busy);
    void chosen();  // in the menu: the view that shows it takes the keys
    void stagesChosen();

private:
    void observeWork();
    std::optional<OtherSource> current() const;  // what is held wins
    std::optional<pipeline::AnyBuffer> findOther(const pipeline::FramePtr& frame, const pipeline::AnyBuffer& a);
    // Null where none is to be seen, or none has come yet.
    std::shared_ptr<const ShowAnswer> shownDifference(const pipeline::FramePtr& frame);
    void forgetDifference();
    std::optional<pipeline::AnyBuffer> findDerived(const pipeline::BufferName& name, bool isOwn);
    void nameDifference(const pipeline::Scene& a, const pipeline::Scene& b);
    QString differenceName() const;
    Wipe wipe() const;
    void tell();
    QString whyNotYet() const;
    void chooseFile();

    Document& m_document;
    BufferCanvas* m_canvas;
    CompareBar* m_bar;
    OtherScene m_otherScene;
    OtherFrame m_other;
    DerivedJob m_derived;  // B, of another frame
    DifferenceJob m_difference;
    ShowJob m_showing;  // the difference
    QTimer m_blink;
    std::optional<OtherSource> m_source;
    CompareMode m_mode = CompareMode::A;
    pipeline::DifferenceMetric m_metric = pipeline::DifferenceMetric::Error;
    double m_share = 0.5;
    bool m_holdsOther = false, m_holdsPrevious = false, m_blinksToB = false;
    bool m_goesToWorst = false;  // once it is found
    std::optional<pipeline::PaletteRange> m_range;

    pipeline::FramePtr m_frameB;
    std::optional<pipeline::AnyBuffer> m_a, m_b, m_file;
    std::optional<pipeline::BufferDifference> m_found;
    pipeline::FramePtr m_foundFrame;  // that m_found is of, which may lag behind
    lessons::ShownChannel m_channel = lessons::ShownChannel::All;
    QString m_nameA, m_nameB;
    QString m_why;  // why there is no B, or no difference
};

}  // namespace app
