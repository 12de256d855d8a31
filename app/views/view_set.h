#pragma once
#include <QObject>
#include <map>
#include <vector>

#include "lessons/state/view_tree.h"

class QMenu;
class QWidget;

namespace app {

class BufferView;
class Document;
class View3dPanel;

// Bare: pictures and their names alone, as an audience sees them.
enum class ViewDress : unsigned char { Full, Bare };

// The buffer views and 3D views of an area by their numbers, each in a frame. A view is made when it is first asked for.
// While it is not on show it keeps what it had.
class ViewSet : public QObject {
    Q_OBJECT
public:
    // `room`: the parent of the frames, which begin hidden.
    ViewSet(Document& document, QWidget& room, ViewDress dress);

    BufferView& buffer(int number);
    View3dPanel& space(int number);
    const std::map<int, BufferView*>& buffers() const { return m_buffers; }
    const std::map<int, View3dPanel*>& spaces() const { return m_spaces; }
    // Those of the tree, as they are read, then the others.
    std::vector<BufferView*> buffersFrom(const lessons::ViewTree& tree) const;
    std::vector<View3dPanel*> spacesFrom(const lessons::ViewTree& tree) const;
    // The leaves of `tree` get the numbers of views that are there: first those of `before`, then the others.
    void renumber(lessons::ViewTree& tree, const lessons::ViewTree& before) const;
    void make(lessons::ViewLeaf leaf);
    void remove(lessons::ViewLeaf leaf);

    QWidget* frameOf(lessons::ViewLeaf leaf) const;  // null where there is no such view
    std::vector<QWidget*> frames() const;
    QMenu* menuOf(lessons::ViewLeaf leaf) const;  // of its last button; the view must be there
    void giveKeys(lessons::ViewLeaf leaf);        // likewise
    lessons::ViewSize leastSize() const;          // of a frame, in pixels

signals:
    void made(lessons::ViewLeaf leaf);

private:
    void frame(QWidget* view, lessons::ViewLeaf leaf);
    void alignPictures();

    Document& m_document;
    QWidget& m_room;
    ViewDress m_dress;
    std::map<int, BufferView*> m_buffers;
    std::map<int, View3dPanel*> m_spaces;
};

}  // namespace app
