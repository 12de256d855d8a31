#pragma once
#include <QTableView>
#include <QWidget>

#include "app/document/document.h"
#include "app/tables/table_model.h"

class QLabel;

namespace app {

// One table of the scene. Above it: facts about the whole table; below it: the reasons for empty columns. A click on a
// heading sorts; selecting a row selects its element in every view; rows are copied as text.
class TablePage : public QWidget {
    Q_OBJECT
public:
    TablePage(Document& document, pipeline::TableId table, QWidget* parent = nullptr);

    TableModel& model() { return *m_model; }
    QTableView& view() { return *m_view; }
    // Copies the chosen rows, with their headings.
    void copy(pipeline::TableFormat format);
    // What holds for the whole table, "polygons = 5": above it, unless another place shows it.
    QString facts() const;
    void setShowsFacts(bool shown);

signals:
    void factsChanged();

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void build();
    void want();      // the buffers of the columns, while the page is on show
    void refresh();   // another frame
    void markRows();  // another selection or pixel
    void fitColumns();
    void choose(int place);
    void showMenu(QPoint at);
    std::vector<int> chosenPlaces() const;

    Document& m_document;
    pipeline::TableId m_table;
    TableModel* m_model;
    QTableView* m_view;
    QLabel *m_facts, *m_remarks;
    pipeline::FramePtr m_shown;
    bool m_marks = false;  // the selection is being shown, not made
};

}  // namespace app
