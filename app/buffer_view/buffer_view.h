#pragma once
#include <QWidget>

#include "app/buffer_view/buffer_features.h"
#include "app/document/document.h"
#include "app/widgets/focus_watch.h"

class QStackedLayout;

namespace app {

class BufferCanvas;
class BufferCompare;
class BufferHeader;
class BufferPage;
class ConditionBar;
class WorkingBar;
struct Absence;

// Any buffer of the document's frame, by name: a canvas with features. It keeps the old picture while a new one is
// computed. If there is no such buffer it shows the reason.
class BufferView : public QWidget {
    Q_OBJECT
public:
    explicit BufferView(Document& document, QWidget* parent = nullptr);  // shows the frame buffer first

    const pipeline::BufferName& buffer() const { return m_name; }
    void setBuffer(const pipeline::BufferName& name);
    void setBare(bool bare);  // without the header, the buffer's name over the picture
    // Saves and restores zoom, palette and overlays. Returns an error for each name that the scene no longer has.
    lessons::BufferShown state() const;
    pipeline::Errors lookAt(const lessons::BufferShown& state);
    Document& document() const { return m_document; }
    BufferCanvas* canvas() const { return m_canvas; }
    BufferHeader& header() const { return *m_header; }
    const BufferFeatures& features() const { return m_features; }
    BufferCompare& compare() const;
    ConditionBar& condition() const;
    const std::optional<ShownBuffer>& shown() const { return m_shown; }
    const pipeline::FramePtr& frame() const { return m_frame; }  // that shown() is of
    bool isCurrent() const { return !m_showing.busy(); }         // shown() is what was asked for last
    bool isOfPixels() const;                                     // of the frame, not of a shadow buffer
    void takeKeys();          // the picture has the focus, or its header until there is one
    QString message() const;  // in place of the picture; empty when there is one
    void want();              // asks for the buffers that the view needs
    void refresh();
    void place();  // the labels over the canvas

signals:
    void bufferChanged(const pipeline::BufferName& name);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void build();
    void observe();
    void observeWork();
    std::optional<ShowRequest> request(const pipeline::FramePtr& frame);  // nothing: the page shows why
    void take(const ShowAnswer& answer);
    void showMessage(const Absence& absence);

    Document& m_document;
    pipeline::BufferName m_name{pipeline::BufferId::Color};
    ShowJob m_showing;
    pipeline::FramePtr m_frame;
    std::optional<ShownBuffer> m_shown;
    bool m_missed = false;    // a refresh, while it was put away
    bool m_keysWait = false;  // for the picture
    BufferHeader* m_header;
    QStackedLayout* m_stack;
    BufferCanvas* m_canvas;
    BufferPage* m_page;
    WorkingBar* m_working;
    BufferFeatures m_features;
    FocusWatch m_focus;
    QObject m_watch;  // of the work; gone before the features are, which a deleted view no longer asks
};

}  // namespace app
