#include "app/tables/table_page.h"

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QShortcut>
#include <QVBoxLayout>
#include <algorithm>

#include "app/look/number_format.h"
#include "app/look/numbers.h"
#include "app/look/text.h"
#include "app/widgets/follow_theme.h"
#include "app/widgets/padded_cells.h"

namespace app {

using pipeline::TableFormat;

TablePage::TablePage(Document& document, pipeline::TableId table, QWidget* parent)
    : QWidget(parent), m_document(document), m_table(table), m_model(new TableModel(this)) {
    build();
    connect(&document, &Document::sceneOpened, this, [this] {
        m_shown.reset();
        m_model->clear();
    });
    connect(&document, &Document::sceneChanged, this, &TablePage::want);
    connect(&document.frames(), &FrameFeed::frameReady, this, &TablePage::refresh);
    connect(&NumberStyle::current(), &NumberStyle::changed, this, [this] {
        if (m_shown) fitColumns();
    });
    connect(&document.pointing(), &Pointing::selectionChanged, this, &TablePage::markRows);
    connect(&document.pointing(), &Pointing::pixelChanged, this, &TablePage::markRows);
    connect(&document.pointing(), &Pointing::hoverChanged, this, [this] {
        if (m_shown && isVisible())
            m_model->setPointed(lessons::rowsOf(*m_shown, m_table, {}, m_document.pointing().hovered()));
    });
    connect(m_view->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& now) { choose(now.row()); });
    // The row that is current already may have lost its mark to a picked pixel.
    connect(m_view, &QTableView::clicked, this, [this](const QModelIndex& at) { choose(at.row()); });
    connect(m_view, &QTableView::customContextMenuRequested, this, &TablePage::showMenu);
    connect(new QShortcut(QKeySequence::Copy, m_view, nullptr, nullptr, Qt::WidgetShortcut), &QShortcut::activated,
            this, [this] { copy(TableFormat::Csv); });
    followTheme(this, [this] {
        const Theme& theme = Theme::current();
        m_facts->setFont(theme.mono(12));
        m_remarks->setFont(theme.text(12));
        layout()->setContentsMargins(theme.px(12), theme.px(6), theme.px(12), theme.px(4));
        layout()->setSpacing(theme.px(4));
        m_view->verticalHeader()->setDefaultSectionSize(theme.px(28));
        fitColumns();
    });
}

void TablePage::build() {
    m_facts = styled(new QLabel(this), {.tone = 2, .wraps = true});
    m_facts->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_remarks = styled(new QLabel(this), {.tone = 3, .wraps = true});
    m_view = new QTableView(this);
    m_view->setTabKeyNavigation(false);  // else nothing leads out of it
    m_view->setModel(m_model);
    m_view->setItemDelegate(new PaddedCells(m_view));
    m_view->setAccessibleName(tr("Table of %1").arg(toQString(name(m_table))));
    m_view->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_view->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_view->setContextMenuPolicy(Qt::CustomContextMenu);
    m_view->setShowGrid(false);
    m_view->setWordWrap(false);
    m_view->setCornerButtonEnabled(false);
    m_view->setMinimumHeight(0);
    // One height for all: nobody measures a million rows.
    m_view->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    m_view->verticalHeader()->hide();
    m_view->horizontalHeader()->setHighlightSections(false);
    m_view->horizontalHeader()->setSortIndicator(-1, Qt::AscendingOrder);
    m_view->horizontalHeader()->setSortIndicatorClearable(true);
    m_view->setSortingEnabled(true);
    // Another table stands in its own order.
    connect(m_view->model(), &QAbstractItemModel::modelReset, m_view->horizontalHeader(),
            [this] { m_view->horizontalHeader()->setSortIndicator(-1, Qt::AscendingOrder); });
    auto* column = new QVBoxLayout(this);
    column->addWidget(m_facts);
    column->addWidget(m_view, 1);
    column->addWidget(m_remarks);
}

void TablePage::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    want();
    refresh();
}

void TablePage::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    want();
}

void TablePage::want() {
    const bool shows = m_document.hasScene() && isVisible();
    m_document.frames().want(this, shows ? tableBuffers(m_document.scene(), m_table) : pipeline::BufferSet());
}

QString TablePage::facts() const { return m_facts->text(); }
void TablePage::setShowsFacts(bool shown) { m_facts->setVisible(shown); }

