#pragma once
#include <QWidget>
#include <map>
#include <string>

#include "app/core/document.h"
#include "app/core/region_statistics.h"
#include "app/panels/focus_watch.h"
#include "app/panels/show_job.h"
#include "lessons/state/window_state.h"

class QLabel;
class QPushButton;
class QStackedLayout;

namespace app {

class BufferCanvas;
class BufferCompare;
class BufferHeader;
class ConditionBar;
enum class CompareMode : unsigned char;
class Loupe;
class RangeFoot;
class RegionPanel;
class ShadowOverlay;
class StageDifferences;
class WorkingBar;

// Any buffer of the document's frame, by name. The old picture stays while a new one is computed;
// a buffer that is not there is told with its reason.
class BufferView : public QWidget {
    Q_OBJECT
public:
    explicit BufferView(Document& document, QWidget* parent = nullptr);  // shows the frame buffer first

    const pipeline::BufferName& buffer() const { return m_name; }
    void setBuffer(const pipeline::BufferName& name);
    void setChannel(lessons::ShownChannel channel);
    lessons::ShownChannel channel() const;
    void autofit(bool keep);  // keep: the range follows every frame
    void setRange(pipeline::PaletteRange range);
    void setLogCounts(bool logarithmic);  // the axis of the histogram
    void setOverlay(OverlayId overlay, bool shown);
    bool hasOverlay(OverlayId overlay) const { return m_overlays[index(overlay)]; }
    void setRegion(const std::optional<Region>& region);  // whose statistics stand in the corner
    void setFlipped(bool flipped);                        // row 0 at the foot
    void setShowLoupe(bool show);
    void setBare(bool bare);  // without the header, the buffer's name over the picture
    // How the buffer is looked at, and the same again. Errors: what there is not, left out.
    lessons::BufferShown state() const;
    pipeline::Errors lookAt(const lessons::BufferShown& state);
    BufferCanvas* canvas() { return m_canvas; }
    BufferCompare& compare() { return *m_compare; }
    ConditionBar& condition() { return *m_condition; }
    ShadowOverlay& shadows() { return *m_shadows; }
    const std::optional<ShownBuffer>& shown() const { return m_shown; }
    QString whyNoValue() const;  // why copyValue() has nothing to copy; empty where it has
    void copyValue();            // of the picked pixel, to the clipboard, and says so
    void copyPicture();
    void takeKeys();          // the picture has the focus, or its header until there is one
    QString message() const;  // what stands in place of the picture; empty when there is one

signals:
    void bufferChanged(const pipeline::BufferName& name);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    // How a buffer was last looked at, kept while another one is shown.
    struct Kept {
        lessons::ShownChannel channel = lessons::ShownChannel::All;
        std::optional<pipeline::PaletteRange> range;  // nothing: fits every frame
        bool forced = false;                          // computed although the scene has no use for it
        bool logCounts = true;                        // the axis of the histogram
    };
    Kept& kept() { return m_kept[m_name.text()]; }
    std::optional<pipeline::PaletteRange>& keptRange();  // of what is seen: the buffer, or a difference
    void build();
    void observe();
    void observeOverlays();
    void observeWork();
    void want();
    void refresh();
    enum class Offer { Nothing, Compute, Cancel };  // a button below what is told
    void showMessage(const QString& text, Offer offer);
    void takeOffer();
    void tellAbsent(const pipeline::Frame& frame);
    bool isHiddenNow() const;  // until a question is answered
    void tellHidden();
    OverlaySet overlaysNow() const;
    void showPixels();
    void markSelection();
    void showEdgeFunctions();
    void observeCopies();
    void observeDerived();
    void wantDerived();
    // Nothing where there is no such buffer: then it is told why.
    std::optional<ShowRequest> request(const pipeline::FramePtr& frame);
    void tellWhyNotDerived();
    void layOver(ShowRequest& request) const;
    bool isMixed() const;
    QString withNotices(const QString& notice) const;  // of the mix, and of the shadows laid over
    void nudge(QPoint by);
    void compareBy(CompareMode mode);
    bool standsOnPicture() const;
    // On which texel of the shadow buffer on show a pixel's point falls.
    std::optional<QPoint> texelOf(std::optional<glm::ivec2> pixel) const;
    QString readout(QPoint pixel) const;
    void placeOverlays();
    void observeMarks();
    void showRegion();
    void measure();
    void togglePin();
    void goToPin(int number);
    void showPins();
    void showContent();

    Document& m_document;
    pipeline::BufferName m_name{pipeline::BufferId::Color};
    std::map<std::string, Kept> m_kept;
    ShowJob m_showing;
    pipeline::FramePtr m_frame;  // that m_shown is of
    std::optional<ShownBuffer> m_shown;
    BackgroundJob m_marking;     // what is selected, in m_frame
    bool m_fitsOnce = false;     // the range is to stay as the next picture fits it
    bool m_fitsPicture = false;  // to the next picture of the document's scene, of a state that has no zoom
    bool m_bare = false;
    bool m_missed = false;               // a refresh, while it was put away
    std::optional<QPoint> m_localHover;  // of a picture that is not the document's

    OverlaySet m_overlays;
    ShadowOverlay* m_shadows = nullptr;

    BufferHeader* m_header;
    QStackedLayout* m_stack;
    BufferCanvas* m_canvas;
    BufferCompare* m_compare;
    StageDifferences* m_stages;
    ConditionBar* m_condition;
    QWidget* m_page;
    QLabel *m_message, *m_readout, *m_notice, *m_title;
    QPushButton* m_compute;
    Offer m_offer = Offer::Nothing;
    Loupe* m_loupe;
    RangeFoot* m_foot;
    RegionPanel* m_region;
    bool m_keysWait = false;  // for the picture
    std::optional<Region> m_regionShown;
    QLabel* m_pins;
    WorkingBar* m_working;
    FocusWatch m_focus;
};

}  // namespace app
