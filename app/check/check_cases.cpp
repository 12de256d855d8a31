#include "app/check/check_cases.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QScrollBar>
#include <QSignalBlocker>
#include <algorithm>
#include <array>

#include "app/look/text.h"
#include "app/widgets/follow_theme.h"
#include "app/widgets/padded_cells.h"

namespace app {

using pipeline::check::Case;
using pipeline::check::CaseResult;

namespace {

constexpr int kCase = Qt::UserRole;
enum Column { Id, Title, Naive, Ours, Bound, EndsIn, Verdict, kColumns };

bool breaks(const std::optional<CaseResult>& result) { return result && !result->holds; }

}  // namespace

CheckCases::CheckCases(QWidget* parent) : QTableWidget(0, kColumns, parent) {
    setObjectName("checkCases");
    setAccessibleName(tr("Stiff and extreme cases"));
    setHorizontalHeaderLabels(
        {tr("Case"), tr("Input"), tr("Naive"), tr("Ours"), tr("Bound"), tr("Outcome"), tr("Verdict")});
    for (const int column : {Naive, Ours, Bound})
        horizontalHeaderItem(column)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    setSelectionBehavior(SelectRows);
    setSelectionMode(SingleSelection);
    setEditTriggers(NoEditTriggers);
    setShowGrid(false);
    setWordWrap(false);
    setTabKeyNavigation(false);
    setItemDelegate(new PaddedCells(this));
    setHorizontalScrollMode(ScrollPerPixel);
    verticalHeader()->hide();
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    horizontalHeader()->setHighlightSections(false);
    horizontalHeader()->setSectionResizeMode(Title, QHeaderView::Stretch);
    followTheme(this, [this] {
        verticalHeader()->setDefaultSectionSize(Theme::current().px(26));
        horizontalHeader()->setMinimumSectionSize(Theme::current().px(48));
        // Case, naive, verdict, and titles of sixteen letters.
        setMinimumWidth(Theme::current().px(52 + 168 + 68 + 148) + verticalScrollBar()->sizeHint().width());
        layOut();
    });
    connect(this, &QTableWidget::currentCellChanged, this, [this](int row) {
        if (row >= 0) emit chosen(caseIn(row));
    });
    connect(this, &QTableWidget::cellDoubleClicked, this, [this](int row) { emit openAsked(caseIn(row)); });
}

// A few texts are long, and would leave no room for the titles; their tooltips have the whole. Widths that follow the
// contents would be found anew for every cell. Where there is little room, what the details say as well goes first.
void CheckCases::layOut() {
    const Theme& theme = Theme::current();
    constexpr std::array kWidths{std::pair(Id, 52),    std::pair(Naive, 168), std::pair(Verdict, 68),
                                 std::pair(Bound, 88), std::pair(EndsIn, 84), std::pair(Ours, 112)};
    int left = viewport()->width() - theme.px(320);  // for the titles
    for (const auto& [column, width] : kWidths) left -= theme.px(width);
    for (const auto& [column, width] : kWidths) {
        setColumnWidth(column, theme.px(width));
        const bool goes = left < 0 && (column == Bound || column == EndsIn || column == Ours);
        if (goes) left += theme.px(width);
        setColumnHidden(column, goes);
    }
}

void CheckCases::resizeEvent(QResizeEvent* event) {
    QTableWidget::resizeEvent(event);
    layOut();
}

void CheckCases::setCases(const CheckResults& results, std::optional<pipeline::check::Group> group) {
    const QSignalBlocker quiet(this);
    const auto table = pipeline::check::caseTable();
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < table.size(); ++i)
        if (!group || table[i].group == *group) order.push_back(i);
    std::ranges::stable_sort(order,
                             [&](std::size_t a, std::size_t b) { return breaks(results[a]) > breaks(results[b]); });
    clearContents();
    setRowCount(int(order.size()));
    for (int row = 0; row < rowCount(); ++row) {
        auto* id = new QTableWidgetItem;
        id->setData(kCase, qulonglong(order[std::size_t(row)]));
        setItem(row, Id, id);
        fill(row, results[order[std::size_t(row)]]);
    }
}

void CheckCases::setResult(std::size_t which, const CaseResult& result) {
    const QSignalBlocker quiet(this);
    if (const int row = rowOf(which); row >= 0) fill(row, result);
}

void CheckCases::fill(int row, const std::optional<CaseResult>& result) {
    const Theme& theme = Theme::current();
    const ThemeColors& c = theme.colors();
    const Case& which = pipeline::check::caseTable()[caseIn(row)];
    const auto set = [&](Column column, const QString& text, const QColor& color, bool number) {
        if (!item(row, column)) setItem(row, column, new QTableWidgetItem);
        QTableWidgetItem* cell = item(row, column);
        cell->setText(text);
        cell->setToolTip(text);
        cell->setForeground(color);
        cell->setFont(number || column == Id ? theme.mono(12) : theme.text(13));
        cell->setTextAlignment((number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    };
    set(Id, toQString(which.id), c.text, false);
    set(Title, toQString(which.title), c.text, false);
    item(row, Title)->setToolTip(toQString(which.title) + '\n' + toQString(which.input));
    set(Naive, result ? toQString(result->naiveText()) : QString(), c.failed, true);
    set(Ours, result ? toQString(result->oursText()) : QString(), c.text, true);
    set(Bound, toQString(pipeline::check::measured(which.bound, which.unit)), c.text2, true);
    set(EndsIn, toQString(name(which.outcome)), c.text2, false);
    if (!result)
        set(Verdict, tr("not run"), c.text3, false);
    else if (result->holds)
        set(Verdict, QStringLiteral("●"), c.run, false);
    else
        set(Verdict, QStringLiteral("▲"), c.failed, false);
    if (!result) return;
    // The mark alone: the names of the cases have the room.
    item(row, Verdict)->setToolTip(result->holds ? tr("holds") : tr("breaks: %1").arg(toQString(result->reason)));
    item(row, Verdict)->setData(Qt::AccessibleTextRole, result->holds ? tr("holds") : tr("breaks"));
}

std::size_t CheckCases::caseIn(int row) const { return std::size_t(item(row, Id)->data(kCase).toULongLong()); }

int CheckCases::rowOf(std::size_t which) const {
    for (int row = 0; row < rowCount(); ++row)
        if (caseIn(row) == which) return row;
    return -1;
}

void CheckCases::select(std::size_t which) {
    const QSignalBlocker quiet(this);
    if (const int row = rowOf(which); row >= 0) setCurrentCell(row, 0);
}

void CheckCases::keyPressEvent(QKeyEvent* event) {
    const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (enter && currentRow() >= 0) return emit openAsked(caseIn(currentRow()));
    QTableWidget::keyPressEvent(event);
}

}  // namespace app
