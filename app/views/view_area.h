#pragma once
#include <QWidget>

#include "app/document/document.h"
#include "app/views/active_view.h"
#include "app/views/stage_in_views.h"
#include "app/views/view_edits.h"
#include "app/views/view_grid.h"
#include "app/views/view_links.h"
#include "app/views/view_menu.h"
#include "lessons/state/window_state.h"

class QLabel;

namespace app {

class ThumbnailStrip;

// The middle of the window: buffer views and 3D views in any arrangement, and the buffers small below. It puts its parts
// together, each a class of its own, and takes a state of the window to them. A view that is not on show computes nothing.
class ViewArea : public QWidget {
    Q_OBJECT
public:
    explicit ViewArea(Document& document, QWidget* parent = nullptr, ViewDress dress = ViewDress::Full);

    ViewGrid& grid() { return *m_grid; }
    const ViewGrid& grid() const { return *m_grid; }
    ActiveView& active() { return m_active; }
    ViewLinks& links() { return m_links; }
    ViewEdits& edits() { return m_edits; }

    // The arrangement as a state stores it: its name, or its text.
    std::string arrangement() const { return arrangementText(m_grid->tree()); }
    bool setArrangement(const std::string& nameOrText);  // false where it is neither
    bool hasSecond() const;                              // buffer view
    void setSecond(bool shown);                          // between "one" and "two"
    void setAlone(bool alone);                           // the active view in the whole room
    bool hasThumbnails() const;
    void setThumbnails(bool shown);

    void setHeld(bool held);  // the buffer views on show, as BufferHolds has it

    void showBuffer(const pipeline::BufferName& buffer);                 // in the active buffer view
    void showBuffers(const std::vector<pipeline::BufferName>& buffers);  // one in each view, as far as they go
    // Saves the views into a state; restores them from one, with an error for each name that the scene no longer has.
    void fill(lessons::WindowState& state) const;
    pipeline::Errors lookAt(const lessons::WindowState& state);

    // The first views on show, else those that were there first.
    BufferView& first() const;
    BufferView& second();
    View3dPanel& view3d() const;
    // In the order of a state; at least one of each kind.
    std::vector<BufferView*> shownBuffers() const;
    std::vector<View3dPanel*> shownSpaces() const;
    BufferView& activeBuffer() const { return m_active.buffer(); }

signals:
    void changed();              // the arrangement, its links, or which view is active
    void saveAsked(SavedAs as);  // the active view's buffer

private:
    void takeView(lessons::ViewLeaf leaf, ViewDress dress);
    void tellMissing(std::size_t count);
    void markThumbnail();
    void giveHolds();

    ViewGrid* m_grid;
    QLabel* m_missing;  // how many views have no room
    ThumbnailStrip* m_thumbnails;
    ActiveView m_active;
    ViewLinks m_links;
    StageInViews m_stage;
    ViewEdits m_edits;
    std::vector<std::string> m_sliders;  // of the state that was shown last, for the clean view
};

}  // namespace app
