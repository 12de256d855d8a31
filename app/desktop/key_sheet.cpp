#include "app/desktop/key_sheet.h"

#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QScrollBar>
#include <algorithm>
#include <memory>

#include "app/commands/actions.h"
#include "app/docks/panel_table.h"
#include "app/look/word_match.h"
#include "app/widgets/follow_theme.h"

namespace app {
namespace {

struct ViewKey {
    const char *region, *what, *keys;
};
// Keys that a view handles itself, while it has the focus.
constexpr ViewKey kViewKeys[]{
    {"Anywhere", "Cancel what takes long", "Esc"},
    {"Stages", "The card beside", "← →"},
    {"Stages", "Go to the stage", "Enter"},
    {"In a buffer", "Pick a pixel; while moving", "click; Ctrl+drag"},
    {"In a buffer", "Move the picked pixel by 1, by 10", "arrows, Shift"},
    {"In a buffer", "Zoom to the cursor, move", "wheel, drag"},
    {"In a buffer", "Nearer, farther, fit", "+, −, F"},
    {"In a buffer", "Loupe", "Z"},
    {"In a buffer", "Red, green, blue alone; all", "R, G, B; C"},
    {"In a buffer", "Luminance", "L"},
    {"In a buffer", "Fit the range once, always", "N, Shift+N"},
    {"In a buffer", "Histogram logarithmic or linear", "Shift+L"},
    {"In a buffer", "Show B, or the previous stage", "hold Shift, `"},
    {"In a buffer", "A and B: blink, wipe, difference", "T, W, D"},
    {"In a buffer", "Pin the picked pixel; take all away", "P; Shift+P"},
    {"In a buffer", "Go to a pin", "1 … 9"},
    {"In a buffer", "Measure a region", "right drag, M"},
    {"In a buffer", "Row 0 at the bottom", "Y"},
    {"In a buffer", "Condition over all pixels", "/"},
    {"In the 3D view", "Pick a point", "click"},
    {"In the 3D view", "Turn", "drag, arrows"},
    {"In the 3D view", "Nearer, farther; move", "wheel; middle drag"},
    {"In the 3D view", "Front, side, top, from a corner", "1, 3, 7, 9"},
    {"In the 3D view", "From the scene's eye; everything", "0; A"},
    {"In the 3D view", "Parallel lines", "5"},
    {"In the 3D view", "Next space, the one before", "S, Shift+S"},
    {"In the 3D view", "Face of a point light", "F, Shift+F"},
    {"In the 3D view", "Out of the scene's eye", "Z"},
    {"In the 3D view", "Move, turn or scale with the ring", "M"},
    {"In the 3D view", "Along an axis, during a drag", "X, Y, Z"},
    {"In the inspector", "From symbol to symbol; open", "arrows; Enter"},
    {"In the inspector", "Gain of a term; none, four times", "← →; Home, End"},
    {"In a table", "Copy the rows", "Ctrl+C"},
    {"On a slider", "One step, ten steps", "arrows, Page"},
    {"In the clean view", "Black, white", "B, W"},
    {"In the clean view", "Pen, spotlight", "P, O"},
    {"In the clean view", "One view, all views", "1, 2"},
    {"In the clean view", "Swap the screens, leave", "F4, Esc"},
    {"In the clean view", "All these keys", "H"},
};

QLabel* makeLabel(const QString& text, const char* kind, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    const QString is = kind;
    if (is == "what") label->setProperty("tone", 2);
    const Theme& theme = Theme::current();
    label->setFont(is == "heading" ? theme.text(13, 600) : is == "keys" ? theme.mono(12) : theme.text(13));
    label->setContentsMargins(0, is == "heading" ? theme.px(8) : 0, is == "what" ? theme.px(16) : 0, 0);
    return label;
}

// Columns of so many rows; a region that goes on in the next one is named there again.
std::unique_ptr<QWidget> page(const std::vector<KeyRow>& rows, int inColumn) {
    auto page = std::make_unique<QWidget>();
    const Theme& theme = Theme::current();
    auto* columns = spaced(new QHBoxLayout(page.get()), {8, 0, 8, 8}, 36);
    QGridLayout* grid = nullptr;
    int row = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const bool isNew = i % std::size_t(inColumn) == 0;
        if (isNew) {
            if (grid) grid->setRowStretch(row, 1);
            columns->addLayout(grid = new QGridLayout);
            grid->setVerticalSpacing(theme.px(4));
            row = 0;
        }
        if (isNew || rows[i].region != rows[i - 1].region)
            grid->addWidget(makeLabel(rows[i].region, "heading", page.get()), row++, 0, 1, 2);
        grid->addWidget(makeLabel(rows[i].what, "what", page.get()), row, 0);
        grid->addWidget(makeLabel(rows[i].keys, "keys", page.get()), row++, 1, Qt::AlignRight);
    }
    if (grid) grid->setRowStretch(row, 1);
    columns->addStretch(1);
    return page;
}

}  // namespace

