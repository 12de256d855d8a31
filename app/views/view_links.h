#pragma once
#include <QObject>
#include <optional>

#include "lessons/state/linked_views.h"

namespace app {

class ActiveView;
class BufferView;
class ViewGrid;

// The link between buffer views: those of pictures of the same size zoom and move together, as the arrangement has it or
// the user has chosen.
class ViewLinks : public QObject {
    Q_OBJECT
public:
    ViewLinks(const ViewGrid& grid, const ActiveView& active);

    void add(BufferView& view);
    bool isOn() const;
    void set(bool on);  // by the user: the others go to where the active view is
    const std::optional<bool>& chosen() const { return m_chosen; }  // nothing: as the arrangement has it
    void choose(std::optional<bool> chosen) { m_chosen = chosen; }  // and no view moves
    void stay() { m_leadsSoon = false; }                            // after a state that says where each view is

signals:
    void changed();

private:
    lessons::LinkedPicture pictureIn(BufferView& view) const;
    void lead(BufferView& view);  // the others go to where it is
    void join(BufferView& view);  // it goes to where another one is
    void leadSoon();
    void agreeSoon();  // on one zoom, where a state has one for views that have become larger by different factors

    const ViewGrid& m_grid;
    const ActiveView& m_active;
    std::optional<bool> m_chosen;
    bool m_leadsSoon = false, m_agreesSoon = false;
};

}  // namespace app
