#pragma once
#include <QObject>

#include "app/widgets/focus_watch.h"
#include "lessons/state/view_tree.h"

namespace app {

class BufferView;
class ViewGrid;

// The view that the keys go to, or went to last.
class ActiveView : public QObject {
    Q_OBJECT
public:
    explicit ActiveView(ViewGrid& grid);

    lessons::ViewLeaf leaf() const;
    BufferView& buffer() const;  // the active view, or the first buffer view where the active one is a 3D view
    void goTo(lessons::ViewLeaf leaf);
    void goToNext(int step);  // 1 the next one, −1 the one before

signals:
    void focused();  // the keys went to another view
    void changed();

private:
    void takeFocus(const QWidget* now);

    ViewGrid& m_grid;
    lessons::ViewLeaf m_leaf;
    FocusWatch m_focus;
};

}  // namespace app