std::vector<KeyRow> rowsWith(const std::vector<KeyRow>& rows, const QString& typed) {
    std::vector<KeyRow> found;
    std::ranges::copy_if(rows, std::back_inserter(found), [&](const KeyRow& row) {
        return matchWords(typed, row.region + ' ' + row.what + ' ' + row.keys) != WordMatch::None;
    });
    return found;
}

KeySheet::KeySheet(const Actions& actions, QWidget* window)
    : Popover(window), m_actions(actions), m_field(new QLineEdit(this)), m_scroll(new QScrollArea(this)) {
    setObjectName("keySheet");
    setAccessibleName(tr("Keys"));
    m_field->setPlaceholderText(tr("Find a key, or what it does"));
    m_field->setAccessibleName(m_field->placeholderText());
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scroll->setWidgetResizable(true);
    m_scroll->setFocusPolicy(Qt::NoFocus);
    auto* column = spaced(new QVBoxLayout(this), {16, 12, 8, 12});
    column->addWidget(m_field);
    column->addWidget(m_scroll, 1);
    connect(m_field, &QLineEdit::textChanged, this, &KeySheet::filter);
    followTheme(this, [this] {
        const Theme& theme = Theme::current();
        m_field->setFont(theme.text(15));
        m_field->setMinimumHeight(theme.px(30));
        if (isVisible()) open();
    });
}

std::vector<KeyRow> KeySheet::rows() const {
    std::vector<KeyRow> rows;
    for (const auto& [id, entry] : m_actions.rows()) {
        const QAction* action = m_actions[id];
        const QString region = QString(entry.menu).section('/', 0, 0);
        if (id == ActionId::Bookmark1)
            rows.push_back({region, tr("Bookmark 1 to 9"), "Ctrl+1 … Ctrl+9"});
        else if (!action->shortcut().isEmpty() && QString(entry.menu) != "Run/Bookmarks")
            rows.push_back({region, action->text(), keysText(*action)});
    }
    for (const PanelRow& panel : panelTable()) rows.push_back({tr("Panels"), panel.title, panel.keys});
    for (const ViewKey& key : kViewKeys) rows.push_back({key.region, key.what, key.keys});
    return rows;
}

// As large as all keys need, where there is room; what is typed then does not move it.
void KeySheet::open() {
    m_rows = rows();
    const Theme& theme = Theme::current();
    const QSize room = parentWidget()->size() - QSize(theme.px(80), theme.px(160));
    const int wide = page(m_rows, int(m_rows.size()))->sizeHint().width();
    const int columns = std::clamp(room.width() / wide, 1, 4);
    m_inColumn = (int(m_rows.size()) + columns - 1) / columns;
    m_field->clear();
    filter();
    const QSize bar(m_scroll->verticalScrollBar()->sizeHint().width(), 0);
    m_scroll->setMinimumSize((m_scroll->widget()->sizeHint() + bar).boundedTo(room));
    Popover::open(m_field);
}

void KeySheet::filter() {
    m_shown = rowsWith(m_rows, m_field->text());
    m_scroll->setWidget(page(m_shown, m_inColumn).release());
}

}  // namespace app
