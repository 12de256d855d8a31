#pragma once
#include <QStringList>
#include <QWidget>

#include "app/core/document.h"
#include "app/state/window_state.h"

namespace app {

class BufferView;
class EvenSplitter;
class ThumbnailStrip;
class View3dPanel;

// The middle of the window: buffer views at the left, the 3D view at the right, the buffers small
// below. Going to a stage shows the stage's main buffer.
class ViewArea : public QWidget {
    Q_OBJECT
public:
    explicit ViewArea(Document& document, QWidget* parent = nullptr);

    void showBuffer(const pipeline::BufferName& buffer);  // in the first view
    // By their names, one a view; the second view appears for the second where there is room.
    void showBuffers(const QStringList& names);
    // How the views stand: "one" buffer beside the 3D view; "two", one above the other, beside it; "compare", two side by
    // side without it; "space", the 3D view alone; "buffer", one buffer alone. False where there is no such arrangement.
    std::string arrangement() const;
    bool setArrangement(const std::string& name);
    bool hasSecond() const;
    void setSecond(bool shown);  // between "one" and "two"
    // The parts' sizes, as they are kept with a layout, and the same again.
    QByteArray sizes() const;
    void restoreSizes(const QByteArray& sizes);
    bool hasThumbnails() const;
    void setThumbnails(bool shown);
    // What the views show: into a state, and as a state has it. Errors: what there is not.
    void fill(WindowState& state) const;
    pipeline::Errors lookAt(const WindowState& state);
    // Views side by side in equal parts.
    void resetSizes();

    BufferView& first() { return *m_first; }
    BufferView& second() { return *m_second; }
    View3dPanel& view3d() { return *m_view3d; }

private:
    void showStage();
    void showInside();

    Document& m_document;
    EvenSplitter* m_columns;
    EvenSplitter* m_buffers;
    BufferView* m_first;
    BufferView* m_second;
    View3dPanel* m_view3d;
    ThumbnailStrip* m_thumbnails;
    bool m_inside = false;  // the stepper, when last looked at
};

}  // namespace app
