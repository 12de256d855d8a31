#include "app/tables/tables_panel.h"

#include <QTabBar>
#include <algorithm>

#include "app/widgets/elided_label.h"
#include "app/widgets/follow_theme.h"

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
    m_facts = new ElidedLabel(this);
    m_facts->setObjectName("factsBesideTabs");
    m_facts->setProperty("tone", "2");
    m_facts->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    for (int i = 0; i < count(); ++i)
        connect(static_cast<TablePage*>(widget(i)), &TablePage::factsChanged, this, &TablesPanel::placeFacts);
    connect(this, &QTabWidget::currentChanged, this, &TablesPanel::placeFacts);
    followTheme(this, [this] {
        tabBar()->setFont(Theme::current().text(13));
        m_facts->setFont(Theme::current().mono(12));
        placeFacts();
    });
}

void TablesPanel::resizeEvent(QResizeEvent* event) {
    QTabWidget::resizeEvent(event);
    placeFacts();
}

// A low panel has them beside the tabs: the rows need their line.
void TablesPanel::placeFacts() {
    const bool isLow = height() < Theme::current().px(230);
    auto* page = static_cast<TablePage*>(currentWidget());
    for (int i = 0; i < count(); ++i) static_cast<TablePage*>(widget(i))->setShowsFacts(!isLow);
    m_facts->setText(isLow ? page->facts() : QString());
    m_facts->setToolTip(m_facts->text());
    m_facts->setVisible(isLow);
    const QRect tabs = tabBar()->geometry();
    const int left = tabs.left() + tabBar()->sizeHint().width() + Theme::current().px(16);
    m_facts->setGeometry(left, tabs.top(), std::max(0, width() - left - Theme::current().px(12)), tabs.height());
    m_facts->raise();
}

QSize TablesPanel::sizeHint() const { return {Theme::current().px(600), Theme::current().px(240)}; }

// The headings and some rows: a dock that gets less shows nothing worth a look.
QSize TablesPanel::minimumSizeHint() const { return {QTabWidget::minimumSizeHint().width(), Theme::current().px(172)}; }

}  // namespace app
