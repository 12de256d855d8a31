#pragma once
#include <QString>

#include "lessons/state/view_tree.h"

namespace app {

class ActiveView;
class StageInViews;
class ViewGrid;

// How the user changes an arrangement view by view. The reasons are empty where it can be done.
class ViewEdits {
public:
    ViewEdits(ViewGrid& grid, ActiveView& active, const StageInViews& stage)
        : m_grid(grid), m_active(active), m_stage(stage) {}

    // A new view beside it (Row), or below it (Column), with a buffer that explains the stage.
    void split(lessons::ViewLeaf leaf, lessons::ViewTree::Kind direction);
    QString whyNotSplit(lessons::ViewLeaf leaf, lessons::ViewTree::Kind direction) const;
    void close(lessons::ViewLeaf leaf);
    QString whyNotClose(lessons::ViewLeaf leaf) const;
    void turn(lessons::ViewLeaf leaf);  // a buffer view into a 3D view, and back
    void makeEven();

private:
    lessons::ViewLeaf added(lessons::ViewLeaf::Kind kind) const;

    ViewGrid& m_grid;
    ActiveView& m_active;
    const StageInViews& m_stage;
};

}  // namespace app
