#pragma once
#include <vector>

#include "app/widgets/popover.h"

class QLineEdit;
class QScrollArea;

namespace app {

class Actions;

struct KeyRow {
    QString region, what, keys;
    bool operator==(const KeyRow&) const = default;
};
// The rows that have all words of `typed`, in any order and place.
std::vector<KeyRow> rowsWith(const std::vector<KeyRow>& rows, const QString& typed);

// The keys, by region: those of the menus from the table of actions, then those of the views. What is typed finds among
// them.
class KeySheet : public Popover {
    Q_OBJECT
public:
    KeySheet(const Actions& actions, QWidget* window);

    void open();
    const std::vector<KeyRow>& shown() const { return m_shown; }

private:
    std::vector<KeyRow> rows() const;
    void filter();

    const Actions& m_actions;
    QLineEdit* m_field;
    QScrollArea* m_scroll;
    std::vector<KeyRow> m_rows, m_shown;
    int m_inColumn = 1;
};

}  // namespace app
