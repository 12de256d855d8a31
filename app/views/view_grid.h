#pragma once
#include <QWidget>
#include <optional>

#include "app/views/view_set.h"

namespace app {

// The views of a tree in rows and columns, as many as there is room for; the last ones are not shown. The decisions are
// ViewTree's: here its leaves become frames, its rows and columns splitters.
class ViewGrid : public QWidget {
    Q_OBJECT
public:
    ViewGrid(Document& document, ViewDress dress, QWidget* parent);

    ViewSet& views() { return m_views; }
    const ViewSet& views() const { return m_views; }
    const lessons::ViewTree& tree() const { return m_tree; }    // as it was asked for
    const lessons::ViewTree& shown() const { return m_shown; }  // what of it there is room for
    void setTree(lessons::ViewTree tree);
    // This view in the whole room. Without one the others come back to their places, as they do with another tree.
    void setAlone(std::optional<lessons::ViewLeaf> leaf);
    std::size_t withoutRoom() const;  // views that are not shown, because they would be too small
    bool hasRoomFor(const lessons::ViewTree& tree) const;
    int gap() const;  // between views, in pixels
    void applyTheme();

signals:
    void treeChanged(const lessons::ViewTree& before);
    void changed();                   // the tree, its shares, or the room for it
    void rebuilt();                   // other views are on show
    void missing(std::size_t views);  // before the views are laid out: so many have no room

protected:
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void layOut();
    void rebuild();
    QWidget* build(const lessons::ViewTree& tree);
    void setShares(QWidget* part, const lessons::ViewTree& tree);
    void readShares(const QWidget* part, lessons::ViewTree& tree) const;
    void takeShares();
    lessons::ViewSize room() const { return {width(), height()}; }

    ViewSet m_views;
    QWidget* m_root = nullptr;  // what fills it: a splitter, or the frame of a single view
    lessons::ViewTree m_tree, m_shown;
    std::optional<lessons::ViewLeaf> m_alone;
    bool m_laysOut = false;
};

}  // namespace app
