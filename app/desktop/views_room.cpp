#include "app/desktop/views_room.h"

#include <QCoreApplication>
#include <QDockWidget>

#include "app/desktop/view_area.h"

namespace app {

void giveViewsRoom(QMainWindow& window, const ViewArea& views) {
    for (const Qt::DockWidgetArea area : {Qt::LeftDockWidgetArea, Qt::RightDockWidgetArea})
        for (QDockWidget* dock : window.findChildren<QDockWidget*>()) {
            if (views.withoutRoom() == 0) return;
            if (dock->isFloating() || dock->isHidden() || window.dockWidgetArea(dock) != area) continue;
            dock->hide();
            QCoreApplication::sendPostedEvents(&window, QEvent::LayoutRequest);
        }
}

}  // namespace app
