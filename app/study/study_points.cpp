#include "app/study/study_points.h"

#include <QHeaderView>
#include <QSignalBlocker>
#include <algorithm>

#include "app/look/text.h"
#include "app/widgets/follow_theme.h"
#include "app/widgets/padded_cells.h"
#include "pipeline/export/study/study_text.h"
#include "pipeline/study/analysis_text.h"

namespace app {
namespace {

constexpr int kPoint = Qt::UserRole;

// Numbers stand at the right of their column, in the font of numbers.
QTableWidgetItem* cell(const std::string& text, bool number) {
    auto* item = new QTableWidgetItem(toQString(text));
    item->setTextAlignment((number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    if (number) item->setFont(Theme::current().mono(12));
    return item;
}

}  // namespace

StudyPoints::StudyPoints(QWidget* parent) : QTableWidget(parent) {
    setObjectName("studyPoints");
    setAccessibleName(tr("Points of the study"));
    setTabKeyNavigation(false);
    setSelectionBehavior(SelectRows);
    setSelectionMode(SingleSelection);
    setEditTriggers(NoEditTriggers);
    setShowGrid(false);
    setItemDelegate(new PaddedCells(this));
    horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    setWordWrap(false);
    setHorizontalScrollMode(ScrollPerPixel);
    verticalHeader()->hide();
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    horizontalHeader()->setHighlightSections(false);
    followTheme(this, [this] { verticalHeader()->setDefaultSectionSize(Theme::current().px(28)); });
    connect(this, &QTableWidget::currentCellChanged, this, [this](int row) {
        if (row >= 0) emit chosen(std::size_t(item(row, 0)->data(kPoint).toULongLong()));
    });
}

void StudyPoints::setStudy(const pipeline::StudyReport& report, const pipeline::StudyAnalysis& analysis) {
    const QSignalBlocker quiet(this);
    const ThemeColors& colors = Theme::current().colors();
    clear();
    QStringList head;
    for (const pipeline::SweepAxis& axis : report.axes) head << toQString(axis.label);
    m_giveWay = {int(head.size()) + 1};
    head << tr("ms") << tr("95 % interval") << toQString(analysis.choice.measure);
    const bool withLeftOut = leavesOutPixels(analysis);
    if (withLeftOut) m_giveWay.push_back(int(head.size()));
    if (withLeftOut) head << toQString(pipeline::kLeftOut);
    head << tr("Beaten by");
    setColumnCount(int(head.size()));
    setHorizontalHeaderLabels(head);
    std::vector<std::size_t> order = analysis.byTime;
    for (std::size_t i = 0; i < analysis.points.size(); ++i)
        if (!analysis.points[i].placed()) order.push_back(i);
    setRowCount(int(order.size()));
    for (int row = 0; row < rowCount(); ++row) {
        const std::size_t i = order[std::size_t(row)];
        const pipeline::PointAnalysis& point = analysis.points[i];
        int column = 0;
        for (std::size_t axis = 0; axis < report.axes.size(); ++axis)
            setItem(row, column++, cell(report.points[i].values[axis], axis == analysis.refined));
        setItem(row, column++, cell(point.time ? pipeline::timeText(*point.time) : "", true));
        setItem(row, column++, cell(pipeline::intervalText(point), true));
        setItem(row, column++, cell(pipeline::errorText(point), true));
        if (withLeftOut) setItem(row, column++, cell(point.leftOut ? pipeline::errorText(*point.leftOut) : "", true));
        auto* standing = cell(pipeline::standing(analysis, i), false);
        standing->setForeground(point.onFront() ? colors.run : point.placed() ? colors.text2 : colors.failed);
        standing->setToolTip(standing->text());
        setItem(row, column, standing);
        item(row, 0)->setData(kPoint, qulonglong(i));
    }
    horizontalHeader()->setStretchLastSection(false);
    for (int column = 0; column < columnCount(); ++column) setColumnHidden(column, false);
    resizeColumnsToContents();
    m_widths.clear(), m_least.clear();
    for (int column = 0; column < columnCount(); ++column) {
        m_widths.push_back(columnWidth(column));
        m_least.push_back(std::min(columnWidth(column), std::max(sizeHintForColumn(column), Theme::current().px(48))));
        horizontalHeaderItem(column)->setToolTip(head[column]);
    }
    // The words of the last column take what is left; their tooltip has the whole.
    m_widths.back() = m_least.back() = Theme::current().px(60);
    horizontalHeader()->setStretchLastSection(true);
    fitColumns();
}

// The plot's tips have what goes.
void StudyPoints::fitColumns() {
    int room = viewport()->width();
    for (const int width : m_widths) room -= width;
    for (const int column : m_giveWay) {
        if (column >= columnCount()) return;
        setColumnHidden(column, room < 0);
        if (room < 0) room += m_widths[std::size_t(column)];
    }
    // Then headers are cut.
    for (std::size_t column = 0; column < m_widths.size(); ++column) {
        const int less = isColumnHidden(int(column)) ? 0 : std::clamp(-room, 0, m_widths[column] - m_least[column]);
        setColumnWidth(int(column), m_widths[column] - less);
        room += less;
    }
}

void StudyPoints::resizeEvent(QResizeEvent* event) {
    QTableWidget::resizeEvent(event);
    fitColumns();
}

int StudyPoints::rowOf(std::size_t point) const {
    for (int row = 0; row < rowCount(); ++row)
        if (item(row, 0)->data(kPoint).toULongLong() == point) return row;
    return -1;
}

void StudyPoints::select(std::optional<std::size_t> point) {
    const QSignalBlocker quiet(this);
    const int row = point ? rowOf(*point) : -1;
    if (row < 0)
        clearSelection();
    else
        setCurrentCell(row, 0);
}

}  // namespace app