// Only the page on show follows the frames.
void TablePage::refresh() {
    const pipeline::FramePtr& frame = m_document.frames().shown();
    if (!frame || !isVisible() || frame == m_shown) return;
    const bool first = m_shown == nullptr;
    m_shown = frame;
    m_model->setTable(sceneTable(frame, m_table));
    QStringList facts;
    for (const pipeline::TableFact& fact : m_model->table().facts)
        facts << QString("%1 = %2").arg(toQString(fact.heading()), toQString(pipeline::readableText({}, fact.value)));
    m_facts->setText(facts.join("   "));
    emit factsChanged();
    m_remarks->setText(m_model->remarks());
    m_remarks->setVisible(!m_remarks->text().isEmpty());
    if (first) fitColumns();
    markRows();
    if (first) QTimer::singleShot(0, this, &TablePage::markRows);  // once the rows have their places
}

// Wide enough for the headings and for rows from the first to the last: numbers grow, and signs come and go. What is
// longer between them can be drawn wider.
void TablePage::fitColumns() {
    constexpr int kLooked = 400;
    const int rows = m_model->rowCount(), looked = std::min(rows, kLooked);
    const Theme& theme = Theme::current();
    QFont heads = theme.mono(13);
    heads.setWeight(QFont::DemiBold);
    const QFontMetrics digits(theme.mono(13)), bold(heads);
    for (int c = 0; c < m_model->columnCount(); ++c) {
        int width = bold.horizontalAdvance(m_model->headerData(c, Qt::Horizontal, Qt::DisplayRole).toString());
        for (int i = 0; i < looked; ++i) {
            const int row = looked == rows ? i : int(qint64(i) * (rows - 1) / (looked - 1));
            width = std::max(
                width, digits.horizontalAdvance(m_model->data(m_model->index(row, c), Qt::DisplayRole).toString()));
        }
        m_view->setColumnWidth(c, std::min(width, theme.px(260)) + theme.px(26));
    }
}

void TablePage::markRows() {
    if (!m_shown || !isVisible()) return;
    const auto rows =
        lessons::rowsOf(*m_shown, m_table, m_document.pointing().selection(), m_document.pointing().pixel());
    m_marks = true;
    QItemSelection chosen;
    for (const std::uint32_t row : rows) {
        const QModelIndex at = m_model->index(m_model->placeOf(row), 0);
        chosen.select(at, at);
    }
    auto* selection = m_view->selectionModel();
    // Rows that the reader has chosen several of, to copy them, stay while the frame changes.
    const bool keeps = !chosen.isEmpty() && selection->selectedRows().size() > 1 && chosen.size() == 1 &&
                       selection->isSelected(chosen.indexes().front());
    if (!keeps) {
        selection->select(chosen, QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
        if (!chosen.isEmpty()) {
            selection->setCurrentIndex(chosen.indexes().front(), QItemSelectionModel::NoUpdate);
            m_view->scrollTo(chosen.indexes().front().siblingAtColumn(m_view->columnAt(0)));
        }
    }
    m_marks = false;
}

void TablePage::choose(int place) {
    if (m_marks || place < 0 || place >= m_model->rowCount()) return;
    m_document.pointing().select(lessons::selectionOf(m_table, m_model->rowAt(place)));
}

std::vector<int> TablePage::chosenPlaces() const {
    std::vector<int> places;
    for (const QModelIndex& index : m_view->selectionModel()->selectedRows()) places.push_back(index.row());
    return places;
}

void TablePage::copy(TableFormat format) {
    const std::vector<int> places = chosenPlaces();
    if (places.empty()) return;
    QApplication::clipboard()->setText(m_model->text(places, format));
    const QString words[]{tr("text"), tr("CSV"), tr("Markdown"), tr("LaTeX"), tr("NumPy")};
    const QString rows = places.size() == 1 ? tr("1 row") : tr("%1 rows").arg(count(qint64(places.size())));
    emit m_document.said(tr("Copied %1 as %2.").arg(rows, words[std::size_t(format)]));
}

void TablePage::showMenu(QPoint at) {
    QMenu menu(this);
    const bool any = m_view->selectionModel()->hasSelection();
    const auto add = [&](const QString& words, TableFormat format) {
        QAction* action = menu.addAction(words, this, [this, format] { copy(format); });
        action->setEnabled(any);
        return action;
    };
    add(tr("Copy as CSV\tCtrl+C"), TableFormat::Csv);
    add(tr("Copy as Markdown"), TableFormat::Markdown);
    add(tr("Copy as LaTeX"), TableFormat::Latex);
    add(tr("Copy as NumPy"), TableFormat::NumPy);
    menu.addSeparator();
    menu.addAction(tr("Select all\tCtrl+A"), m_view, &QTableView::selectAll);
    menu.exec(m_view->viewport()->mapToGlobal(at));
}

}  // namespace app
