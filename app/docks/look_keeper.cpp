#include "app/docks/look_keeper.h"

#include <QEvent>

#include "app/docks/layout_store.h"
#include "app/docks/panel_docks.h"
#include "app/look/theme.h"

namespace app {
namespace {

constexpr int kSoonMs = 500;

}  // namespace

LookKeeper::LookKeeper(QObject& window, const PanelDocks& docks, std::function<void()> keepPanels,
                       std::function<bool()> isOther)
    : QObject(&window) {
    m_soon.setSingleShot(true);
    m_soon.setInterval(kSoonMs);
    connect(&m_soon, &QTimer::timeout, this, [keep = std::move(keepPanels), isOther = std::move(isOther)] {
        if (isOther()) return;
        saveTheme();
        keep();
    });
    const auto start = [this] { m_soon.start(); };
    connect(&Theme::current(), &Theme::changed, this, start);
    for (PanelDock* dock : docks.all()) {
        connect(dock, &QDockWidget::visibilityChanged, this, start);
        connect(dock, &QDockWidget::dockLocationChanged, this, start);
        connect(dock, &QDockWidget::topLevelChanged, this, start);
        dock->installEventFilter(this);
    }
}

bool LookKeeper::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize) m_soon.start();
    return QObject::eventFilter(watched, event);
}

}  // namespace app
