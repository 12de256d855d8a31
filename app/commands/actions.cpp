#include "app/commands/actions.h"

#include <QActionGroup>
#include <QMenu>
#include <utility>

namespace app {

Actions::Actions(QWidget* window, std::function<bool()> hasScene)
    : QObject(window), m_window(window), m_hasScene(std::move(hasScene)) {}

void Actions::add(ActionRow row) {
    auto* action = new QAction(tr(row.text), this);
    action->setShortcuts(QKeySequence::listFromString(row.keys));
    action->setCheckable(bool(row.isOn));
    action->setMenuRole(QAction::NoRole);
    if (row.within) action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    (row.within ? row.within : m_window)->addAction(action);
    connect(action, &QAction::triggered, this, [this, run = row.run] {
        run();
        refresh();
    });
    m_actions[row.id] = action;
    m_rows.emplace(row.id, std::move(row));
}

void Actions::addChoices(std::vector<ActionRow> rows) {
    auto* group = new QActionGroup(this);
    for (ActionRow& row : rows) {
        const ActionId id = row.id;
        add(std::move(row));
        group->addAction(m_actions[id]);
    }
}

QList<QAction*> Actions::inTalk() const {
    QList<QAction*> found;
    for (const auto& [id, row] : m_rows)
        if (row.inTalk) found += m_actions.at(id);
    return found;
}

void Actions::fillMenus(QMenuBar& bar) {
    for (const auto& [id, row] : m_rows) {
        const QString path = row.menu;
        const qsizetype slash = path.indexOf('/');
        const QString top = path.left(slash);
        QMenu*& menu = m_menus[top];
        if (!menu) {
            // By its first letter with Alt; "Alt+R" is the equation in red.
            menu = bar.addMenu(top == "Run" ? tr("R&un") : '&' + tr(qPrintable(top)));
            menu->setToolTipsVisible(true);
        }
        QMenu* place = menu;
        if (row.startsGroup) menu->addSeparator();
        if (slash > 0) {
            QMenu*& sub = m_menus[path];
            if (!sub) sub = m_menus[top]->addMenu(tr(qPrintable(path.mid(slash + 1))));
            place = sub;
        }
        place->addAction(m_actions.at(id));
    }
    emit menusFilled();
}

QString Actions::whyNot(ActionId id) const {
    const ActionRow& row = m_rows.at(id);
    if (row.needsScene && !m_hasScene()) return tr("Open a scene first.");
    return row.whyNot ? row.whyNot() : QString();
}

void Actions::refresh() {
    for (const auto& [id, row] : m_rows) update(row);
}

void Actions::update(const ActionRow& row) {
    QAction& action = *m_actions.at(row.id);
    const QString why = whyNot(row.id);
    action.setEnabled(why.isEmpty());
    action.setToolTip(why.isEmpty() ? tr(row.tip) : why);
    if (row.isOn) action.setChecked(row.isOn());
    if (row.name) action.setText(row.name());
}

QString keysText(const QAction& action) {
    QStringList keys;
    for (const QKeySequence& one : action.shortcuts()) keys += one.toString(QKeySequence::PortableText);
    QString text = keys.join(Actions::tr(" or "));
    text.replace("Left", "←").replace("Right", "→");
    return text;
}

}  // namespace app
