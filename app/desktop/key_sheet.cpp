#include "app/desktop/key_sheet.h"

#include <QGridLayout>
#include <QLabel>

#include "app/desktop/actions.h"
#include "app/desktop/panel_table.h"
#include "app/panels/follow_theme.h"

namespace app {
namespace {

struct ViewKey {
    const char *region, *what, *keys;
};
// Keys that a view handles itself, while it has the focus.
constexpr ViewKey kViewKeys[]{
    {"Stages", "The card beside", "← →"},
    {"Stages", "Go to the stage", "Enter"},
    {"In a buffer", "Move the picked pixel by 1, by 10", "arrows, Shift"},
    {"In a buffer", "Zoom to the cursor", "wheel"},
    {"In a buffer", "Move the picture", "drag"},
    {"In a buffer", "Condition over all pixels", "/"},
    {"In a buffer", "Show B, or the previous stage", "hold Shift, `"},
    {"In a buffer", "A and B: blink, wipe, difference", "T, W, D"},
    {"In the 3D view", "Turn", "drag"},
    {"In the 3D view", "Nearer, farther", "wheel"},
    {"On a slider", "One step, ten steps", "arrows, Page"},
};

QLabel* makeLabel(const QString& text, const char* kind, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    const QString is = kind;
    if (is == "what") label->setProperty("tone", 2);
    followTheme(label, [label, is] {
        const Theme& theme = Theme::current();
        label->setFont(is == "heading" ? theme.text(13, 600) : is == "keys" ? theme.mono(12) : theme.text(13));
        label->setContentsMargins(0, is == "heading" ? theme.px(8) : 0, is == "what" ? theme.px(16) : 0, 0);
    });
    return label;
}

}  // namespace

KeySheet::KeySheet(const Actions& actions, QWidget* window) : Popover(window) {
    setObjectName("keySheet");
    setAccessibleName(tr("Keys"));
    auto* columns = new QHBoxLayout(this);
    QGridLayout* grid = nullptr;
    QString region;
    int row = 0, inColumn = 0;
    const auto add = [&](const QString& place, const QString& what, const QString& keys) {
        if (!grid || (place != region && inColumn > 18)) {
            if (grid) grid->setRowStretch(row, 1);
            grid = new QGridLayout;
            columns->addLayout(grid);
            row = inColumn = 0;
        }
        if (place != region) grid->addWidget(makeLabel(place, "heading", this), row++, 0, 1, 2);
        region = place;
        grid->addWidget(makeLabel(what, "what", this), row, 0);
        grid->addWidget(makeLabel(keys, "keys", this), row++, 1, Qt::AlignRight);
        ++inColumn;
    };
    for (const ActionRow& entry : actionTable()) {
        const QAction* action = actions[entry.id];
        if (!action->shortcut().isEmpty())
            add(QString(entry.menu).section('/', 0, 0), action->text(), keysText(*action));
    }
    for (const PanelRow& panel : panelTable()) add("Panels", panel.title, panel.keys);
    for (const ViewKey& key : kViewKeys) add(key.region, key.what, key.keys);
    grid->setRowStretch(row, 1);
    followTheme(this, [this, columns] {
        const Theme& theme = Theme::current();
        columns->setContentsMargins(theme.px(24), theme.px(12), theme.px(24), theme.px(20));
        columns->setSpacing(theme.px(36));
        for (int i = 0; i < columns->count(); ++i)
            static_cast<QGridLayout*>(columns->itemAt(i)->layout())->setVerticalSpacing(theme.px(4));
    });
}

}  // namespace app
