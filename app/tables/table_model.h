#pragma once
#include <QAbstractTableModel>
#include <cstdint>
#include <optional>
#include <vector>

#include "pipeline/inspect/table_text.h"

namespace app {

// A scene table as an item model. It reads only the cells that are displayed. Sorting keeps an order of rows and does
// not change the table.
class TableModel : public QAbstractTableModel {
    Q_OBJECT
public:
    explicit TableModel(QObject* parent = nullptr);

    // Columns, rows and order are kept if the new table has as many of them under the same names.
    void setTable(pipeline::SceneTable table);
    void clear();
    const pipeline::SceneTable& table() const { return m_table; }

    // The row at a place in the sorted order, and the inverse.
    std::uint32_t rowAt(int place) const {
        return m_order.empty() ? std::uint32_t(place) : m_order[std::size_t(place)];
    }
    int placeOf(std::uint32_t row) const;
    // Highlighted rows in ascending order: the object under the cursor in another view.
    void setPointed(std::vector<std::uint32_t> rows);
    const std::vector<std::uint32_t>& pointed() const { return m_pointed; }
    // The rows at these places as text with headings, in the displayed order.
    QString text(std::vector<int> places, pipeline::TableFormat format) const;
    // Why columns are empty: "N x, N y: Flat shading needs polygon normals only."
    QString remarks() const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    // Column -1: the table's own order.
    void sort(int column, Qt::SortOrder order) override;

private:
    bool isNumeric(int column) const;

    pipeline::SceneTable m_table;
    std::vector<std::uint32_t> m_order;  // row at each place; empty: the table's own order
    std::vector<std::uint32_t> m_pointed;
    std::vector<bool> m_numeric;  // per column
    int m_sorted = -1;
    Qt::SortOrder m_direction = Qt::AscendingOrder;
};

}  // namespace app
