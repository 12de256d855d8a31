#pragma once
#include <QTimer>
#include <QWidget>
#include <map>
#include <string>

#include "app/core/document.h"
#include "app/panels/shown_buffer.h"

class QLabel;
class QPushButton;
class QStackedLayout;

namespace app {

class BufferCanvas;
class BufferHeader;
class Loupe;
class RangeFoot;

// Any buffer of the document's frame, by name. The old picture stays while a new one is computed;
// a buffer that is not there is told with its reason.
class BufferView : public QWidget {
    Q_OBJECT
public:
    explicit BufferView(Document& document, QWidget* parent = nullptr);  // shows the frame buffer first

    const pipeline::BufferName& buffer() const { return m_name; }
    void setBuffer(const pipeline::BufferName& name);
    void setChannel(int channel);  // -1: all
    int channel() const;
    void autofit(bool keep);  // keep: the range follows every frame
    void setRange(pipeline::PaletteRange range);
    void setShowEdges(bool show);
    void setShowLoupe(bool show);
    BufferCanvas* canvas() { return m_canvas; }
    const std::optional<ShownBuffer>& shown() const { return m_shown; }
    QString message() const;  // what stands in place of the picture; empty when there is one

signals:
    void bufferChanged(const pipeline::BufferName& name);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    // How a buffer was last looked at, kept while another one is shown.
    struct Kept {
        int channel = -1;
        std::optional<pipeline::PaletteRange> range;  // nothing: fits every frame
        bool forced = false;                          // computed although the scene has no use for it
    };
    Kept& kept() { return m_kept[m_name.text()]; }
    void build();
    void observe();
    void want();
    void refresh();
    void showMessage(const QString& text, bool canCompute);
    void showPixels();
    void markSelection();
    void nudge(QPoint by);
    bool standsOnPicture() const;
    QString readout(QPoint pixel) const;
    void placeOverlays();

    Document& m_document;
    pipeline::BufferName m_name{pipeline::BufferId::Color};
    std::map<std::string, Kept> m_kept;
    std::optional<ShownBuffer> m_shown;
    std::optional<QPoint> m_localHover;  // of a picture that is not the document's

    BufferHeader* m_header;
    QStackedLayout* m_stack;
    BufferCanvas* m_canvas;
    QWidget* m_page;
    QLabel *m_message, *m_readout, *m_notice;
    QPushButton* m_compute;
    Loupe* m_loupe;
    RangeFoot* m_foot;
    QWidget* m_working;
    QTimer m_slow;
};

}  // namespace app
