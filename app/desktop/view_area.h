#pragma once
#include <QWidget>
#include <map>

#include "app/core/document.h"
#include "app/panels/focus_watch.h"
#include "lessons/state/linked_views.h"
#include "lessons/state/view_tree.h"
#include "lessons/state/window_state.h"

class QLabel;
class QMenu;

namespace app {

class BufferView;
class EvenSplitter;
class ThumbnailStrip;
class View3dPanel;

// Bare: pictures and their names alone, as an audience sees them.
enum class ViewDress : unsigned char { Full, Bare };

// The middle of the window: buffer views and 3D views in any arrangement, the buffers small below. Going to a stage shows
// the stage's main buffer in the first buffer view, and what explains it in the others of a named arrangement; in one that
// the user has made the others keep their buffers. A view that is not on show computes nothing.
class ViewArea : public QWidget {
    Q_OBJECT
public:
    enum class SavedAs : unsigned char { Files, Figure };

    explicit ViewArea(Document& document, QWidget* parent = nullptr, ViewDress dress = ViewDress::Full);

    void showBuffer(const pipeline::BufferName& buffer);                 // in the active buffer view
    void showBuffers(const std::vector<pipeline::BufferName>& buffers);  // one in each view, as far as they go

    std::size_t withoutRoom() const;  // views that are not shown, because they would be too small

    // How the views stand; where there is no room for all of them the last ones are not shown.
    const lessons::ViewTree& tree() const { return m_tree; }
    std::string arrangement() const { return lessons::arrangementText(m_tree); }
    bool setArrangement(const std::string& nameOrText);  // false where it is neither
    bool hasSecond() const;                              // buffer view
    void setSecond(bool shown);                          // between "one" and "two"
    void makeEven();
    // The active view in the whole room; the others come back to their places, or with another arrangement.
    void setAlone(bool alone);

    // Buffer views of pictures of the same size zoom and move together.
    bool isLinked() const { return areLinked(m_tree, m_kept.linked); }
    void setLinked(bool linked);

    // The view that the keys go to, or went to last.
    lessons::ViewLeaf active() const;
    void goTo(lessons::ViewLeaf leaf);
    void focusBuffer();       // the keys go to the active buffer view, else to the first
    void goToNext(int step);  // 1 the next one, −1 the one before
    // A new view beside it, or below it, with a buffer that explains the stage.
    void splitView(lessons::ViewLeaf leaf, lessons::ViewTree::Kind direction);
    void closeView(lessons::ViewLeaf leaf);
    void turnView(lessons::ViewLeaf leaf);  // a buffer view into a 3D view, and back
    // Empty where it can be done.
    QString whyNotSplit(lessons::ViewLeaf leaf, lessons::ViewTree::Kind direction) const;
    QString whyNotClose(lessons::ViewLeaf leaf) const;

    bool hasThumbnails() const;
    void setThumbnails(bool shown);
    // What the views show: into a state, and as a state has it. Errors: what there is not.
    void fill(lessons::WindowState& state) const;
    pipeline::Errors lookAt(const lessons::WindowState& state);

    // The first ones on show, else those that were there first.
    BufferView& first() const;
    BufferView& second();
    std::vector<BufferView*> shownBuffers() const;  // in the order of a state; at least one
    BufferView& activeBuffer() const;               // the active view, or the first one where that is no buffer view
    View3dPanel& view3d() const;
    QWidget* frameOf(lessons::ViewLeaf leaf) const;  // null where there is no such view

signals:
    void changed();              // the arrangement, or which view is active
    void saveAsked(SavedAs as);  // the active view's buffer

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void showStage();
    void showInside();
    std::vector<BufferView*> inOrder() const;  // those on show, then the others
    BufferView& bufferView(int number);        // made when first asked for
    View3dPanel& spaceView(int number);
    QWidget* viewOf(lessons::ViewLeaf leaf) const;
    lessons::LinkedPicture pictureIn(BufferView& view) const;
    void lead(BufferView& view);  // the others stand where it does
    void join(BufferView& view);  // stands where another one does
    void leadSoon();
    void agreeSoon();  // on one zoom, where a state has one for views that have become larger by different factors
    QWidget* framed(QWidget* view, lessons::ViewLeaf leaf);
    void addMenu(QMenu* menu, lessons::ViewLeaf leaf);
    void setTree(lessons::ViewTree tree);
    void layOut();
    void tellMissing(std::size_t count);
    QWidget* build(const lessons::ViewTree& tree);
    void setShares(QWidget* part, const lessons::ViewTree& tree);
    void readShares(const QWidget* part, lessons::ViewTree& tree) const;
    void takeShares();
    void takeFocus(const QWidget* now);
    lessons::ViewSize room() const;
    lessons::ViewSize leastView() const;
    int gap() const;

    Document& m_document;
    std::map<int, BufferView*> m_buffers;  // by their numbers; those not on show keep what they had
    std::map<int, View3dPanel*> m_spaces;
    QWidget* m_middle;
    QWidget* m_root = nullptr;  // what fills it: a splitter, or the frame of a single view
    QLabel* m_missing;          // how many views have no room
    ThumbnailStrip* m_thumbnails;
    lessons::ViewTree m_tree;   // as it was asked for
    lessons::ViewTree m_shown;  // what of it there is room for
    lessons::ViewLeaf m_active;
    ViewDress m_dress;
    bool m_laysOut = false, m_leadsSoon = false, m_agreesSoon = false, m_alone = false;
    // As the state had it that was shown last.
    struct Kept {
        std::optional<bool> linked;        // nothing: as the arrangement has it
        std::vector<std::string> sliders;  // for the clean view
    };
    Kept m_kept;
    bool m_inside = false;  // the stepper, when last looked at
    FocusWatch m_focus;
};

}  // namespace app
