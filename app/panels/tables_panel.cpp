#include "app/panels/tables_panel.h"

#include <QTabBar>

#include "app/panels/follow_theme.h"

namespace app {

using pipeline::TableId;

TablesPanel::TablesPanel(Document& document, QWidget* parent) : QTabWidget(parent) {
    setObjectName("tablesPanel");
    setDocumentMode(true);
    const std::pair<TableId, QString> pages[]{{TableId::Objects, tr("Objects")},
                                              {TableId::Polygons, tr("Polygons")},
                                              {TableId::Vertices, tr("Vertices")},
                                              {TableId::Lights, tr("Lights")}};
    for (const auto& [table, title] : pages) addTab(new TablePage(document, table, this), title);
    tabBar()->setAccessibleName(tr("Tables"));
    setCurrentIndex(int(TableId::Polygons));
    followTheme(this, [this] { tabBar()->setFont(Theme::current().text(13)); });
}

QSize TablesPanel::sizeHint() const { return {Theme::current().px(600), Theme::current().px(240)}; }

}  // namespace app
