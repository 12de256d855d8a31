#pragma once
#include <QTabWidget>

#include "app/tables/table_page.h"

namespace app {

class ElidedLabel;

// Lecture 1's arrays: objects, polygons, vertices and lights of the frame on show.
class TablesPanel : public QTabWidget {
    Q_OBJECT
public:
    explicit TablesPanel(Document& document, QWidget* parent = nullptr);
    TablePage& page(pipeline::TableId table) { return *static_cast<TablePage*>(widget(int(table))); }
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void placeFacts();

    ElidedLabel* m_facts;
};

}  // namespace app
