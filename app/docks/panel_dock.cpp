#include "app/docks/panel_dock.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QToolButton>

#include "app/docks/panel_table.h"
#include "app/look/icons.h"
#include "app/widgets/follow_theme.h"
#include "app/widgets/tab_order.h"

namespace app {

PanelDock::PanelDock(const PanelRow& row, QWidget* content, QWidget* parent)
    : QDockWidget(tr(row.title), parent), m_row(row) {
    setObjectName(row.name);
    setFeatures(DockWidgetMovable | DockWidgetFloatable | DockWidgetClosable);
    // Qt's own would close one that is behind another tab.
    disconnect(toggleViewAction(), &QAction::triggered, this, nullptr);
    connect(toggleViewAction(), &QAction::triggered, this, &PanelDock::toggle);
    toggleViewAction()->setShortcut(QKeySequence(row.keys));
    toggleViewAction()->setIcon(app::icon(row.icon));
    auto* bar = new QWidget(this);
    m_heading = new QHBoxLayout(bar);
    auto* name = new QLabel(windowTitle(), bar);
    m_heading->addWidget(name);
    m_heading->addStretch(1);
    setTitleBarWidget(bar);

    // The content keeps off the dock's border and round corners.
    auto* body = new QWidget(this);
    auto* column = new QVBoxLayout(body);
    column->setContentsMargins(1, 0, 1, 4);
    column->addWidget(content);
    setWidget(body);
    followTheme(this, [this, bar, name] {
        const Theme& theme = Theme::current();
        bar->setFixedHeight(theme.px(32));
        m_heading->setContentsMargins(theme.px(12), 0, theme.px(6), 0);
        m_heading->setSpacing(theme.px(4));
        name->setFont(theme.text(13, 600));
        name->setFixedHeight(theme.px(32));  // the dock asks the heading for its hint alone
        update();
    });
}

// One behind another tab is visible, at a place that nobody sees.
bool PanelDock::isInFront() const { return isVisible() && !visibleRegion().isEmpty(); }

void PanelDock::toggle() {
    if (isInFront()) {
        close();
    } else {
        show();
        raise();
        // The keys go where the eye goes: to the panel, at its first control.
        if (const auto controls = tabOrder(*widget()); !controls.isEmpty())
            controls.front()->setFocus(Qt::ShortcutFocusReason);
    }
    toggleViewAction()->setChecked(!isHidden());  // the click has turned it over
}

void PanelDock::addButton(QAction* action, const QString& icon) {
    auto* button = new QToolButton(titleBarWidget());
    button->setDefaultAction(action);
    button->setIcon(app::icon(icon));
    button->setToolButtonStyle(Qt::ToolButtonIconOnly);
    button->setAccessibleName(action->text());
    connect(action, &QAction::changed, button, [button, icon] { button->setIcon(app::icon(icon)); });
    m_heading->addWidget(button);
    // It shows no words: those of undo, which change with every value of a drag, must not lay the window out anew.
    followTheme(button, [button] { button->setFixedSize(button->sizeHint()); });
}

void PanelDock::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::current();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), theme.colors().bg);
    painter.setBrush(theme.colors().surface);
    painter.setPen(QPen(theme.colors().line, 1));
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), theme.px(6), theme.px(6));
    const int y = titleBarWidget()->geometry().bottom();
    painter.drawLine(1, y, width() - 2, y);
}

}  // namespace app
