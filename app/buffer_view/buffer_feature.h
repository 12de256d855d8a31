#pragma once
#include <QObject>
#include <optional>

#include "app/canvas/show_job.h"
#include "lessons/state/window_state.h"

class QKeyEvent;
class QLabel;

namespace app {

class BufferView;

// The corners of a canvas that are still free, for the labels that features lay over it. Widget pixels.
struct CanvasRoom {
    static constexpr int kMargin = 8;
    QSize size;               // of the canvas
    int bottom = 0;           // the lower left corner is free above this
    std::optional<int> left;  // the lower right corner is free right of this; nothing: all of it
    int right = 0;            // the width that is taken at the top right
};

// One thing that a buffer view can do with its picture: pins, a region, overlays, a comparison. It has its keys, its menu
// entries, what it paints and its part of the saved state. The view owns the features and calls each in turn.
class BufferFeature : public QObject {
    Q_OBJECT
public:
    explicit BufferFeature(BufferView& view);

    virtual bool press(const QKeyEvent& key);  // true: the key is the feature's. Never with Ctrl or Alt
    virtual void release(const QKeyEvent&) {}
    // Asks for what it needs, and returns the buffers of the frame that it reads.
    virtual pipeline::BufferSet want() { return {}; }
    virtual void addTo(ShowRequest&) {}  // to what the view asks for
    virtual void show() {}               // another picture is on show
    virtual void place(CanvasRoom&) {}   // its labels, and takes their room away
    virtual QString notice() const;      // rich text over the picture; empty: none
    virtual void write(lessons::BufferShown&) const {}
    virtual pipeline::Errors read(const lessons::BufferShown& state);  // the errors: what there is not
    virtual bool busy() const { return false; }                        // with what is on show
    virtual void cancel() {}
    virtual void retry() {}

signals:
    void busyChanged();

protected:
    BufferView& view() const { return m_view; }
    bool showsScene() const;  // the picture is one of the document's scene, not of the scene before it

private:
    BufferView& m_view;
};

// A label over a canvas that lets the mouse through; hidden.
QLabel* labelOver(QWidget* canvas);

}  // namespace app
