#include "app/tables/table_model.h"

#include <algorithm>

#include <QFont>

#include "app/look/number_format.h"
#include "app/look/shown_name.h"
#include "app/look/text.h"
#include "app/look/theme.h"

namespace app {

using pipeline::Cell;
using pipeline::SceneTable;
using pipeline::TableColumn;

namespace {

bool sameShape(const SceneTable& a, const SceneTable& b) {
    return a.id == b.id && a.rows == b.rows &&
           std::ranges::equal(a.columns, b.columns, {}, &TableColumn::heading, &TableColumn::heading);
}

// By the first row that has a value: a column's values are of one kind.
bool numeric(const SceneTable& table, const TableColumn& column) {
    constexpr std::size_t kLooked = 64;
    for (std::size_t row = 0; row < std::min(table.rows, kLooked); ++row) {
        const Cell cell = column.cell(row);
        if (!std::holds_alternative<std::monostate>(cell)) return !std::holds_alternative<std::string>(cell);
    }
    return true;
}

QString shownText(const TableColumn& column, const Cell& cell) {
    const auto* single = std::get_if<float>(&cell);
    const auto* real = std::get_if<double>(&cell);
    if (single || real)
        if (const auto chosen = chosenText(single ? double(*single) : *real)) return *chosen;
    return onOneLine(readableText(column, cell));
}

}  // namespace

TableModel::TableModel(QObject* parent) : QAbstractTableModel(parent) {
    connect(&NumberStyle::current(), &NumberStyle::changed, this, [this] {
        if (m_table.rows > 0) emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
    });
}

void TableModel::setTable(SceneTable table) {
    const bool same = sameShape(table, m_table);
    if (!same) beginResetModel();
    m_table = std::move(table);
    m_numeric.clear();
    for (const TableColumn& column : m_table.columns) m_numeric.push_back(numeric(m_table, column));
    if (!same) {
        m_order.clear();
        m_sorted = -1;
        return endResetModel();
    }
    if (m_sorted >= 0) sort(m_sorted, m_direction);
    if (m_table.rows > 0) emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
}

void TableModel::clear() {
    beginResetModel();
    m_table = {};
    m_pointed.clear();
    m_order.clear();
    m_sorted = -1;
    endResetModel();
}

int TableModel::placeOf(std::uint32_t row) const {
    if (m_order.empty()) return int(row);
    return int(std::ranges::find(m_order, row) - m_order.begin());
}

void TableModel::setPointed(std::vector<std::uint32_t> rows) {
    if (rows == m_pointed) return;
    std::swap(rows, m_pointed);
    rows.insert(rows.end(), m_pointed.begin(), m_pointed.end());
    for (const std::uint32_t row : rows)
        if (row < m_table.rows)
            emit dataChanged(index(placeOf(row), 0), index(placeOf(row), columnCount() - 1), {Qt::BackgroundRole});
}

QString TableModel::text(std::vector<int> places, pipeline::TableFormat format) const {
    std::ranges::sort(places);
    std::vector<std::uint32_t> rows;
    for (const int place : places) rows.push_back(rowAt(place));
    std::string text;
    writeTable(m_table, rows, format, [&text](std::string_view piece) { text += piece; });
    return toQString(text);
}

QString TableModel::remarks() const {
    QStringList lines;
    for (std::size_t i = 0; i < m_table.columns.size();) {
        const std::string& why = m_table.columns[i].whyEmpty;
        QStringList names;
        for (; i < m_table.columns.size() && m_table.columns[i].whyEmpty == why; ++i)
            names << toQString(m_table.columns[i].heading());
        if (!why.empty()) lines << QString("%1: %2").arg(names.join(", "), toQString(why));
    }
    return lines.join('\n');
}

int TableModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : int(m_table.rows); }
int TableModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : int(m_table.columns.size());
}

bool TableModel::isNumeric(int column) const { return m_numeric[std::size_t(column)]; }

QVariant TableModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid()) return {};
    const TableColumn& column = m_table.columns[std::size_t(index.column())];
    switch (role) {
        case Qt::DisplayRole: return shownText(column, column.cell(rowAt(index.row())));
        case Qt::TextAlignmentRole:
            return int((isNumeric(index.column()) ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
        case Qt::FontRole: return Theme::current().mono(13);
        case Qt::BackgroundRole:
            return std::ranges::binary_search(m_pointed, rowAt(index.row())) ? Theme::current().colors().hover
                                                                             : QVariant();
        case Qt::ToolTipRole: {
            const Cell cell = column.cell(rowAt(index.row()));
            const QString value = onOneLine(pipeline::exactText(cell));
            if (value.isEmpty()) return toQString(column.whyEmpty);
            return value + (column.unit.empty() ? QString() : ' ' + toQString(column.unit));
        }
        default: return {};
    }
}

QVariant TableModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || section >= columnCount()) return {};
    const TableColumn& column = m_table.columns[std::size_t(section)];
    switch (role) {
        case Qt::DisplayRole: return toQString(column.heading());
        case Qt::TextAlignmentRole:
            return int((isNumeric(section) ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
        case Qt::FontRole: {  // the lecture's own words stand out
            QFont font = Theme::current().mono(13);
            font.setWeight(column.lecture.empty() ? QFont::Normal : QFont::DemiBold);
            return font;
        }
        case Qt::ToolTipRole: {
            QString text = toQString(column.meaning);
            QString also = column.heading() == column.name ? QString() : toQString(column.name);
            if (!column.unit.empty()) also += (also.isEmpty() ? QString() : QString("; ")) + toQString(column.unit);
            if (!also.isEmpty()) text += '\n' + also;
            if (!column.whyEmpty.empty()) text += '\n' + tr("Empty: %1").arg(toQString(column.whyEmpty));
            return text;
        }
        default: return {};
    }
}

void TableModel::sort(int column, Qt::SortOrder direction) {
    emit layoutAboutToBeChanged({}, QAbstractItemModel::VerticalSortHint);
    const QModelIndexList before = persistentIndexList();
    std::vector<std::uint32_t> rows;
    for (const QModelIndex& index : before) rows.push_back(rowAt(index.row()));
    m_sorted = column < columnCount() ? column : -1;
    m_direction = direction;
    m_order.clear();
    if (m_sorted >= 0) m_order = sortedRows(m_table, std::size_t(m_sorted), direction == Qt::DescendingOrder);
    // What is selected stays selected, wherever it stands now.
    std::vector<int> places(m_table.rows);
    if (!rows.empty())
        for (std::size_t place = 0; place < m_table.rows; ++place) places[rowAt(int(place))] = int(place);
    QModelIndexList after;
    for (qsizetype i = 0; i < before.size(); ++i) after << index(places[rows[std::size_t(i)]], before[i].column());
    changePersistentIndexList(before, after);
    emit layoutChanged({}, QAbstractItemModel::VerticalSortHint);
}

}  // namespace app
